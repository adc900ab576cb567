// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/commands/tool_commands.h"
#include "app/library_command.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/base/resource_folder.h"
#include "core/job/tool_shape.h"
#include "core/tool/tool_exchange.h"
#include "core/tool/tool_library.h"
#include "core/tool/tool_ranges.h"
#include "core/tool/tool_solid.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace burin {

using nlohmann::json;

json briefOf(const Tool& tool, const std::string& library) {
    json brief{{"id", tool.id},
               {"name", tool.name},
               {"own", !isShippedTool(tool.id)},
               {"library", library},
               {"number", tool.number},
               {"type", cutterTypeName(tool.cutter.type)},
               {"diameter_mm", tool.cutter.diameter},
               {"flute_length_mm", tool.cutter.fluteLength}};
    if (tool.cutter.isHollow()) {
        brief["hollow_width_mm"] = tool.cutter.solid->hollowWidth;
        brief["hollow_depth_mm"] = tool.cutter.solid->hollowDepth;
    }
    return brief;
}

std::string linesOf(const std::vector<std::string>& notes) {
    std::string lines;
    for (const std::string& note : notes) lines += "\n  " + note;
    return lines;
}

Result<ToolLibraries> librariesWith(const std::string& chosen) {
    Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries || chosen.empty() || chosen == allTools || chosen == starterLibrary) return libraries;
    const Result<void> known = checkOwnLibrary(*libraries, chosen);
    return known ? libraries : Result<ToolLibraries>(known.error());
}

std::vector<std::string> listedIds(const ToolLibraries& libraries, const std::string& library) {
    std::vector<std::string> ids = toolIds();
    if (!library.empty()) std::erase_if(ids, [&](const std::string& id) { return !libraries.isIn(id, library); });
    return ids;
}

Result<Tool> listedTool(const std::string& id, const std::string& library) {
    const Result<ToolLibraries> libraries = librariesWith(library);
    if (!libraries) return libraries.error();
    Result<Tool> tool = loadTool(id);
    if (!tool || library.empty() || libraries->isIn(id, library)) return tool;
    return Error{ErrorCode::nameUnknown, "tool", id, listed(listedIds(*libraries, library))};
}

int keepTool(const Tool& tool, bool replace, const std::string& library, CommandContext& context, json more,
             const std::string& notes) {
    const Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) return context.fail(libraries.error());
    std::string target = library;
    if (target.empty())
        target = isOfUser(toolResource, tool.id) ? libraries->libraryOf(tool.id) : std::string(ownLibrary);
    if (const Result<void> own = checkOwnLibrary(*libraries, target); !own) return context.fail(own.error());
    const Result<std::filesystem::path> file = saveTool(tool, replace);
    if (!file) return context.fail(file.error());
    if (const Result<void> put = putTool(tool.id, target); !put) return context.fail(put.error());
    more.update(briefOf(tool, target));
    more["file"] = file->string();
    context.answer(more, tool.id + ": " + file->string() + notes);
    return 0;
}

