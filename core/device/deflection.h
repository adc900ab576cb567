// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace burin {

/// How fast an input drives that springs back to its middle: -1 … 1 of a deflection. Nothing within the dead zone of
/// 5 %, then growing smoothly, finely near it and with its cube farther out. Odd, rising, continuous, 1 from full
/// deflection on.
inline double deflectionResponse(double share) noexcept {
    constexpr double deadZone = 0.05;
    constexpr double linearShare = 0.3; // of the response; the rest goes with the cube
    const double bounded = std::clamp(share, -1.0, 1.0);
    const double beyond = std::max(0.0, std::abs(bounded) - deadZone) / (1.0 - deadZone);
    return std::copysign(beyond * (linearShare + (1.0 - linearShare) * beyond * beyond), bounded);
}

} // namespace burin
