// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool_library.h"

#include "core/base/resource_folder.h"

#include <algorithm>

namespace burin {

Tool copyOf(const Tool& tool, const std::string& id, const std::string& name) {
    Tool copy = tool;
    copy.id = id;
    copy.name = name;
    copy.source = "copy of " + tool.id + ": " + tool.source;
    return copy;
}

int freeToolNumber(const std::vector<Tool>& tools) {
    int number = 1;
    while (std::ranges::find(tools, number, &Tool::number) != tools.end()) ++number;
    return number;
}

bool isShippedTool(std::string_view id) {
    return isShipped(toolResource, id) && !isOfUser(toolResource, id);
}

Result<std::filesystem::path> saveTool(const Tool& tool, bool replace) {
    Result<std::filesystem::path> file = userResourceFile(toolResource, tool.id);
    if (!file) return file;
    if (isShipped(toolResource, tool.id))
        return Error{ErrorCode::argumentInvalid, "tool", tool.id,
                     "an id that no shipped tool has; shipped tools can be copied, not changed"};
    if (!replace && isOfUser(toolResource, tool.id))
        return Error{ErrorCode::argumentInvalid, "tool", tool.id, "an id that no tool has yet, or --replace"};
    const std::string text = toJson(tool);
    if (const Result<Tool> sound = toolFromJson(text, file->filename().string()); !sound) return sound.error();
    return saveUserResource(toolResource, tool.id, text);
}

Result<void> removeTool(const std::string& id) {
    if (isShippedTool(id))
        return Error{ErrorCode::argumentInvalid, "tool", id,
                     "a tool of your own; those that Burin is shipped with can't be deleted"};
    return removeUserResource(toolResource, id);
}

} // namespace burin
