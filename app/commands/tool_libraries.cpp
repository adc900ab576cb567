// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/tool_commands.h"
#include "app/wording.h"
#include "core/base/resource_folder.h"
#include "core/tool/tool_library.h"

#include <algorithm>

namespace burin {

namespace {

using nlohmann::json;

struct ToolLibraryArguments {
    std::shared_ptr<const LibraryArguments> tools;
    std::string name, newName;
    std::vector<std::string> ids;
    bool withTools = false, copy = false;
};

int listLibraries(CommandContext& context) {
    const Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) return context.fail(libraries.error());
    std::vector<std::string> names{std::string(starterLibrary), std::string(ownLibrary)};
    names.insert(names.end(), libraries->names.begin(), libraries->names.end());
    json list = json::array();
    std::string text;
    for (const std::string& name : names) {
        const std::vector<std::string> ids = listedIds(*libraries, name);
        list.push_back({{"name", name}, {"own", name != starterLibrary}, {"tools", ids}});
        text += (text.empty() ? "" : "\n") +
                worded(ids.size(), BURIN_TEXT("Command", "%2: %1 tool"), BURIN_TEXT("Command", "%2: %1 tools"), {name});
    }
    context.answer({{"libraries", list}}, text);
    return 0;
}

int addLibrary(const ToolLibraryArguments& arguments, CommandContext& context) {
    if (const Result<void> added = addToolLibrary(arguments.name); !added) return context.fail(added.error());
    context.answer({{"library", arguments.name}},
                   worded(BURIN_TEXT("Command", "library \"%1\" added"), {arguments.name}));
    return 0;
}

int renameLibrary(const ToolLibraryArguments& arguments, CommandContext& context) {
    if (const Result<void> renamed = renameToolLibrary(arguments.name, arguments.newName); !renamed)
        return context.fail(renamed.error());
    context.answer(
        {{"library", arguments.newName}, {"before", arguments.name}},
        worded(BURIN_TEXT("Command", "library \"%1\" renamed to \"%2\""), {arguments.name, arguments.newName}));
    return 0;
}

/// What a command had done when it failed; empty: nothing.
QString doneBefore(const std::vector<std::string>& ids, TextId text) {
    if (ids.empty()) return {};
    return QString::fromStdString(worded(text, {listed(ids)}));
}

int removeLibrary(const ToolLibraryArguments& arguments, CommandContext& context) {
    const Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) return context.fail(libraries.error());
    const std::vector<std::string> ids =
        libraries->contains(arguments.name) ? listedIds(*libraries, arguments.name) : std::vector<std::string>();
    if (!ids.empty() && !arguments.withTools)
        return context.fail({ErrorCode::argumentInvalid, "library", arguments.name,
                             worded(BURIN_TEXT("Command", "an empty library, or --with-tools to delete its tools"))});
    std::vector<std::string> done;
    const auto fail = [&](const Error& error) {
        return context.fail(error, doneBefore(done, BURIN_TEXT("Command", "already deleted: %1")));
    };
    for (const std::string& id : ids) {
        if (const Result<void> removed = removeTool(id); !removed) return fail(removed.error());
        done.push_back(id);
    }
    if (const Result<void> removed = removeToolLibrary(arguments.name); !removed) return fail(removed.error());
    context.answer({{"removed", arguments.name}, {"tools", ids}},
                   worded(ids.size(), BURIN_TEXT("Command", "library \"%2\" and %1 tool removed"),
                          BURIN_TEXT("Command", "library \"%2\" and %1 tools removed"), {arguments.name}));
    return 0;
}

Tool copyInto(const Tool& tool, std::vector<Tool>& all) {
    const auto taken = [&all](const std::string& id) { return std::ranges::find(all, id, &Tool::id) != all.end(); };
    Tool copy = copyOf(tool, freeResourceId(tool.id + "-copy", taken), tool.name);
    copy.number = freeToolNumber(all);
    all.push_back(copy);
    return copy;
}

