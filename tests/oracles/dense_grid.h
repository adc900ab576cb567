// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <algorithm>
#include <vector>

namespace burin::oracles {

/// Contents of a volume as a dense array: one property for each 1/256 voxel of each scanline. For small grids.
class DenseGrid {
public:
    explicit DenseGrid(const Grid& grid)
        : grid_(grid)
        , units_(static_cast<std::size_t>(grid.lineCountU()) * static_cast<std::size_t>(grid.lineCountV()) *
                 grid.lineEnd()) {}

    PropertyIndex& at(LineIndex line, RunPosition unit) { return units_[place(line) + unit]; }
    PropertyIndex at(LineIndex line, RunPosition unit) const { return units_[place(line) + unit]; }

    /// Removes everything for which `isProtected` is false; adds the removed amounts to `removed`.
    template <class IsProtected>
    void removeSpan(LineIndex line, RunPosition from, RunPosition to, IsProtected isProtected, RunAmounts& removed) {
        for (RunPosition unit = from; unit < std::min(to, grid_.lineEnd()); ++unit) {
            PropertyIndex& here = at(line, unit);
            if (here == airProperty || isProtected(here)) continue;
            ++removed.units[here];
            here = airProperty;
        }
    }
    void fillSpan(LineIndex line, RunPosition from, RunPosition to, PropertyIndex property) {
        for (RunPosition unit = from; unit < std::min(to, grid_.lineEnd()); ++unit) at(line, unit) = property;
    }
    RunAmounts amounts() const {
        RunAmounts sum;
        for (const PropertyIndex property : units_) ++sum.units[property];
        return sum;
    }
    /// The segments expected on a line: without gaps, adjacent segments of different properties.
    std::vector<Segment> segments(LineIndex line) const {
        std::vector<Segment> all;
        for (RunPosition unit = 0; unit < grid_.lineEnd(); ++unit)
            if (unit + 1 == grid_.lineEnd() || at(line, unit + 1) != at(line, unit))
                all.emplace_back(unit + 1, at(line, unit));
        return all;
    }
    /// `volume`: a RunVolume or a VolumeSnapshot.
    template <class Volume>
    bool equals(const Volume& volume) const {
        for (LineIndex line; line.v < grid_.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid_.lineCountU(); ++line.u)
                if (!std::ranges::equal(segments(line), volume.line(line))) return false;
        return true;
    }

private:
    std::size_t place(LineIndex line) const {
        return (static_cast<std::size_t>(line.v) * static_cast<std::size_t>(grid_.lineCountU()) +
                static_cast<std::size_t>(line.u)) *
               grid_.lineEnd();
    }

    Grid grid_;
    std::vector<PropertyIndex> units_;
};

} // namespace burin::oracles
