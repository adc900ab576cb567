// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/plan_drawing.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// A drawing that is read has finite points, no more than are allowed, and its areas can be offset.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const auto drawing = burin::drawingOf({reinterpret_cast<const char*>(bytes), count}, "fuzz");
    if (!drawing) return 0;
    std::size_t places = 0;
    for (const burin::DrawnCurve& curve : drawing->curves) {
        if (curve.places.size() < (curve.closed ? 3u : 2u)) std::abort();
        places += curve.places.size();
        for (const glm::dvec2& place : curve.places)
            if (!(std::abs(place.x) <= burin::farthestInPlan && std::abs(place.y) <= burin::farthestInPlan))
                std::abort();
    }
    if (places > burin::mostDrawnPlaces) std::abort();
    if (places > 200) return 0;
    if (const auto region = burin::regionOf(*drawing, "fuzz")) (void)burin::grown(*region, 1.0);
    return 0;
}