Result<void> placeTool(const Tool& tool, const std::string& library, bool copied) {
    if (copied)
        if (const Result<std::filesystem::path> saved = saveTool(tool, false); !saved) return saved.error();
    const Result<void> put = putTool(tool.id, library);
    if (!put && copied) (void)removeTool(tool.id); // otherwise the copy would be among the user's other tools
    return put;
}

/// Refuses to move any tool if one of them can't be moved.
int placeTools(const ToolLibraryArguments& arguments, CommandContext& context) {
    const std::string& library = arguments.tools->library;
    if (library.empty())
        return context.fail(
            wrongArgument("--library", library, BURIN_TEXT("Command", "mine, or a library of your own")));
    const Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) return context.fail(libraries.error());
    if (const Result<void> own = checkOwnLibrary(*libraries, library); !own) return context.fail(own.error());
    std::vector<Tool> all, placed;
    for (const std::string& id : toolIds())
        if (Result<Tool> tool = loadTool(id)) all.push_back(std::move(*tool));
    for (const std::string& id : arguments.ids) {
        const Result<Tool> tool = loadTool(id);
        if (!tool) return context.fail(tool.error());
        if (!arguments.copy && isShippedTool(id))
            return context.fail({ErrorCode::argumentInvalid, "tool", id,
                                 worded(BURIN_TEXT("Command", "a tool of your own, or --copy"))});
        placed.push_back(arguments.copy ? copyInto(*tool, all) : *tool);
    }
    std::vector<std::string> done;
    std::string text;
    for (const Tool& tool : placed) {
        if (const Result<void> put = placeTool(tool, library, arguments.copy); !put)
            return context.fail(put.error(), doneBefore(done, BURIN_TEXT("Command", "already in the library: %1")));
        done.push_back(tool.id);
        text +=
            (text.empty() ? "" : "\n") + worded(BURIN_TEXT("Command", "%1: in the library \"%2\""), {tool.id, library});
    }
    context.answer({{"library", library}, {"tools", done}}, text);
    return 0;
}

} // namespace

void registerToolLibraries(CommandParser tools, std::shared_ptr<const LibraryArguments> chosen, CommandContext& context,
                           int& status) {
    auto arguments = std::make_shared<ToolLibraryArguments>();
    arguments->tools = std::move(chosen);
    const auto add = [&](const char* name, TextId help, auto run) {
        const CommandParser one = tools.command(name, help);
        one.passOn();
        one.run([arguments, run, &context, &status] { status = run(*arguments, context); });
        return one;
    };
    const auto addName = [&](CommandParser to) {
        to.positional(BURIN_TEXT("Argument", "NAME"), arguments->name, BURIN_TEXT("Help", "Tool library")).required();
    };
    add("libraries", BURIN_TEXT("Help", "List the tool libraries with the number of their tools"),
        [](const ToolLibraryArguments&, CommandContext& to) { return listLibraries(to); });
    addName(add("new-library", BURIN_TEXT("Help", "Add a tool library"), &addLibrary));
    const CommandParser renamed =
        add("rename-library", BURIN_TEXT("Help", "Rename one of your tool libraries"), &renameLibrary);
    addName(renamed);
    renamed.positional(BURIN_TEXT("Argument", "NEW"), arguments->newName, BURIN_TEXT("Help", "Its new name"))
        .required();
    const CommandParser removed =
        add("remove-library", BURIN_TEXT("Help", "Delete one of your tool libraries"), &removeLibrary);
    addName(removed);
    removed.flag("--with-tools", arguments->withTools, BURIN_TEXT("Help", "Delete its tools as well"));
    const CommandParser moved =
        add("move", BURIN_TEXT("Help", "Move your own tools to the library given by --library"), &placeTools);
    moved.positional(BURIN_TEXT("Argument", "ID"), arguments->ids, BURIN_TEXT("Help", "Tools")).required();
    moved.flag("--copy", arguments->copy,
               BURIN_TEXT("Help", "Copy them instead; tools that Burin is shipped with can be copied, too"));
}

} // namespace burin
