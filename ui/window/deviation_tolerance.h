// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/deviation_map.h"
#include "ui/workbench/workbench.h"

namespace burin {

/// The tolerances of the program's deviation from the part, and the allowance.
inline DeviationTolerance deviationTolerance(const Workbench& workbench) {
    DeviationTolerance tolerance;
    tolerance.gouge = workbench.program.gougeTolerance();
    // 0: excess is not judged; it is shown on the default scale.
    if (workbench.program.excessTolerance() > 0.0) tolerance.excess = workbench.program.excessTolerance();
    tolerance.allowance = workbench.mill.allowance();
    return tolerance;
}

} // namespace burin
