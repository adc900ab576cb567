// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/line_frame.h"
#include "core/geometry/pose.h"
#include "core/tool/swept_span.h"
#include "core/volume/runs/run_volume.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace burin::tests {

/// A convex piece with every face moved outwards, or inwards where `by` is negative.
inline RevolvedPiece grown(const RevolvedPiece& piece, double by) {
    return {piece.bottom - by, piece.top + by, piece.bottomRadius + by, piece.topRadius + by,
            piece.cornerRadius == 0.0 ? 0.0 : piece.cornerRadius + by};
}

/// Intervals of every scanline of a grid, run units.
class Intervals {
public:
    explicit Intervals(const Grid& grid)
        : grid_(grid)
        , lines_(static_cast<std::size_t>(grid.lineCountU()) * static_cast<std::size_t>(grid.lineCountV())) {}

    /// Adds the volume swept by a piece, by its exact spans, with each end moved outwards by `slack` run units.
    void addSweep(const RevolvedPiece& piece, const ToolPose& from, const glm::dvec3& toTip, double slack) {
        const glm::dvec3 start = inLineFrame(grid_, from.tip), end = inLineFrame(grid_, toTip);
        const SweptPiece swept(piece, start, end, inLineFrame(grid_, from.axis));
        const double reach = std::hypot(std::max(std::abs(piece.bottom), piece.top), piece.bottomRadius) + grid_.edge();
        const glm::dvec3 low = glm::min(start, end) - reach, high = glm::max(start, end) + reach;
        const double bottom = grid_.low()[grid_.axisOfRuns()], unit = grid_.edge() / unitsPerVoxel;
        for (LineIndex line; line.v < grid_.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid_.lineCountU(); ++line.u) {
                const glm::dvec2 centre = grid_.lineCentre(line);
                if (centre.x < low.x || centre.x > high.x || centre.y < low.y || centre.y > high.y) continue;
                const std::optional<Span> span = swept.along(centre.x, centre.y);
                if (!span) continue;
                const Span units{(span->low - bottom) / unit - slack, (span->high - bottom) / unit + slack};
                if (units.low < units.high) at(line).push_back(units);
            }
    }
    /// Joins intervals that overlap or touch.
    void merge() {
        for (std::vector<Span>& line : lines_) {
            std::ranges::sort(line, {}, &Span::low);
            std::size_t kept = 0;
            for (const Span& span : line)
                if (kept > 0 && span.low <= line[kept - 1].high)
                    line[kept - 1].high = std::max(line[kept - 1].high, span.high);
                else
                    line[kept++] = span;
            line.resize(kept);
        }
    }
    const std::vector<Span>& of(LineIndex line) const { return const_cast<Intervals&>(*this).at(line); }

private:
    std::vector<Span>& at(LineIndex line) {
        return lines_[static_cast<std::size_t>(line.v) * static_cast<std::size_t>(grid_.lineCountU()) +
                      static_cast<std::size_t>(line.u)];
    }
    Grid grid_;
    std::vector<std::vector<Span>> lines_;
};

/// The air of a line that was solid.
template <class Segments>
std::vector<Span> airOf(const Segments& segments) {
    std::vector<Span> air;
    double start = 0.0;
    for (const Segment segment : segments) {
        if (segment.property() == airProperty) air.push_back({start, static_cast<double>(segment.end())});
        start = static_cast<double>(segment.end());
    }
    return air;
}

/// The largest part of `inner` within 0 … `end` that no interval of `outer` (merged) contains, run units; 0: all is
/// contained.
inline double notHeld(const std::vector<Span>& inner, const std::vector<Span>& outer, double end) {
    double most = 0.0;
    for (const Span& span : inner) {
        const double low = std::max(span.low, 0.0), high = std::min(span.high, end);
        double reached = low;
        for (const Span& holds : outer)
            if (holds.high > reached && holds.low < high) {
                most = std::max(most, holds.low - reached);
                reached = std::max(reached, holds.high);
            }
        most = std::max(most, high - reached);
    }
    return most;
}

} // namespace burin::tests
