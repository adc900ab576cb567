// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace burin {

/// Number of sides of a polygon around a circle that is nowhere farther from it than `chord`, mm.
inline std::uint32_t sidesAround(double radius, double chord) noexcept {
    const double half = std::acos(radius / (radius + chord));
    return static_cast<std::uint32_t>(std::clamp(std::ceil(pi / half), 8.0, 4096.0));
}

/// Radius of the corners of that polygon, mm.
inline double cornerRadius(double radius, std::uint32_t sides) noexcept {
    return radius / std::cos(pi / sides);
}

} // namespace burin
