// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/cylinder_stock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace burin {

namespace {

/// An interval of a line's parameter.
struct Interval {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();

    void cutTo(double low, double high) noexcept {
        from = std::max(from, low);
        to = std::min(to, high);
    }
};

/// Clips the interval to where from + t · way, both relative to the base, lies between the end faces. Returns false if
/// nowhere.
bool cutToEnds(const CylinderShape& cylinder, const glm::dvec3& from, const glm::dvec3& way, Interval& interval) {
    const double rise = glm::dot(way, cylinder.axis), start = glm::dot(from, cylinder.axis);
    if (rise == 0.0) return start >= 0.0 && start <= cylinder.height;
    const double low = -start / rise, high = (cylinder.height - start) / rise;
    interval.cutTo(std::min(low, high), std::max(low, high));
    return true;
}

/// Clips the interval to where the line lies within the radius. Returns false if nowhere.
bool cutToSide(const CylinderShape& cylinder, const glm::dvec3& from, const glm::dvec3& way, Interval& interval) {
    const glm::dvec3 across = from - glm::dot(from, cylinder.axis) * cylinder.axis;
    const glm::dvec3 slope = way - glm::dot(way, cylinder.axis) * cylinder.axis;
    const double a = glm::dot(slope, slope), b = glm::dot(across, slope);
    const double c = glm::dot(across, across) - cylinder.radius * cylinder.radius;
    constexpr double parallel = 1e-24; // of unit vectors: the line is parallel to the axis
    if (a < parallel) return c <= 0.0;
    const double discriminant = b * b - a * c;
    if (discriminant <= 0.0) return false;
    const double half = std::sqrt(discriminant);
    interval.cutTo((-b - half) / a, (-b + half) / a);
    return true;
}

std::optional<Interval> within(const CylinderShape& cylinder, const glm::dvec3& from, const glm::dvec3& way) {
    Interval interval;
    const glm::dvec3 start = from - cylinder.base;
    if (!cutToEnds(cylinder, start, way, interval) || !cutToSide(cylinder, start, way, interval)) return std::nullopt;
    return interval.from < interval.to ? std::optional(interval) : std::nullopt;
}

} // namespace

Box boxAround(const CylinderShape& cylinder) {
    const glm::dvec3 end = cylinder.base + cylinder.height * cylinder.axis;
    const glm::dvec3 reach =
        cylinder.radius * glm::sqrt(glm::max(1.0 - cylinder.axis * cylinder.axis, glm::dvec3(0.0)));
    return {glm::min(cylinder.base, end) - reach, glm::max(cylinder.base, end) + reach};
}

bool fillCylinder(RunVolume& volume, const CylinderShape& cylinder, PropertyIndex property) {
    const Grid& grid = volume.grid();
    const int runs = grid.axisOfRuns();
    glm::dvec3 way(0.0);
    way[runs] = 1.0;
    const double low = grid.toMillimetres(0), high = grid.toMillimetres(grid.lineEnd());
    for (LineIndex line{0, 0}; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            const glm::dvec2 centre = grid.lineCentre(line);
            glm::dvec3 from(0.0);
            from[grid.axisOfU()] = centre.x;
            from[grid.axisOfV()] = centre.y;
            std::optional<Interval> interval = within(cylinder, from, way);
            if (!interval) continue;
            interval->cutTo(low, high);
            if (interval->from >= interval->to) continue;
            const RunPosition begin = grid.toRunPosition(interval->from), end = grid.toRunPosition(interval->to);
            if (begin < end && !volume.fillSpan(line, begin, end, property)) return false;
        }
    return true;
}

} // namespace burin
