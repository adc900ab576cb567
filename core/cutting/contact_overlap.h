// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/contact.h"
#include "core/cutting/line_frame.h"

#include <utility>

namespace burin {

/// The sum of what shank or holder overlap in a workpiece.
struct ContactOverlap {
    std::array<std::uint64_t, 256> byProperty{}; ///< run units
    std::uint64_t units = 0;
    glm::dvec3 moment{0.0}; ///< mm times units, line frame

    void add(const Grid& grid, LineIndex line, PropertyIndex property, RunPosition start, RunPosition end) noexcept {
        const double middle = 0.5 * (grid.toMillimetres(start) + grid.toMillimetres(end));
        byProperty[property] += end - start;
        moment += static_cast<double>(end - start) * glm::dvec3(grid.lineCentre(line), middle);
        units += end - start;
    }
    /// Completes a contact, except for its piece; an empty sum leaves it as it is.
    void describe(const RunVolume& workpiece, ShankContact& contact) const noexcept {
        if (units == 0) return;
        const Grid& grid = workpiece.grid();
        contact.touches = true;
        contact.place = inSetupFrame(grid, moment / static_cast<double>(units));
        contact.volume = static_cast<double>(units) * grid.unitVolume();
        for (std::size_t i = 1; i < byProperty.size(); ++i) {
            if (byProperty[i] == 0) continue;
            const auto property = static_cast<PropertyIndex>(i);
            TouchedProperty touched{property, workpiece.properties().isProtected(property),
                                    static_cast<double>(byProperty[i]) * grid.unitVolume()};
            (touched.isProtected ? contact.touchesProtected : contact.touchesStock) = true;
            for (TouchedProperty& place : contact.touched)
                if (touched.volume > place.volume) std::swap(touched, place);
        }
        contact.property = contact.touched.front().property;
    }
};

} // namespace burin
