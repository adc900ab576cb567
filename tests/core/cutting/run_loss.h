// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"
#include "tests/core/cutting/workpieces.h"

#include <algorithm>

namespace burin::tests {

/// The material that a volume lost between two moments, computed from its runs alone.
struct RunLoss {
    bool onlyMachinable = true; ///< every interval is unchanged, or was machinable and is now air
    RunAmounts amounts;         ///< run units
    double units = 0.0;         ///< of all properties
    glm::dvec3 moment{0.0};     ///< run units times mm, setup frame

    glm::dvec3 centroid() const { return moment / units; }
};

/// Both snapshots are of the same volume.
inline RunLoss lossBetween(const VolumeSnapshot& before, const VolumeSnapshot& after) {
    RunLoss loss;
    const Grid& grid = before.grid();
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            const auto was = before.line(line), is = after.line(line);
            RunPosition start = 0;
            for (std::size_t i = 0, k = 0; i < was.size() && k < is.size();) {
                const RunPosition end = std::min(was[i].end(), is[k].end());
                if (const PropertyIndex lost = was[i].property(); lost != is[k].property()) {
                    const double units = end - start;
                    loss.onlyMachinable = loss.onlyMachinable && lost != airProperty &&
                                          !before.properties().isProtected(lost) && is[k].property() == airProperty;
                    loss.amounts.units[lost] += end - start;
                    loss.units += units;
                    loss.moment += units * placeOn(grid, line, start + 0.5 * units);
                }
                start = end;
                if (was[i].end() == end) ++i;
                if (is[k].end() == end) ++k;
            }
        }
    return loss;
}

} // namespace burin::tests
