// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/ray_cast.h"

#include "core/geometry/pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A ray in the grid's own frame: u, v in scanlines, along the runs in voxels, relative to the grid's low corner.
struct LocalRay {
    glm::dvec3 origin, way; ///< `way` per millimetre of the ray
};

LocalRay localRay(const Grid& grid, const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 from = (origin - grid.low()) / grid.edge(), way = glm::normalize(direction) / grid.edge();
    const std::array axes{grid.axisOfU(), grid.axisOfV(), grid.axisOfRuns()};
    return {{from[axes[0]], from[axes[1]], from[axes[2]]}, {way[axes[0]], way[axes[1]], way[axes[2]]}};
}

bool isRay(const LocalRay& ray) noexcept {
    return isFinite(ray.origin) && isFinite(ray.way) && ray.way != glm::dvec3(0.0);
}

/// Part of a ray, by its distance from the origin.
struct Interval {
    double from = 0.0, to = never;
    void clip(double origin, double way, double low, double high) {
        if (way == 0.0) {
            if (origin < low || origin > high) to = -1.0;
            return;
        }
        const double a = (low - origin) / way, b = (high - origin) / way;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
};

/// The first intersection of a ray with a scanline's runs between two distances.
class LineTest {
public:
    LineTest(const VolumeSnapshot& workpiece, const LocalRay& ray, RayTarget target)
        : workpiece_(workpiece), ray_(ray), target_(target) {}

    struct Meeting {
        double distance = never;
        PropertyIndex property = airProperty;
    };

    Meeting first(LineIndex line, Interval within) const {
        Meeting found;
        double begin = 0.0;
        for (const Segment segment : workpiece_.line(line)) {
            const double end = static_cast<double>(segment.end()) / unitsPerVoxel;
            Interval inside = within;
            inside.clip(ray_.origin.z, ray_.way.z, begin, end);
            begin = end;
            if (!stops(segment.property()) || inside.from > inside.to || inside.from >= found.distance) continue;
            found = {inside.from, segment.property()};
        }
        return found;
    }

private:
    bool stops(PropertyIndex property) const {
        return property != airProperty &&
               (target_ == RayTarget::anything || workpiece_.properties().isProtected(property));
    }

    const VolumeSnapshot& workpiece_;
    const LocalRay& ray_;
    RayTarget target_;
};

/// Iterates along one axis across the runs: the current column, and where the next one begins.
struct Walk {
    std::int32_t column = 0, step = 0;
    double next = never; ///< distance

    Walk(double origin, double way, double start, std::int32_t count) {
        const double at = origin + way * start;
        column = static_cast<std::int32_t>(std::clamp(std::floor(at), 0.0, count - 1.0));
        if (way == 0.0) return;
        step = way > 0.0 ? 1 : -1;
        findNext(origin, way);
    }
    void advance(double origin, double way) {
        column += step;
        findNext(origin, way);
    }

private:
    void findNext(double origin, double way) { next = (column + (step > 0 ? 1 : 0) - origin) / way; }
};

/// Visits the scanlines that a ray passes, in order, each with the part of the ray in its column, until `visit` returns
/// false. @param reach mm
template <typename Visit>
void visitLines(const Grid& grid, const LocalRay& ray, double reach, const Visit& visit) {
    Interval inGrid{0.0, reach};
    inGrid.clip(ray.origin.x, ray.way.x, 0.0, grid.lineCountU());
    inGrid.clip(ray.origin.y, ray.way.y, 0.0, grid.lineCountV());
    inGrid.clip(ray.origin.z, ray.way.z, 0.0, grid.voxelsPerLine());
    if (inGrid.from > inGrid.to) return;
    Walk alongU(ray.origin.x, ray.way.x, inGrid.from, grid.lineCountU());
    Walk alongV(ray.origin.y, ray.way.y, inGrid.from, grid.lineCountV());
    for (double from = inGrid.from; grid.contains(LineIndex{alongU.column, alongV.column});) {
        const double to = std::min({alongU.next, alongV.next, inGrid.to});
        if (!visit(LineIndex{alongU.column, alongV.column}, Interval{from, to}) || to >= inGrid.to) return;
        if (alongU.next <= alongV.next)
            alongU.advance(ray.origin.x, ray.way.x);
        else
            alongV.advance(ray.origin.y, ray.way.y);
        from = std::max(from, to);
    }
}

/// Adds an interval that begins where the last one ends, or later.
void append(std::vector<RayInterval>& intervals, const RayInterval& next, double closed) {
    if (!intervals.empty() && next.from <= intervals.back().to + closed)
        intervals.back().to = std::max(intervals.back().to, next.to);
    else
        intervals.push_back(next);
}

} // namespace

