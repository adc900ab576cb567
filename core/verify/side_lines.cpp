// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/side_lines.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double wholeVoxel = 1e-9;

std::uint64_t machinableUnits(const RunVolume& workpiece, LineIndex line) {
    std::uint64_t units = 0;
    RunPosition start = 0;
    for (const Segment segment : workpiece.line(line)) {
        const PropertyIndex property = segment.property();
        if (property != airProperty && !workpiece.properties().isProtected(property)) units += segment.end() - start;
        start = segment.end();
    }
    return units;
}

/// The last line along an axis across the runs that BoxStock fills, and the width of the stock from there in voxels.
struct LastLine {
    std::int32_t index = 0;
    double stands = 1.0;
};
LastLine lastOf(double low, double high, double edge, std::int32_t count) {
    const double width = (high - low) / edge;
    const auto lines = std::clamp(static_cast<std::int32_t>(std::ceil(width - 0.5 - 1e-6)), 1, count);
    return {lines - 1, width - (lines - 1)};
}

} // namespace

SideLines::SideLines(const RunVolume& workpiece, const Box& stock) {
    const Grid& grid = workpiece.grid();
    const int u = grid.axisOfU(), v = grid.axisOfV();
    const LastLine lastU = lastOf(grid.low()[u], stock.high[u], grid.edge(), grid.lineCountU());
    const LastLine lastV = lastOf(grid.low()[v], stock.high[v], grid.edge(), grid.lineCountV());
    const auto add = [&](LineIndex line) {
        const double beside =
            (line.u == lastU.index ? lastU.stands : 1.0) * (line.v == lastV.index ? lastV.stands : 1.0) - 1.0;
        if (std::abs(beside) > wholeVoxel) lines_.push_back({line, beside, machinableUnits(workpiece, line)});
    };
    for (std::int32_t at = 0; at <= lastV.index; ++at) add({lastU.index, at});
    for (std::int32_t at = 0; at < lastU.index; ++at) add({at, lastV.index});
}

double SideLines::removedBeside(const RunVolume& workpiece) const {
    double units = 0.0;
    for (const Line& line : lines_)
        units += line.beside *
                 (static_cast<double>(line.units) - static_cast<double>(machinableUnits(workpiece, line.line)));
    return units * workpiece.grid().unitVolume();
}

} // namespace burin
