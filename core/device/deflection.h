// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace burin {

/// The response of an input that springs back to its centre (a joystick, a cap): the share of the full speed, -1 … 1,
/// for a share of its deflection beyond the dead zone. It grows smoothly, with a small slope first and with the cube of
/// the deflection farther out. An odd, monotonic, continuous function; ±1 from full deflection on.
inline double deflectionCurve(double beyond) noexcept {
    constexpr double linearShare = 0.3; // share of the linear term in the response; the cubic term has the rest
    const double bounded = std::clamp(beyond, -1.0, 1.0);
    return bounded * (linearShare + (1.0 - linearShare) * bounded * bounded);
}

/// deflectionCurve for a deflection of -1 … 1, zero within a dead zone of 5 %.
inline double deflectionResponse(double share) noexcept {
    constexpr double deadZone = 0.05;
    const double bounded = std::clamp(share, -1.0, 1.0);
    const double beyond = std::max(0.0, std::abs(bounded) - deadZone) / (1.0 - deadZone);
    return std::copysign(deflectionCurve(beyond), bounded);
}

} // namespace burin
