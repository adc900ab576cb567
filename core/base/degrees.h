// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"

#include <cmath>

namespace burin {

/// Returns an angle in degrees, rounded to 1e-9: angles in files are integers or short decimals, which a conversion to
/// radians and back would not keep. @param radians rad
inline double roundedDegrees(double radians) noexcept {
    return std::round(radians * 180.0 / pi * 1e9) / 1e9;
}

} // namespace burin
