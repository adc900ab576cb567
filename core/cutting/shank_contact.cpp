// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/footprint.h"
#include "core/cutting/removal.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <cassert>

namespace burin {

namespace {

constexpr RunPosition tolerance = unitsPerVoxel / 4;

struct Overlap {
    std::array<std::uint64_t, 256> byProperty{}; ///< run units
    std::uint64_t units = 0;
    glm::dvec3 moment{0.0}; ///< mm times units
};

void addLine(const RunVolume& workpiece, LineIndex line, RunPosition from, RunPosition to, Overlap& overlap) noexcept {
    std::uint64_t units = 0;
    forEachPiece(workpiece.line(line), from, to,
                 [&](PropertyIndex, RunPosition start, RunPosition end) { units += end - start; });
    if (units <= tolerance) return;
    const Grid& grid = workpiece.grid();
    const glm::dvec2 centre = grid.lineCentre(line);
    forEachPiece(workpiece.line(line), from, to, [&](PropertyIndex property, RunPosition start, RunPosition end) {
        const double middle = 0.5 * (grid.toMillimetres(start) + grid.toMillimetres(end));
        overlap.byProperty[property] += end - start;
        overlap.moment += static_cast<double>(end - start) * glm::dvec3(centre, middle);
    });
    overlap.units += units;
}

} // namespace

ShankContact shankContact(const RunVolume& workpiece, std::span<const RevolvedPiece> tool,
                          const glm::dvec3& tip) noexcept {
    assert(workpiece.grid().axis() == RunAxis::z);
    ShankContact contact;
    if (!isFinite(tip)) return contact;
    Overlap overlap;
    std::uint64_t most = 0;
    for (std::size_t i = 1; i < tool.size(); ++i) {
        const std::uint64_t before = overlap.units;
        forEachSpan(SweptPiece(tool[i], tip, tip), workpiece.grid(),
                    [&](LineIndex line, RunPosition from, RunPosition to) {
                        addLine(workpiece, line, from, to, overlap);
                        return true;
                    });
        if (overlap.units - before <= most) continue;
        most = overlap.units - before;
        contact.piece = static_cast<std::uint8_t>(i);
    }
    if (overlap.units == 0) return contact;
    contact.touches = true;
    contact.property =
        static_cast<PropertyIndex>(std::ranges::max_element(overlap.byProperty) - overlap.byProperty.begin());
    contact.place = overlap.moment / static_cast<double>(overlap.units);
    contact.volume = static_cast<double>(overlap.units) * workpiece.grid().unitVolume();
    return contact;
}

} // namespace burin
