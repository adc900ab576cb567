// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_field.h"

#include <tuple>

namespace burin {

/// The parameters that every area has.
inline constexpr std::tuple areaFields{
    places("outline_mm", &Area::outline, 3.0,
           {BURIN_TEXT("EditParameterLabels", "Outline"),
            BURIN_TEXT("EditParameterLabels", "Corners of the area, seen from above")}),
    number("low_mm", &Area::low, -farthestPlace, farthestPlace,
           {BURIN_TEXT("EditParameterLabels", "From"),
            BURIN_TEXT("EditParameterLabels", "Lowest height of the area, from program zero")}),
    number("high_mm", &Area::high, -farthestPlace, farthestPlace,
           {BURIN_TEXT("EditParameterLabels", "Up to"),
            BURIN_TEXT("EditParameterLabels", "Greatest height of the area, from program zero")})};

} // namespace burin
