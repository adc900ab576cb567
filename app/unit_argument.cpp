// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/unit_argument.h"

#include "app/wording.h"
#include "core/cad/file_unit.h"

namespace burin {

void addUnit(CommandParser command, std::string& unit) {
    command.option("--unit", unit,
                   BURIN_TEXT("Help", "Unit of the model, whatever its file states: mm, cm, m, inch, foot, mil, a "
                                      "number of mm, or stated"));
}

Result<void> applyUnit(const std::string& unit, ImportOptions& options) {
    if (unit.empty()) return {};
    if (unit == "stated") {
        options.unitInstead.reset();
        return {};
    }
    options.unitInstead = unitFromText(unit);
    if (options.unitInstead) return {};
    return wrongArgument("--unit", unit,
                         BURIN_TEXT("Command", "mm, cm, dm, m, km, µm, inch, foot, yard, mil, stated, or mm per unit "
                                               "from 0.000001 to 1000000"));
}

} // namespace burin
