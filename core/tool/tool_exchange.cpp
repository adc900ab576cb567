// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool_exchange.h"

#include <algorithm>
#include <filesystem>

namespace burin {

Result<WrittenTools> toolsFor(const std::string& file, const std::string& id, const std::vector<Tool>& tools,
                              double unit) {
    const std::string suffix = std::filesystem::path(file).extension().string();
    if (suffix == ".tbl") return linuxcncTable(tools, unit);
    if (suffix != ".fctb" && suffix != ".json")
        return Error{ErrorCode::argumentInvalid, "name of the file", file, "*.fctb, *.tbl or *.json"};
    const auto tool = std::ranges::find(tools, id, &Tool::id);
    if (tool == tools.end())
        return Error{ErrorCode::argumentInvalid, "tools", id, "one; several go into a table (*.tbl)"};
    if (suffix == ".fctb") return freecadBit(*tool);
    return WrittenTools{toJson(*tool), {}};
}

} // namespace burin
