// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/document/companions.h"
#include "core/job/sheet_content.h"
#include "ui/sheet/setup_sheet.h"

#include <array>
#include <filesystem>

namespace burin {

namespace {

struct SheetArguments {
    std::string project, output, units;
};

Result<std::string> sheetOf(const SheetArguments& arguments, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return project.error();
    Result<SheetSource> source = sheetSource(*project, arguments.project);
    if (!source) return std::move(source).error();
    const NcUnits units = ncUnitsFromId(arguments.units).value_or(source->units);
    context.stage(BURIN_TEXT("Command", "Embedding"));
    const Result<SheetContent> content = sheetContent(std::move(*source), context.progress());
    if (!content) return content.error();
    context.stage(BURIN_TEXT("Command", "Drawing"));
    Result<PictureDrawing> drawing = PictureDrawing::begin(sheetPicture(*content));
    if (!drawing) return drawing.error();
    drawing->wait();
    std::vector<std::string> pictures;
    for (const StandardView view : sheetViews) pictures.push_back(drawing->draw(view));
    return setupSheet(*content, units == NcUnits::inch ? LengthUnit::inch : LengthUnit::millimetre, pictures);
}

int runSheet(const SheetArguments& arguments, CommandContext& context) {
    const std::array<std::filesystem::path, 1> inputs{arguments.project};
    if (const Result<void> free = checkOutput("--output", arguments.output, inputs); !free)
        return context.fail(free.error());
    const Result<std::string> page = sheetOf(arguments, context);
    if (!page) return context.fail(page.error());
    if (const Result<void> written = writeFileAtomically(arguments.output, *page); !written)
        return context.fail(written.error());
    const std::string file = std::filesystem::absolute(arguments.output).lexically_normal().string();
    context.answer({{"sheet", file}}, worded(BURIN_TEXT("Command", "setup sheet  %1"), {file}));
    return 0;
}

} // namespace

void registerSheet(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<SheetArguments>();
    const CommandParser command =
        program.command("sheet", BURIN_TEXT("Help", "Write the setup sheet of a project as one HTML page: pictures, "
                                                    "zero, stock, fixtures, tools, times and findings"));
    command
        .positional(BURIN_TEXT("Argument", "PROJECT"), arguments->project, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    command.option("-o,--output", arguments->output, BURIN_TEXT("Help", "Page to write (.html)")).required();
    command
        .option("--units", arguments->units,
                BURIN_TEXT("Help", "Units of the page: mm or inch (default: the program's)"))
        .choices({"mm", "inch"});
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runSheet(*arguments, context); });
}

} // namespace burin
