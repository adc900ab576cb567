// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/moved.h"

#include "core/base/parallel_progress.h"
#include "core/geometry/frame_along.h"
#include "core/volume/runs/assembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace burin {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

glm::dvec3 unit(int axis) noexcept {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    return direction;
}

Result<Grid> gridOf(const Grid& old, const Placement& placement) {
    const Box box = boxAround(old.box(), placement);
    glm::ivec3 count(1);
    for (int axis = 0; axis < 3; ++axis) {
        // A whole number of voxels must not become one more by the rounding of a division; a value that is not finite
        // is reported by make().
        const double voxels = std::ceil(box.size()[axis] / old.edge() - 1e-6);
        count[axis] = voxels < 2.0 * Grid::maximumVoxelsPerAxis ? std::max(1, static_cast<int>(voxels))
                                                                : 2 * Grid::maximumVoxelsPerAxis;
    }
    const int runs = nearestAxis(placement.direction(unit(old.axisOfRuns())));
    return Grid::make(box.low, old.edge(), count, static_cast<RunAxis>(runs));
}

/// A new scanline in the old grid: u, v in scanlines, along the runs in voxels, as functions of the voxels along it.
struct OldRay {
    glm::dvec3 origin{0.0}, way{0.0};
};

/// Intersects new scanlines with the old runs.
class Scan {
public:
    Scan(const VolumeSnapshot& volume, const Grid& grid, const Placement& placement)
        : volume_(volume), grid_(grid), back_(inverse(placement)) {}

    /// Appends the intersections of a new scanline, from 0 to its end.
    void read(LineIndex line, BrickLines& lines) const {
        const Grid& old = volume_.grid();
        const OldRay ray = rayOf(line);
        const auto length = static_cast<double>(grid_.voxelsPerLine());
        double from = 0.0, to = length;
        clip(ray.origin.x, ray.way.x, old.lineCountU(), from, to);
        clip(ray.origin.y, ray.way.y, old.lineCountV(), from, to);
        if (from < to) {
            put(lines, from, airProperty);
            walk(ray, from, to, lines);
        }
        put(lines, length, airProperty);
        lines.endLine();
    }

private:
    OldRay rayOf(LineIndex line) const {
        const Grid& old = volume_.grid();
        const glm::dvec2 centre = grid_.lineCentre(line);
        glm::dvec3 start = grid_.low();
        start[grid_.axisOfU()] = centre.x;
        start[grid_.axisOfV()] = centre.y;
        const glm::dvec3 origin = (back_.point(start) - old.low()) / old.edge();
        const glm::dvec3 way = back_.direction(unit(grid_.axisOfRuns()));
        const std::array axes{old.axisOfU(), old.axisOfV(), old.axisOfRuns()};
        return {{origin[axes[0]], origin[axes[1]], origin[axes[2]]}, {way[axes[0]], way[axes[1]], way[axes[2]]}};
    }

    static void clip(double origin, double way, double high, double& from, double& to) noexcept {
        if (way == 0.0) {
            if (!(origin > 0.0 && origin < high)) to = from;
            return;
        }
        const double a = -origin / way, b = (high - origin) / way;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }

    static void put(BrickLines& lines, double end, PropertyIndex property) {
        if (end > 0.0) lines.append(static_cast<RunPosition>(end * unitsPerVoxel + 0.5), property);
    }

    /// Where the ray leaves its current column.
    static double leaves(double origin, double way, std::int32_t column) noexcept {
        if (way == 0.0) return never;
        return (column + (way > 0.0 ? 1 : 0) - origin) / way;
    }

    void walk(const OldRay& ray, double from, double to, BrickLines& lines) const {
        const Grid& old = volume_.grid();
        const auto columnAt = [&](int axis, std::int32_t count) {
            const double middle = std::floor(ray.origin[axis] + ray.way[axis] * from);
            return static_cast<std::int32_t>(std::clamp(middle, 0.0, count - 1.0));
        };
        LineIndex column{columnAt(0, old.lineCountU()), columnAt(1, old.lineCountV())};
        while (old.contains(column)) {
            const double u = leaves(ray.origin.x, ray.way.x, column.u), v = leaves(ray.origin.y, ray.way.y, column.v);
            const double end = std::min({u, v, to});
            if (end > from) meet(volume_.line(column), ray, from, end, lines);
            from = std::max(from, end);
            if (end >= to) return;
            if (u <= v)
                column.u += ray.way.x > 0.0 ? 1 : -1;
            else
                column.v += ray.way.y > 0.0 ? 1 : -1;
        }
    }

    /// The intersections within one column.
    static void meet(std::span<const Segment> segments, const OldRay& ray, double from, double to, BrickLines& lines) {
        const double way = ray.way.z, start = ray.origin.z + way * from;
        const auto last = static_cast<double>(segments.back().end()) / unitsPerVoxel;
        if (way == 0.0) {
            put(lines, to, start < 0.0 || start >= last ? airProperty : propertyAt(segments, start));
            return;
        }
        // The grid's ends are treated like segments of air.
        const auto reach = [&](double place, PropertyIndex before) {
            const double at = (place - ray.origin.z) / way;
            if (at > from) put(lines, std::min(at, to), before);
        };
        if (way > 0.0) {
            reach(0.0, airProperty);
            for (const Segment segment : segments)
                reach(static_cast<double>(segment.end()) / unitsPerVoxel, segment.property());
        } else {
            reach(last, airProperty);
            for (std::size_t i = segments.size(); i-- > 0;)
                reach(i > 0 ? static_cast<double>(segments[i - 1].end()) / unitsPerVoxel : 0.0, segments[i].property());
        }
        put(lines, to, airProperty);
    }

    static PropertyIndex propertyAt(std::span<const Segment> segments, double place) noexcept {
        for (const Segment segment : segments)
            if (place * unitsPerVoxel < static_cast<double>(segment.end())) return segment.property();
        return airProperty;
    }

    const VolumeSnapshot& volume_;
    const Grid& grid_;
    Placement back_;
};

Result<RunVolume> scanned(const VolumeSnapshot& volume, const Grid& grid, const Placement& placement,
                          Progress& progress) {
    const Scan scan(volume, grid, placement);
    const std::int32_t rows = (grid.lineCountV() + brickSide - 1) / brickSide;
    ParallelProgress shared(progress, static_cast<std::size_t>(rows));
    return assembleBricks(grid, volume.properties(), [&](std::int32_t row, BrickSink& sink) {
        BrickLines lines(grid.lineEnd());
        for (LineIndex low{0, row * brickSide}; low.u < grid.lineCountU(); low.u += brickSide) {
            if (progress.cancelled()) return;
            lines.clear();
            for (int line = 0; line < linesPerBrick; ++line) {
                const LineIndex index{low.u + line % brickSide, low.v + line / brickSide};
                if (grid.contains(index))
                    scan.read(index, lines);
                else
                    lines.endLine();
            }
            sink.put(low, lines);
        }
        shared.add(1);
    });
}

} // namespace

Result<MovedVolume> moved(const VolumeSnapshot& volume, const Placement& placement, Progress& progress) try {
    const Result<Grid> grid = gridOf(volume.grid(), placement);
    if (!grid) return grid.error();
    Result<RunVolume> result = scanned(volume, *grid, placement, progress);
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "moving", {}, {}};
    if (!result) return std::move(result).error();
    const double displacement = alongAxes(placement) ? 0.0 : std::sqrt(0.5) * grid->edge();
    return MovedVolume{*std::move(result), displacement};
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "moving", {}, {}};
}

} // namespace burin
