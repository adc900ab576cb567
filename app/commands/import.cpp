// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/import.h"
#include "app/command.h"
#include "app/report.h"
#include "app/unit_argument.h"

namespace burin {

namespace {

struct ImportArguments {
    std::string model, unit;
    double chord = 0.005;
    double fileUnit = 1.0;
    double seconds = 120.0;
    double memory = 4096.0;
};

int runImport(const ImportArguments& arguments, CommandContext& context) {
    ImportOptions options;
    options.meshChord = arguments.chord;
    options.fileUnit = arguments.fileUnit;
    if (const Result<void> applied = applyUnit(arguments.unit, options); !applied) return context.fail(applied.error());
    options.limits.waitSeconds *= arguments.seconds / options.limits.seconds;
    options.limits.seconds = arguments.seconds;
    options.limits.memoryBytes = static_cast<std::size_t>(arguments.memory * 1e6);
    context.stage(BURIN_TEXT("Command", "Importing"));
    const Result<Model> model = importModel(arguments.model, options, context.progress());
    if (!model) return context.fail(model.error());
    context.answer(jsonOf(*model), textOf(*model));
    return 0;
}

} // namespace

void registerImport(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<ImportArguments>();
    const CommandParser command =
        program.command("import", BURIN_TEXT("Help", "Read a CAD model and report its contents"));
    command
        .positional(BURIN_TEXT("Argument", "MODEL"), arguments->model,
                    BURIN_TEXT("Help", "STEP, IGES, BREP, STL, 3MF, OBJ, PLY, AMF or OFF file"))
        .required();
    command.option("--chord", arguments->chord, BURIN_TEXT("Help", "Chord of the mesh, mm"))
        .range(1e-4, 10.0)
        .showDefault();
    command
        .option("--file-unit,--stl-unit", arguments->fileUnit,
                BURIN_TEXT("Help", "Millimetres per unit of a file that states none (STL, OBJ, PLY, OFF)"))
        .range(1e-6, 1e6)
        .showDefault();
    addUnit(command, arguments->unit);
    command
        .option(
            "--seconds", arguments->seconds,
            BURIN_TEXT("Help", "Limit of the import's processor time, s; its elapsed time may be ten times as long"))
        .range(0.1, 86400.0)
        .showDefault();
    command.option("--memory", arguments->memory, BURIN_TEXT("Help", "Memory limit of the import, MB"))
        .range(64.0, 1e6)
        .showDefault();
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runImport(*arguments, context); });
}

} // namespace burin