namespace {

int listTools(const LibraryArguments& arguments, CommandContext& context) {
    const Result<ToolLibraries> libraries = librariesWith(arguments.library);
    if (!libraries) return context.fail(libraries.error());
    json tools = json::array();
    std::string text;
    int status = 0;
    for (const std::string& id : listedIds(*libraries, arguments.library)) {
        const Result<Tool> tool = loadTool(id);
        if (!tool) { // the others can still be used
            status = context.fail(tool.error());
            continue;
        }
        const std::string library = libraries->libraryOf(id);
        tools.push_back(briefOf(*tool, library));
        text +=
            (text.empty() ? "" : "\n") + id + std::string(id.size() < 20 ? 20 - id.size() : 1, ' ') +
            worded(isShippedTool(id) ? BURIN_TEXT("Command", "shipped  T%1  %2 mm  %3")
                                     : BURIN_TEXT("Command", "own      T%1  %2 mm  %3"),
                   {std::to_string(tool->number), formatShortest(tool->cutter.diameter), resourceName(tool->name)}) +
            (libraries->contains(library) ? "  [" + library + "]" : "");
    }
    if (status == 0) context.answer({{"tools", tools}}, text);
    return status;
}

int showTool(const LibraryArguments& arguments, CommandContext& context) {
    const Result<Tool> tool = listedTool(arguments.id, arguments.library);
    if (!tool) return context.fail(tool.error());
    std::string text = toJson(*tool);
    text.pop_back(); // `answer` adds the line end
    context.answer(json::parse(text), text);
    return 0;
}

int addTool(const LibraryArguments& arguments, CommandContext& context) {
    const Result<std::string> text = readFile(arguments.file);
    if (!text) return context.fail(text.error());
    const Result<Tool> like = loadTool(usualTool);
    if (!like) return context.fail(like.error());
    const Result<ReadTool> read = toolFromText(*text, arguments.file, *like);
    return read ? keepTool(read->tool, arguments.replace, arguments.library, context, {{"notes", read->notes}},
                           linesOf(read->notes))
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
    return keepTool(copy, arguments.replace, arguments.library, context);
}

int deleteTool(const LibraryArguments& arguments, CommandContext& context) {
    if (!arguments.library.empty())
        if (const Result<Tool> tool = listedTool(arguments.id, arguments.library); !tool)
            return context.fail(tool.error());
    if (const Result<void> removed = removeTool(arguments.id); !removed) return context.fail(removed.error());
    if (const Result<void> put = putTool(arguments.id, std::string(ownLibrary)); !put) return context.fail(put.error());
    context.answer({{"removed", arguments.id}}, worded(BURIN_TEXT("Command", "%1: removed"), {arguments.id}));
    return 0;
}

struct ShapeArguments {
    std::shared_ptr<const LibraryArguments> tools;
    std::string id, flutes, shank, like, name;
    double tolerance = 0.005;
    double fileUnit = 1.0;
    int number = 0; ///< 0: that of `like`
    bool replace = false, fixed = false;
    double angle = 0.0; ///< degrees
};

/// A line about the hollow of a tool; empty if it has none.
std::string hollowLine(const ShapedTool& shaped) {
    if (!shaped.tool.cutter.isHollow()) return {};
    const ToolSolid& solid = *shaped.tool.cutter.solid;
    return "\n  " +
           worded(BURIN_TEXT("Command", "hollow, %1 mm in diameter and %2 mm deep (at most %3 mm narrower than "
                                        "the model): a core stands in it; the tool stays upright"),
                  {formatFixed(solid.hollowWidth, 2), formatFixed(solid.hollowDepth, 2),
                   formatLimit(shaped.hollowExcess, 4)});
}

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
    request.angle = glm::radians(arguments.angle);
    if (request.turns && arguments.angle != 0.0)
        return context.fail({ErrorCode::argumentInvalid, "--angle", formatShortest(arguments.angle),
                             worded(BURIN_TEXT("Command", "no value, unless --fixed states that the tool does not "
                                                          "turn"))});
    context.stage(BURIN_TEXT("Command", "Importing"));
    const Result<ShapedTool> shaped = shapedTool(request, context.progress());
    if (!shaped) return context.fail(shaped.error());
    const Cutter& cutter = shaped->tool.cutter;
    json more{{"lift_mm", shaped->lift},
              {"excess_mm", shaped->excess},
              {"profile_lines", cutter.profile.size()},
              {"coarser_than_asked", shaped->coarser},
              {"turns", cutter.turns()}};
    if (cutter.isHollow()) more["hollow_excess_mm"] = shaped->hollowExcess;
    return keepTool(
        shaped->tool, arguments.replace, arguments.tools->library, context, std::move(more),
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
            hollowLine(*shaped) +
            (cutter.turns()
                 ? std::string()
                 : "\n  " + worded(BURIN_TEXT("Command", "does not turn: the models cut and touch the stock, with X "
                                                         "at %1 degrees from X of the setup; the profile keeps them "
                                                         "out of the part"),
                                   {formatShortest(arguments.angle)})));
}

void registerShape(CommandParser tools, std::shared_ptr<const LibraryArguments> chosen, CommandContext& context,
                   int& status) {
    auto arguments = std::make_shared<ShapeArguments>();
    arguments->tools = std::move(chosen);
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
    const auto arguments = std::make_shared<LibraryArguments>();
    const CommandParser tools = registerLibrary(
        program, context, status,
        {"tools",
         BURIN_TEXT("Help", "List and show tools; copy, add and delete your own, and make them of "
                            "models. Tools form libraries. Every tool states the source of its values"),
         BURIN_TEXT("Help", "List all tools with their numbers and diameters"),
         BURIN_TEXT("Help", "Print the file of a tool (JSON), in the form that add reads"),
         BURIN_TEXT("Help", "Add a tool to your own; every value is checked"),
         BURIN_TEXT("Help", "Tool file (JSON), or a FreeCAD tool bit (*.fctb)"),
         BURIN_TEXT("Help", "Copy a tool to one of your own"), BURIN_TEXT("Help", "Tool to copy"),
         BURIN_TEXT("Help", "Delete one of your own tools"), BURIN_TEXT("Help", "Replace your tool of this ID"),
         BURIN_TEXT("Help", "Tool"), &listTools, &showTool, &addTool, &copyTool, &deleteTool},
        arguments);
    tools.option("--library", arguments->library,
                 BURIN_TEXT("Help", "Tool library: all, starter (what Burin is shipped with), mine (your own tools "
                                    "that are in no other), or one that you have named (default: all; of new tools "
                                    "mine)"));
    registerShape(tools, arguments, context, status);
    registerToolExchange(tools, arguments, context, status);
    registerToolLibraries(tools, arguments, context, status);
    registerToolPreset(tools, arguments, context, status);
}

} // namespace burin
