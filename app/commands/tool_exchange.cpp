// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool_exchange.h"
#include "app/commands/tool_commands.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/base/resource_folder.h"
#include "core/base/units.h"
#include "core/tool/tool_library.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

namespace burin {

namespace {

using nlohmann::json;

struct ToolImportArguments {
    std::shared_ptr<const LibraryArguments> tools;
    std::string file, like = usualTool, units = "mm";
    bool replace = false, dryRun = false;
};

/// The unit of a LinuxCNC table, mm. @param name argument of --units, for which the parser accepts mm and inch only
double tableUnit(const std::string& name) {
    return name == "inch" ? millimetresPerInch : 1.0;
}

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

/// Returns the library that tools of a file are put into: several tools into one that has the name of the file, a
/// single one where a tool of its id already is, else into ownLibrary. Errors: those of loadToolLibraries and
/// checkLibraryName.
Result<std::string> targetOf(const ToolImportArguments& arguments, const ReadTools& read) {
    const Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) return libraries.error();
    if (const std::string& stated = arguments.tools->library; !stated.empty()) {
        if (libraries->contains(stated) || stated == ownLibrary) return stated;
        const Result<void> valid = checkLibraryName(stated);
        return valid ? Result<std::string>(stated) : Result<std::string>(valid.error());
    }
    if (read.tools.size() == 1) return libraries->libraryOf(read.tools.front().tool.id); // one that is replaced stays
    const std::string stem = std::filesystem::path(arguments.file).stem().string();
    return arguments.replace && libraries->contains(stem) ? stem : freeLibraryName(*libraries, stem);
}

/// Stores all tools in a library, which is made if it does not exist. Errors: those of addToolLibrary, saveTool,
/// putTool.
Result<void> keepIn(const std::string& library, const ReadTools& read) {
    const Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) return libraries.error();
    const bool made = library != ownLibrary && !libraries->contains(library);
    if (made)
        if (Result<void> added = addToolLibrary(library); !added) return added;
    if (Result<void> kept = keepAll(read); !kept) {
        if (made) static_cast<void>(removeToolLibrary(library)); // a failure is covered by the same error
        return kept;
    }
    for (const ReadTool& tool : read.tools)
        if (Result<void> put = putTool(tool.tool.id, library); !put) return put;
    return {};
}

int importTools(const ToolImportArguments& arguments, CommandContext& context) {
    const Result<Tool> like = loadTool(arguments.like);
    if (!like) return context.fail(like.error());
    Result<ReadTools> read = toolsFromFile(arguments.file, *like, tableUnit(arguments.units));
    if (!read) return context.fail(read.error());
    keepClearOfShipped(*read);
    if (const Result<void> free = mayBeKept(*read, arguments.replace); !free) return context.fail(free.error());
    const Result<std::string> library = targetOf(arguments, *read);
    if (!library) return context.fail(library.error());
    if (!arguments.dryRun)
        if (const Result<void> kept = keepIn(*library, *read); !kept) return context.fail(kept.error());
    json tools = json::array();
    std::string text;
    for (const ReadTool& tool : read->tools) {
        json brief = briefOf(tool.tool, *library);
        brief["notes"] = tool.notes;
        tools.push_back(std::move(brief));
        text += (text.empty() ? "" : "\n") + tool.tool.id + ": T" + std::to_string(tool.tool.number) + ", " +
                formatShortest(tool.tool.cutter.diameter) + " mm" + linesOf(tool.notes);
    }
    if (*library != ownLibrary) text = worded(BURIN_TEXT("Command", "library \"%1\":"), {*library}) + "\n" + text;
    context.answer({{"library", *library}, {"tools", tools}, {"left_out", read->leftOut}},
                   text + (read->leftOut.empty()
                               ? std::string()
                               : "\n" + worded(BURIN_TEXT("Command", "left out:")) + linesOf(read->leftOut)));
    return 0;
}

void registerToolImport(CommandParser tools, std::shared_ptr<const LibraryArguments> chosen, CommandContext& context,
                        int& status) {
    auto arguments = std::make_shared<ToolImportArguments>();
    arguments->tools = std::move(chosen);
    const CommandParser imports = tools.command(
        "import",
        BURIN_TEXT("Help", "Add tools of another program to your own: a Fusion library (*.tools, *.json), a "
                           "FreeCAD library or bit (*.fctl, *.fctb), a CAMotics table (*.ctbl), a LinuxCNC "
                           "table (*.tbl). Several tools become a library that has the name of the file, or are "
                           "put into --library, which need not exist yet. What can't be held is listed"));
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

struct ToolExportArguments {
    std::shared_ptr<const LibraryArguments> tools;
    std::vector<std::string> ids;
    std::string file;
    std::string units = "mm";
};

int exportTools(const ToolExportArguments& arguments, CommandContext& context) {
    const std::string& library = arguments.tools->library;
    const Result<ToolLibraries> libraries = librariesWith(library);
    if (!libraries) return context.fail(libraries.error());
    std::vector<Tool> tools;
    for (const std::string& id : arguments.ids.empty() ? listedIds(*libraries, library) : arguments.ids) {
        Result<Tool> tool = listedTool(id, library);
        if (!tool) return context.fail(tool.error());
        tools.push_back(std::move(*tool));
    }
    const Result<WrittenTools> written = toolsFor(arguments.file, tools.size() == 1 ? tools.front().id : std::string(),
                                                  tools, tableUnit(arguments.units));
    if (!written) return context.fail(written.error());
    if (const Result<void> done = writeTools(arguments.file, *written); !done) return context.fail(done.error());
    json bits = json::array();
    for (const WrittenTools::File& bit : written->files) bits.push_back(bit.file.string());
    context.answer({{"file", arguments.file}, {"tools", tools.size()}, {"bits", bits}, {"notes", written->notes}},
                   arguments.file + linesOf(written->notes));
    return 0;
}

void registerExport(CommandParser tools, std::shared_ptr<const LibraryArguments> chosen, CommandContext& context,
                    int& status) {
    auto arguments = std::make_shared<ToolExportArguments>();
    arguments->tools = std::move(chosen);
    const CommandParser exports = tools.command(
        "export",
        BURIN_TEXT("Help", "Write tools for other programs: a LinuxCNC tool table (*.tbl), a Fusion "
                           "library (*.tools), a CAMotics table (*.ctbl), a FreeCAD library with its bits in a "
                           "folder Bit (*.fctl), a FreeCAD tool bit (*.fctb), or Burin's own form (*.json)"));
    exports.passOn();
    exports.positional(BURIN_TEXT("Argument", "ID"), arguments->ids,
                       BURIN_TEXT("Help", "Tools (default: all, or those of --library)"));
    exports.option("-o,--output", arguments->file, BURIN_TEXT("Help", "File to write")).required();
    exports.option("--units", arguments->units, BURIN_TEXT("Help", "Unit of the machine that reads the table"))
        .choices({"mm", "inch"});
    exports.run([arguments, &context, &status] { status = exportTools(*arguments, context); });
}

} // namespace

void registerToolExchange(CommandParser tools, std::shared_ptr<const LibraryArguments> chosen, CommandContext& context,
                          int& status) {
    registerToolImport(tools, chosen, context, status);
    registerExport(tools, std::move(chosen), context, status);
}

} // namespace burin
