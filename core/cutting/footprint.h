// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cut_cache.h"
#include "core/cutting/line_frame.h"
#include "core/tool/line_interval.h"
#include "core/tool/swept_span.h"
#include "core/volume/runs/run_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace burin {

/// Returns the scanlines whose centres lie in the interval `interval` (mm along an axis that starts at `low`), at most
/// `count` of them. Where rounding is ambiguous it includes one more at either end: the exact span decides.
inline LineInterval linesWithin(const Span& interval, double low, double edge, std::int32_t count) noexcept {
    constexpr double slack = 1e-6; // voxels
    const double first = std::ceil((interval.low - low) / edge - 0.5 - slack);
    const double last = std::floor((interval.high - low) / edge - 0.5 + slack);
    return {static_cast<std::int32_t>(std::clamp(first, 0.0, static_cast<double>(count))),
            static_cast<std::int32_t>(std::clamp(last, -1.0, static_cast<double>(count) - 1.0))};
}

/// Run units by which a piece that must not touch may still overlap a line: a quarter of a voxel, and for a piece
/// shorter than half a voxel (a holder may be drawn in such steps) half its height.
inline RunPosition contactTolerance(const RevolvedPiece& piece, const Grid& grid) noexcept {
    const double half = 0.5 * (piece.top - piece.bottom) / grid.edge();
    return static_cast<RunPosition>(std::min(0.25, half) * unitsPerVoxel);
}

/// Calls `visit(line, from, to)` for every scanline of some rows (v) whose centre line intersects the swept piece
/// within the grid, with run positions from < to rounded by Grid's one rule; stops when it returns false.
/// @param swept in the frame of the grid's lines (inLineFrame)
/// @param wanted  (line, from, to): whether anything between these positions, the whole range that the piece may reach,
/// matters to `visit`; it is asked first because a span takes more time than this check
template <class Visit, class Requested>
void forEachSpanInRows(const SweptPiece& swept, const Grid& grid, LineInterval within, Visit&& visit,
                       Requested&& wanted) noexcept {
    const Box reach = swept.bounds(), box = inLineFrame(grid, grid.box());
    if (reach.high.z <= box.low.z || reach.low.z >= box.high.z) return;
    const RunPosition lowest = grid.toRunPosition(reach.low.z), highest = grid.toRunPosition(reach.high.z);
    double top = std::numeric_limits<double>::quiet_NaN(); // mm, of the line before: most lines end at the same height
    RunPosition to = 0;
    const LineInterval rows = linesWithin({reach.low.y, reach.high.y}, box.low.y, grid.edge(), grid.lineCountV());
    const std::int32_t last = std::min(rows.last, within.last);
    for (std::int32_t v = std::max(rows.first, within.first); v <= last; ++v) {
        const double y = grid.lineCentre({0, v}).y;
        const std::optional<Span> shadow = swept.shadow(y);
        if (!shadow) continue;
        const LineInterval row = linesWithin(*shadow, box.low.x, grid.edge(), grid.lineCountU());
        for (std::int32_t u = row.first; u <= row.last; ++u) {
            const LineIndex line{u, v};
            if (!wanted(line, lowest, highest)) continue;
            const std::optional<Span> span = swept.along(grid.lineCentre(line).x, y);
            if (!span) continue;
            // Ends beyond the grid need no arithmetic: most flutes extend beyond the stock.
            const RunPosition from = span->low <= box.low.z ? 0 : grid.toRunPosition(span->low);
            if (span->high != top) to = span->high >= box.high.z ? grid.lineEnd() : grid.toRunPosition(span->high);
            top = span->high;
            if (from < to && !visit(line, from, to)) return;
        }
    }
}

/// The same without a filter of lines.
template <class Visit>
void forEachSpanInRows(const SweptPiece& swept, const Grid& grid, LineInterval within, Visit&& visit) noexcept {
    forEachSpanInRows(swept, grid, within, std::forward<Visit>(visit),
                      [](LineIndex, RunPosition, RunPosition) { return true; });
}

/// The same for every scanline of the grid.
template <class Visit, class... Requested>
void forEachSpan(const SweptPiece& swept, const Grid& grid, Visit&& visit, Requested&&... wanted) noexcept {
    forEachSpanInRows(swept, grid, {0, grid.lineCountV() - 1}, std::forward<Visit>(visit),
                      std::forward<Requested>(wanted)...);
}

/// Calls `visit(property, start, end)` for every piece of a line's segments between `from` and `to` that is not air.
template <class Visit>
void forEachPiece(std::span<const Segment> segments, RunPosition from, RunPosition to, Visit&& visit) noexcept {
    RunPosition start = 0;
    for (const Segment segment : segments) {
        const RunPosition low = std::max(start, from), high = std::min(segment.end(), to);
        if (low < high && segment.property() != airProperty) visit(segment.property(), low, high);
        start = segment.end();
        if (start >= to) return;
    }
}

/// The same for a line that may have pending writes.
template <class Visit>
void forEachPieceNotOwed(const RunVolume& workpiece, const CutCache* window, LineIndex line, RunPosition from,
                         RunPosition to, Visit&& visit) noexcept {
    const CutCache::Owed owed = window != nullptr ? window->owed(line) : CutCache::Owed{};
    forEachPiece(workpiece.line(line), from, to, [&](PropertyIndex property, RunPosition start, RunPosition end) {
        if (owed.from >= owed.to || workpiece.properties().isProtected(property)) {
            visit(property, start, end);
            return;
        }
        if (start < owed.from) visit(property, start, std::min(end, owed.from));
        if (end > owed.to) visit(property, std::max(start, owed.to), end);
    });
}

/// The same for the remaining material. Protected pieces may be left out.
template <class Visit>
void forEachPieceLeft(const RunVolume& workpiece, const CutCache* window, LineIndex line, RunPosition from,
                      RunPosition to, Visit&& visit) noexcept {
    if (window != nullptr && window->visitAround(line, from, to, visit)) return;
    forEachPieceNotOwed(workpiece, window, line, from, to, std::forward<Visit>(visit));
}

} // namespace burin
