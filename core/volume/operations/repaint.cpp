// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/repaint.h"

#include "core/volume/runs/brick_lines.h"

#include <algorithm>
#include <new>

namespace burin {

namespace {

/// A slab in terms of a volume's scanlines.
class Slab {
public:
    Slab(const Grid& grid, int axis, double from, double to) : grid_(grid), axis_(axis), from_(from), to_(to) {
        if (axis != grid.axisOfRuns()) return;
        const double begin = grid.toMillimetres(0), end = grid.toMillimetres(grid.lineEnd());
        low_ = from <= begin ? 0 : grid.toRunPosition(std::min(from, end));
        high_ = to >= end ? grid.lineEnd() : grid.toRunPosition(std::max(to, begin));
    }

    /// The interval of a line inside the slab; empty if high is not above low.
    struct Interval {
        RunPosition low = 0, high = 0;
    };
    Interval on(LineIndex line) const {
        if (!grid_.contains(line)) return {};
        if (axis_ == grid_.axisOfRuns()) return {low_, high_};
        const glm::dvec2 centre = grid_.lineCentre(line);
        const double at = axis_ == grid_.axisOfU() ? centre.x : centre.y;
        return at >= from_ && at < to_ ? Interval{0, grid_.lineEnd()} : Interval{};
    }

private:
    const Grid& grid_;
    int axis_;
    double from_, to_;
    RunPosition low_ = 0, high_ = 0;
};

class RowPainter {
public:
    RowPainter(const RunVolume& volume, PropertyIndex property, const Slab& slab)
        : volume_(volume), property_(property), slab_(slab) {}

    void run(std::int32_t row, BrickSink& sink) const {
        const Grid& grid = volume_.grid();
        BrickLines lines(grid.lineEnd());
        for (LineIndex low{0, row * brickSide}; low.u < grid.lineCountU(); low.u += brickSide) {
            lines.clear();
            bool changed = false;
            for (std::int32_t v = low.v; v < low.v + brickSide; ++v)
                for (std::int32_t u = low.u; u < low.u + brickSide; ++u) {
                    changed = paint({u, v}, lines) || changed;
                    lines.endLine();
                }
            if (changed) sink.put(low, lines);
        }
    }

private:
    bool paint(LineIndex line, BrickLines& lines) const {
        if (!volume_.grid().contains(line)) return false;
        const Slab::Interval within = slab_.on(line);
        bool changed = false;
        RunPosition start = 0;
        for (const Segment segment : volume_.line(line)) {
            const RunPosition from = std::clamp(within.low, start, segment.end());
            const RunPosition to = std::clamp(within.high, from, segment.end());
            if (segment.property() == airProperty || from == to) {
                lines.append(segment.end(), segment.property());
            } else {
                changed = changed || segment.property() != property_;
                if (from > start) lines.append(from, segment.property());
                lines.append(to, property_);
                lines.append(segment.end(), segment.property());
            }
            start = segment.end();
        }
        return changed;
    }

    const RunVolume& volume_;
    PropertyIndex property_;
    const Slab& slab_;
};

} // namespace

Result<void> repaint(RunVolume& volume, PropertyIndex property, int axis, double from, double to) {
    if (property == airProperty || property >= volume.properties().size())
        return Error{ErrorCode::argumentInvalid, "property", std::to_string(property), "a material of the list"};
    const Slab slab(volume.grid(), axis, from, to);
    const RowPainter painter(volume, property, slab);
    try {
        if (volume.rewriteBricks([&](std::int32_t row, BrickSink& sink) { painter.run(row, sink); })) return {};
        return Error{ErrorCode::volumeOutOfMemory, std::to_string(volume.reservedBytes()), {}, {}};
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, "volume", {}, {}};
    }
}

} // namespace burin