std::optional<RayHit> castRay(const VolumeSnapshot& workpiece, const glm::dvec3& origin, const glm::dvec3& direction,
                              RayTarget target) {
    const Grid& grid = workpiece.grid();
    const LocalRay ray = localRay(grid, origin, direction);
    if (!isRay(ray)) return std::nullopt;
    const LineTest test(workpiece, ray, target);
    std::optional<RayHit> hit;
    visitLines(grid, ray, never, [&](LineIndex line, const Interval& within) {
        const LineTest::Meeting meeting = test.first(line, within);
        if (meeting.property == airProperty) return true;
        hit = RayHit{origin + glm::normalize(direction) * meeting.distance, meeting.distance, meeting.property};
        return false;
    });
    return hit;
}

std::vector<RayInterval> materialAlong(const VolumeSnapshot& workpiece, const glm::dvec3& origin,
                                       const glm::dvec3& direction, double reach) {
    const Grid& grid = workpiece.grid();
    const LocalRay ray = localRay(grid, origin, direction);
    std::vector<RayInterval> all, ofLine;
    if (!isRay(ray)) return all;
    const double closed = grid.edge() / (4.0 * unitsPerVoxel); // rounding errors where the ray changes the column
    visitLines(grid, ray, reach, [&](LineIndex line, const Interval& within) {
        ofLine.clear();
        double begin = 0.0;
        for (const Segment segment : workpiece.line(line)) {
            const double end = static_cast<double>(segment.end()) / unitsPerVoxel;
            Interval inside = within;
            inside.clip(ray.origin.z, ray.way.z, begin, end);
            begin = end;
            if (segment.property() != airProperty && inside.from <= inside.to)
                ofLine.push_back({inside.from, inside.to});
        }
        if (ray.way.z < 0.0) std::ranges::reverse(ofLine);
        for (const RayInterval& interval : ofLine) append(all, interval, closed);
        return true;
    });
    return all;
}

double highestWithin(const VolumeSnapshot& workpiece, const glm::dvec2& place, double radius) {
    const Grid& grid = workpiece.grid();
    const glm::dvec2 low(grid.low()[grid.axisOfU()], grid.low()[grid.axisOfV()]);
    const glm::dvec2 centre = (place - low) / grid.edge();
    const double reach = radius / grid.edge();
    RunPosition highest = 0;
    if (!isFinite(glm::dvec3(centre, reach))) return grid.toMillimetres(highest);
    const glm::dvec2 lines(grid.lineCountU(), grid.lineCountV()), none(0.0);
    const glm::ivec2 first(glm::clamp(glm::floor(centre - reach), none, lines));
    const glm::ivec2 last(glm::clamp(glm::floor(centre + reach), none - 1.0, lines - 1.0));
    for (std::int32_t v = first.y; v <= last.y; ++v)
        for (std::int32_t u = first.x; u <= last.x; ++u) {
            const glm::dvec2 nearest = glm::clamp(centre, glm::dvec2(u, v), glm::dvec2(u + 1, v + 1));
            if (glm::length(nearest - centre) > reach) continue;
            for (const Segment segment : workpiece.line({u, v}))
                if (segment.property() != airProperty) highest = std::max(highest, segment.end());
        }
    return grid.toMillimetres(highest);
}

} // namespace burin
