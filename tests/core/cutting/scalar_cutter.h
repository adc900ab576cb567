// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/tool/span_rows.h"
#include "core/volume/runs/run_volume.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/random_cases.h"

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace burin::tests {

inline double real(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

using testing::holds;

/// Oblique layers of both stocks, a protected block with stock behind it, and caves. False if the volume's memory is
/// too small.
inline bool fillMotley(RunVolume& volume) {
    const Grid& grid = volume.grid();
    const RunPosition end = grid.lineEnd();
    bool fits = volume.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()}, 0, end, softStock);
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            const auto at = static_cast<RunPosition>(line.u * 37 + line.v * 23);
            const auto fill = [&](RunPosition from, RunPosition to, PropertyIndex property) {
                fits = fits && volume.fillSpan(line, from, to, property);
            };
            fill(end / 3 + at % (end / 4), end / 2 + at % (end / 4), hardStock);
            if (line.u % 17 < 5 && line.v % 13 < 9) fill(end / 4 + 17, end / 2 - 100 - at % 50, part);
            if ((line.u / 3 + line.v / 5) % 4 == 0) fill(2 * end / 3, 2 * end / 3 + 333, airProperty);
            if (line.u % 29 == 3) fill(0, end, airProperty);
        }
    return fits;
}
inline RunVolume motleyWorkpiece(const Grid& grid) {
    RunVolume volume = RunVolume::make(grid, materials()).value();
    RC_ASSERT(fillMotley(volume));
    return volume;
}

/// The scalar cutter: removes the same spans line by line, over the whole grid, each directly from the volume. For any
/// run axis, with the tool axis along the runs.
class ScalarCutter {
public:
    ScalarCutter(const Cutter& cutter, const Grid& grid)
        : grid_(grid), spans_(inVoxels(flutes(cutter)), static_cast<std::int32_t>(grid.lineEnd())) {}

    RunAmounts cut(RunVolume& volume, const glm::dvec3& from, const glm::dvec3& to) {
        constexpr glm::dvec3 upright(0.0, 0.0, 1.0);
        RunAmounts removed;
        const glm::dvec3 start = inLines(from), end = inLines(to);
        const int parts = std::max(1, int(std::ceil(glm::length(end - start) / spans_.longestWay(upright) - 1e-9)));
        glm::dvec3 tip = start;
        for (int i = 1; i <= parts; ++i) {
            const glm::dvec3 next = i == parts ? end : glm::mix(start, end, double(i) / parts);
            spans_.begin({tip, upright}, next, true);
            tip = next;
            for (LineIndex line; line.v < grid_.lineCountV(); ++line.v)
                for (line.u = 0; line.u < grid_.lineCountU(); line.u += 8) takeGroup(volume, line, removed);
        }
        return removed;
    }

private:
    void takeGroup(RunVolume& volume, LineIndex first, RunAmounts& removed) {
        BrickOfSpans brick;
        spans_.spans(std::array{RowSpans{first.v, first.u / 8, 1, &brick}});
        const EightIntegers &low = brick.low[first.v & 7], &high = brick.high[first.v & 7];
        for (int lane = 0; lane < 8 && first.u + lane < grid_.lineCountU(); ++lane)
            if (low[lane] < high[lane])
                RC_ASSERT(volume.removeSpan({first.u + lane, first.v}, RunPosition(low[lane]), RunPosition(high[lane]),
                                            removed) != Removal::outOfMemory);
    }
    RevolvedPiece inVoxels(RevolvedPiece piece) const {
        for (double* length : {&piece.bottom, &piece.top, &piece.bottomRadius, &piece.topRadius, &piece.cornerRadius})
            *length /= grid_.edge();
        return piece;
    }
    glm::dvec3 turned(const glm::dvec3& v) const {
        return {v[grid_.axisOfU()], v[grid_.axisOfV()], v[grid_.axisOfRuns()]};
    }
    glm::dvec3 inLines(const glm::dvec3& tip) const {
        const glm::dvec3 place = turned((tip - grid_.low()) / grid_.edge());
        return {place.x - 0.5, place.y - 0.5, place.z};
    }
    Grid grid_;
    SpanRows spans_;
};

template <class First, class Second>
bool sameLines(const First& a, const Second& b) {
    const Grid& grid = a.grid();
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            if (!std::ranges::equal(a.line(line), b.line(line))) return false;
    return true;
}

/// Whether every line has no gaps up to its end, rising ends and unequal neighbours, and the amounts equal a recount.
inline bool isValid(const RunVolume& volume) {
    const Grid& grid = volume.grid();
    RunAmounts recounted;
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            RunPosition start = 0;
            int before = -1;
            for (const Segment segment : volume.line(line)) {
                if (segment.end() <= start || segment.property() == before) return false;
                recounted.units[segment.property()] += segment.end() - start;
                start = segment.end();
                before = segment.property();
            }
            if (start != grid.lineEnd()) return false;
        }
    return recounted == volume.amounts();
}

/// Ball, flat or bull nose.
inline Cutter cutterOf(int kind, double radius) {
    if (kind == 0) return ball(2.0 * radius, 3.0 * radius);
    if (kind == 1) return flat(2.0 * radius, 2.0 * radius);
    return bullNose(2.0 * radius, 0.3 * radius, 2.0 * radius);
}

} // namespace burin::tests
