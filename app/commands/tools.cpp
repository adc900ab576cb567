// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/library_command.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/base/resource_folder.h"
#include "core/base/units.h"
#include "core/job/tool_shape.h"
#include "core/tool/tool_exchange.h"
#include "core/tool/tool_library.h"
#include "core/tool/tool_ranges.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace burin {

namespace {

using nlohmann::json;

json briefOf(const Tool& tool) {
    return {{"id", tool.id},
            {"name", tool.name},
            {"own", !isShippedTool(tool.id)},
            {"number", tool.number},
            {"type", cutterTypeName(tool.cutter.type)},
            {"diameter_mm", tool.cutter.diameter},
            {"flute_length_mm", tool.cutter.fluteLength}};
}

int listTools(const LibraryArguments&, CommandContext& context) {
    json tools = json::array();
    std::string text;
    int status = 0;
    for (const std::string& id : toolIds()) {
        const Result<Tool> tool = loadTool(id);
        if (!tool) { // the others can still be used
            status = context.fail(tool.error());
            continue;
        }
        tools.push_back(briefOf(*tool));
        text += (text.empty() ? "" : "\n") + id + std::string(id.size() < 20 ? 20 - id.size() : 1, ' ') +
                worded(isShippedTool(id) ? BURIN_TEXT("Command", "shipped  T%1  %2 mm  %3")
                                         : BURIN_TEXT("Command", "own      T%1  %2 mm  %3"),
                       {std::to_string(tool->number), formatShortest(tool->cutter.diameter), resourceName(tool->name)});
    }
    if (status == 0) context.answer({{"tools", tools}}, text);
    return status;
}

int showTool(const LibraryArguments& arguments, CommandContext& context) {
    const Result<Tool> tool = loadTool(arguments.id);
    if (!tool) return context.fail(tool.error());
    std::string text = toJson(*tool);
    text.pop_back(); // `answer` adds the line end
    context.answer(json::parse(text), text);
    return 0;
}

int keepTool(const Tool& tool, bool replace, CommandContext& context, json more = json::object(),
             const std::string& notes = {}) {
    const Result<std::filesystem::path> file = saveTool(tool, replace);
    if (!file) return context.fail(file.error());
    more.update(briefOf(tool));
    more["file"] = file->string();
    context.answer(more, tool.id + ": " + file->string() + notes);
    return 0;
}

constexpr const char* usualTool = "flat-6"; ///< supplies values that a file of another program lacks

std::string linesOf(const std::vector<std::string>& notes) {
    std::string lines;
    for (const std::string& note : notes) lines += "\n  " + note;
    return lines;
}

int addTool(const LibraryArguments& arguments, CommandContext& context) {
    const Result<std::string> text = readFile(arguments.file);
    if (!text) return context.fail(text.error());
    const Result<Tool> like = loadTool(usualTool);
    if (!like) return context.fail(like.error());
    const Result<ReadTool> read = toolFromText(*text, arguments.file, *like);
    return read ? keepTool(read->tool, arguments.replace, context, {{"notes", read->notes}}, linesOf(read->notes))
                : context.fail(read.error());
}

int copyTool(const LibraryArguments& arguments, CommandContext& context) {
    const Result<Tool> tool = loadTool(arguments.id);
    if (!tool) return context.fail(tool.error());
    const std::string& name = arguments.name.empty() ? arguments.newId : arguments.name;
    Tool copy = copyOf(*tool, arguments.newId, name);
    std::vector<Tool> tools;
    for (const std::string& id : toolIds())
        if (Result<Tool> each = loadTool(id); each && id != arguments.newId) tools.push_back(std::move(*each));
    copy.number = freeToolNumber(tools);
    return keepTool(copy, arguments.replace, context);
}

int deleteTool(const LibraryArguments& arguments, CommandContext& context) {
    if (const Result<void> removed = removeTool(arguments.id); !removed) return context.fail(removed.error());
    context.answer({{"removed", arguments.id}}, worded(BURIN_TEXT("Command", "%1: removed"), {arguments.id}));
    return 0;
}

struct ImportArguments {
    std::string file, like = usualTool, units = "mm";
    bool replace = false, dryRun = false;
};

/// Shipped tools are not replaced: a tool with the id of one gets a number appended to its id.
void keepClearOfShipped(ReadTools& read) {
    for (ReadTool& tool : read.tools)
        tool.tool.id = freeResourceId(tool.tool.id, [&](const std::string& id) {
            const auto has = [&](const ReadTool& other) { return &other != &tool && other.tool.id == id; };
            return isShippedTool(id) || std::ranges::any_of(read.tools, has);
        });
}

/// Refuses to store any tool if one of them cannot be stored. Errors: argumentInvalid.
Result<void> mayBeKept(const ReadTools& read, bool replace) {
    for (const ReadTool& tool : read.tools)
        if (isOfUser(toolResource, tool.tool.id) && !replace)
            return Error{ErrorCode::argumentInvalid, "tool", tool.tool.id,
                         worded(BURIN_TEXT("Command", "an ID that is free, or --replace for one of your own"))};
    return {};
}

/// Stores all tools, or restores the previous ones if one cannot be written. Errors: those of saveTool.
Result<void> keepAll(const ReadTools& read) {
    std::vector<std::pair<std::string, std::optional<Tool>>> before;
    for (const ReadTool& tool : read.tools) {
        Result<Tool> own = isOfUser(toolResource, tool.tool.id) ? loadTool(tool.tool.id) : Result<Tool>(Error{});
        const auto saved = saveTool(tool.tool, true);
        if (saved) {
            before.emplace_back(tool.tool.id, own ? std::optional(std::move(*own)) : std::nullopt);
            continue;
        }
        for (const auto& [id, former] : before) // a failure to restore is covered by the same error
            if (former)
                static_cast<void>(saveTool(*former, true));
            else
                static_cast<void>(removeTool(id));
        return saved.error();
    }
    return {};
}

int importTools(const ImportArguments& arguments, CommandContext& context) {
    const Result<Tool> like = loadTool(arguments.like);
    if (!like) return context.fail(like.error());
    Result<ReadTools> read = toolsFromFile(arguments.file, *like, arguments.units == "inch" ? millimetresPerInch : 1.0);
    if (!read) return context.fail(read.error());
    keepClearOfShipped(*read);
    if (const Result<void> free = mayBeKept(*read, arguments.replace); !free) return context.fail(free.error());
    if (!arguments.dryRun)
        if (const Result<void> kept = keepAll(*read); !kept) return context.fail(kept.error());
    json tools = json::array();
    std::string text;
    for (const ReadTool& tool : read->tools) {
        json brief = briefOf(tool.tool);
        brief["notes"] = tool.notes;
        tools.push_back(std::move(brief));
        text += (text.empty() ? "" : "\n") + tool.tool.id + ": T" + std::to_string(tool.tool.number) + ", " +
                formatShortest(tool.tool.cutter.diameter) + " mm" + linesOf(tool.notes);
    }
    context.answer({{"tools", tools}, {"left_out", read->leftOut}},
                   text + (read->leftOut.empty()
                               ? std::string()
                               : "\n" + worded(BURIN_TEXT("Command", "left out:")) + linesOf(read->leftOut)));
    return 0;
}

void registerToolImport(CommandParser tools, CommandContext& context, int& status) {
    auto arguments = std::make_shared<ImportArguments>();
    const CommandParser imports = tools.command(
        "import", BURIN_TEXT("Help", "Add tools of another program to your own: a Fusion library (*.tools, *.json), a "
                                     "FreeCAD library or bit (*.fctl, *.fctb), a CAMotics table (*.ctbl), a LinuxCNC "
                                     "table (*.tbl). What can't be held is listed"));
    imports.passOn();
    imports.positional(BURIN_TEXT("Argument", "FILE"), arguments->file, BURIN_TEXT("Help", "File to read")).required();
    imports
        .option("--like", arguments->like,
                BURIN_TEXT("Help", "Tool that lends what the file does not say: holder, stick-out, limits; of a "
                                   "LinuxCNC table the form"))
        .showDefault();
    imports.option("--units", arguments->units, BURIN_TEXT("Help", "Unit of a LinuxCNC table, which states none"))
        .choices({"mm", "inch"});
    imports.flag("--replace", arguments->replace, BURIN_TEXT("Help", "Replace your own tools of these IDs"));
    imports.flag("--dry-run", arguments->dryRun, BURIN_TEXT("Help", "List what would be added; keep nothing"));
    imports.run([arguments, &context, &status] { status = importTools(*arguments, context); });
}

struct ExportArguments {
    std::vector<std::string> ids;
    std::string file;
    std::string units = "mm";
};

int exportTools(const ExportArguments& arguments, CommandContext& context) {
    std::vector<Tool> tools;
    for (const std::string& id : arguments.ids.empty() ? toolIds() : arguments.ids) {
        Result<Tool> tool = loadTool(id);
        if (!tool) return context.fail(tool.error());
        tools.push_back(std::move(*tool));
    }
    const Result<WrittenTools> written = toolsFor(arguments.file, tools.size() == 1 ? tools.front().id : std::string(),
                                                  tools, arguments.units == "inch" ? millimetresPerInch : 1.0);
    if (!written) return context.fail(written.error());
    if (const Result<void> done = writeFileAtomically(arguments.file, written->text); !done)
        return context.fail(done.error());
    context.answer({{"file", arguments.file}, {"tools", tools.size()}, {"notes", written->notes}},
                   arguments.file + linesOf(written->notes));
    return 0;
}

void registerExport(CommandParser tools, CommandContext& context, int& status) {
    auto arguments = std::make_shared<ExportArguments>();
    const CommandParser exports = tools.command(
        "export", BURIN_TEXT("Help", "Write tools for other programs: a LinuxCNC tool table (*.tbl), a Fusion "
                                     "library (*.tools), a CAMotics table (*.ctbl), a FreeCAD tool bit (*.fctb), or "
                                     "Burin's own form (*.json)"));
    exports.passOn();
    exports.positional(BURIN_TEXT("Argument", "ID"), arguments->ids, BURIN_TEXT("Help", "Tools (default: all)"));
    exports.option("-o,--output", arguments->file, BURIN_TEXT("Help", "File to write")).required();
    exports.option("--units", arguments->units, BURIN_TEXT("Help", "Unit of the machine that reads the table"))
        .choices({"mm", "inch"});
    exports.run([arguments, &context, &status] { status = exportTools(*arguments, context); });
}

struct ShapeArguments {
    std::string id, flutes, shank, like, name;
    double tolerance = 0.005;
    double fileUnit = 1.0;
    int number = 0; ///< 0: that of `like`
    bool replace = false, fixed = false;
    double angle = 0.0; ///< degrees
};

int shapeTool(const ShapeArguments& arguments, CommandContext& context) {
    Result<Tool> like = loadTool(arguments.like);
    if (!like) return context.fail(like.error());
    if (arguments.number > 0) like->number = arguments.number;
    ToolShapeRequest request;
    request.flutes = arguments.flutes;
    request.shank = arguments.shank;
    request.like = *like;
    request.id = arguments.id;
    request.name = arguments.name.empty() ? arguments.id : arguments.name;
    request.tolerance = arguments.tolerance;
    request.import.fileUnit = arguments.fileUnit;
    request.turns = !arguments.fixed;
    request.angle = arguments.angle * pi / 180.0;
    if (request.turns && arguments.angle != 0.0)
        return context.fail({ErrorCode::argumentInvalid, "--angle", formatShortest(arguments.angle),
                             worded(BURIN_TEXT("Command", "no value, unless --fixed states that the tool does not "
                                                          "turn"))});
    context.stage(BURIN_TEXT("Command", "Importing"));
    const Result<ShapedTool> shaped = shapedTool(request, context.progress());
    if (!shaped) return context.fail(shaped.error());
    const Cutter& cutter = shaped->tool.cutter;
    return keepTool(
        shaped->tool, arguments.replace, context,
        {{"lift_mm", shaped->lift},
         {"excess_mm", shaped->excess},
         {"profile_lines", cutter.profile.size()},
         {"coarser_than_asked", shaped->coarser},
         {"turns", cutter.turns()}},
        "\n  " +
            worded(BURIN_TEXT("Command", "profile of %1 lines, at most %2 mm wider than what the flutes sweep in a "
                                         "turn, never narrower"),
                   {std::to_string(cutter.profile.size()), formatLimit(shaped->excess, 4)}) +
            (shaped->coarser
                 ? "\n  " + worded(BURIN_TEXT("Command", "coarser than --tolerance asks for: a finer profile "
                                                         "has more lines than a tool can have"))
                 : std::string()) +
            "\n  " +
            worded(BURIN_TEXT("Command", "moved along Z by %1 mm, so that the tip is at 0"),
                   {formatShortest(shaped->lift)}) +
            (cutter.turns()
                 ? std::string()
                 : "\n  " + worded(BURIN_TEXT("Command", "does not turn: the models cut and touch the stock, with X "
                                                         "at %1 degrees from X of the setup; the profile keeps them "
                                                         "out of the part"),
                                   {formatShortest(arguments.angle)})));
}

void registerShape(CommandParser tools, CommandContext& context, int& status) {
    auto arguments = std::make_shared<ShapeArguments>();
    const CommandParser shape = tools.command(
        "shape", BURIN_TEXT("Help", "Make a tool of models of its flutes and its shank: what they sweep while the "
                                    "spindle turns. Axis +Z through the origin, towards the holder"));
    shape.passOn();
    shape.positional(BURIN_TEXT("Argument", "ID"), arguments->id, BURIN_TEXT("Help", "ID of the new tool")).required();
    shape
        .positional(BURIN_TEXT("Argument", "FLUTES"), arguments->flutes,
                    BURIN_TEXT("Help", "STEP, IGES, BREP or mesh file of the flutes, closed"))
        .required();
    shape.option("--shank", arguments->shank,
                 BURIN_TEXT("Help", "The same of the shank (default: the shank of --like)"));
    shape
        .option("--like", arguments->like,
                BURIN_TEXT("Help", "Tool from which the new one takes number, teeth, limits and holder"))
        .required();
    shape.option("--name", arguments->name, BURIN_TEXT("Help", "Name of the tool (default: its ID)"));
    shape.option("--number", arguments->number, BURIN_TEXT("Help", "T word (default: that of --like)"))
        .range(1, tool_range::highestNumber);
    shape
        .option("--tolerance", arguments->tolerance,
                BURIN_TEXT("Help", "Distance of the profile from what the flutes sweep, mm, at most; more where 48 "
                                   "lines don't do"))
        .range(1e-4, 1.0)
        .showDefault();
    shape
        .option("--file-unit,--stl-unit", arguments->fileUnit,
                BURIN_TEXT("Help", "Millimetres per unit of a file that states none (STL, OBJ, PLY, OFF)"))
        .range(1e-6, 1e6)
        .showDefault();
    shape.flag("--fixed", arguments->fixed,
               BURIN_TEXT("Help", "The tool does not turn (scraper, planing blade): the models themselves cut, and the "
                                  "profile only keeps them out of the part"));
    shape
        .option("--angle", arguments->angle,
                BURIN_TEXT("Help", "With --fixed: angle from X of the setup to X of the models, degrees, "
                                   "counterclockwise seen from above"))
        .range(-360.0, 360.0);
    shape.flag("--replace", arguments->replace, BURIN_TEXT("Help", "Replace your tool of this ID"));
    shape.run([arguments, &context, &status] { status = shapeTool(*arguments, context); });
}

} // namespace

void registerTools(CommandParser program, CommandContext& context, int& status) {
    const CommandParser tools = registerLibrary(
        program, context, status,
        {"tools",
         BURIN_TEXT("Help", "List and show tools; copy, add and delete your own, and make them of "
                            "models. Every tool states the source of its values"),
         BURIN_TEXT("Help", "List all tools with their numbers and diameters"),
         BURIN_TEXT("Help", "Print the file of a tool (JSON), in the form that add reads"),
         BURIN_TEXT("Help", "Add a tool to your own; every value is checked"),
         BURIN_TEXT("Help", "Tool file (JSON), or a FreeCAD tool bit (*.fctb)"),
         BURIN_TEXT("Help", "Copy a tool to one of your own"), BURIN_TEXT("Help", "Tool to copy"),
         BURIN_TEXT("Help", "Delete one of your own tools"), BURIN_TEXT("Help", "Replace your tool of this ID"),
         BURIN_TEXT("Help", "Tool"), &listTools, &showTool, &addTool, &copyTool, &deleteTool});
    registerShape(tools, context, status);
    registerToolImport(tools, context, status);
    registerExport(tools, context, status);
}

} // namespace burin
