// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/section.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double mostLines = 300'000.0; // evaluated for a plane perpendicular to the runs

/// For a plane along the runs: the runs of a row of scanlines.
std::vector<SectionPatch> alongRuns(const VolumeSnapshot& workpiece, int axis, std::int32_t index) {
    const Grid& grid = workpiece.grid();
    const bool squareToU = axis == grid.axisOfU();
    const int rowAxis = squareToU ? grid.axisOfV() : grid.axisOfU();
    const std::int32_t lines = squareToU ? grid.lineCountV() : grid.lineCountU();
    const int runs = (axis + 1) % 3 == grid.axisOfRuns() ? 0 : 1; // index of the runs among a patch's two axes
    std::vector<SectionPatch> patches;
    for (std::int32_t i = 0; i < lines; ++i) {
        const double from = grid.low()[rowAxis] + i * grid.edge();
        RunPosition begin = 0;
        for (const Segment& segment : workpiece.line(squareToU ? LineIndex{index, i} : LineIndex{i, index})) {
            if (segment.property() != airProperty) {
                SectionPatch patch;
                patch.property = segment.property();
                patch.low[runs] = grid.toMillimetres(begin);
                patch.high[runs] = grid.toMillimetres(segment.end());
                patch.low[1 - runs] = from;
                patch.high[1 - runs] = from + grid.edge();
                patches.push_back(patch);
            }
            begin = segment.end();
        }
    }
    return patches;
}

PropertyIndex propertyAt(std::span<const Segment> line, RunPosition along) {
    const auto found = std::ranges::find_if(line, [along](const Segment& segment) { return along < segment.end(); });
    return found == line.end() ? airProperty : found->property();
}

/// For a plane perpendicular to the runs: neighbours of one property along u are merged into one patch. U and v follow
/// the runs' axis by cyclic exchange, as the axes of a patch follow the plane's.
std::vector<SectionPatch> acrossRuns(const VolumeSnapshot& workpiece, RunPosition along) {
    const Grid& grid = workpiece.grid();
    const std::int32_t countU = grid.lineCountU(), countV = grid.lineCountV();
    const auto step =
        std::max(1, static_cast<std::int32_t>(std::ceil(std::sqrt(static_cast<double>(countU) * countV / mostLines))));
    const glm::dvec2 low(grid.low()[grid.axisOfU()], grid.low()[grid.axisOfV()]);
    std::vector<SectionPatch> patches;
    for (std::int32_t v = 0; v < countV; v += step) {
        std::int32_t begin = 0;
        PropertyIndex before = airProperty;
        const auto close = [&](std::int32_t end) {
            if (before != airProperty)
                patches.push_back({low + grid.edge() * glm::dvec2(begin, v),
                                   low + grid.edge() * glm::dvec2(end, std::min(v + step, countV)), before});
            begin = end;
        };
        for (std::int32_t u = 0; u < countU; u += step) {
            const PropertyIndex here = propertyAt(workpiece.line({u, v}), along);
            if (here == before) continue;
            close(u);
            before = here;
        }
        close(countU);
    }
    return patches;
}

} // namespace

std::vector<SectionPatch> sectionOf(const VolumeSnapshot& workpiece, int axis, double position) {
    if (workpiece.empty()) return {};
    const Grid& grid = workpiece.grid();
    const Box box = grid.box();
    if (!(position >= box.low[axis] && position < box.high[axis])) return {};
    if (axis == grid.axisOfRuns()) // the unit that the plane lies in, not the nearest end
        return acrossRuns(workpiece,
                          static_cast<RunPosition>((position - box.low[axis]) / grid.edge() * unitsPerVoxel));
    const double index = std::floor((position - box.low[axis]) / grid.edge());
    return alongRuns(workpiece, axis, std::min(static_cast<std::int32_t>(index), grid.count()[axis] - 1));
}

} // namespace burin
