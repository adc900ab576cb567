// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/machine_check.h"

#include "core/base/numbers.h"

#include <cmath>

namespace burin {

Error limitError(const std::string& what, double value, const std::string& limit, const char* unit) {
    return Error{ErrorCode::programLimit, what, formatFixed(value, 3) + " " + unit + ", limit " + limit, ""};
}

Result<void> checkSpindleSpeed(double speed, const MachineProfile& machine) {
    if (!std::isfinite(speed) || speed <= 0.0 || speed < machine.minimumSpindleSpeed)
        return limitError("spindle speed", speed, formatFixed(machine.minimumSpindleSpeed, 0), "1/min");
    if (speed > machine.maximumSpindleSpeed)
        return limitError("spindle speed", speed, formatFixed(machine.maximumSpindleSpeed, 0), "1/min");
    return {};
}

Result<void> checkCoolant(Coolant coolant, const MachineProfile& machine) {
    if (machine.has(coolant)) return {};
    return Error{ErrorCode::notSupported, std::string(idOf(coolant)) + " coolant for " + machine.name, "", ""};
}

} // namespace burin
