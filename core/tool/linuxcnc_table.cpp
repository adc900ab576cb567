// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// LinuxCNC's tool table: linuxcnc.org/docs/html/gcode/tool-compensation.html.
#include "core/base/clean_text.h"
#include "core/base/numbers.h"
#include "core/tool/tool_exchange.h"

#include <algorithm>

namespace burin {

Result<WrittenTools> linuxcncTable(std::vector<Tool> tools, double unit) {
    constexpr int mostPockets = 1000, decimals = 6;
    std::ranges::sort(tools, {}, &Tool::number);
    WrittenTools written;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const Tool& tool = tools[i];
        const std::string number = std::to_string(tool.number);
        if (i > 0 && tools[i - 1].number == tool.number)
            return Error{ErrorCode::argumentInvalid, "number of " + tool.id, number,
                         "a number that no other tool has (" + tools[i - 1].id + " has it)"};
        if (tool.number > mostPockets)
            return Error{ErrorCode::argumentInvalid, "number of " + tool.id, number,
                         "1 to 1000: it is the pocket, too"};
        written.text += "T" + number + " P" + number + " Z0 D" + formatFixed(tool.cutter.diameter / unit, decimals) +
                        " ;" + cleanLine(tool.name) + "\n";
    }
    written.notes.emplace_back("Lengths are 0: measure them on the machine.");
    return written;
}

} // namespace burin
