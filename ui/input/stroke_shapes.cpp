// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/stroke_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr double leastExtent = 1e-3; // mm: shorter lines have no direction

glm::dvec3 level(const glm::dvec3& way) {
    return {way.x, way.y, 0.0};
}

int piecesOf(double length, double spacing) {
    return std::max(1, static_cast<int>(std::ceil(length / spacing - 1e-9)));
}

/// Values at the points of a line, and at points between them that are at most `spacing` apart.
std::vector<glm::dvec3> mixedAlong(const std::vector<glm::dvec3>& line, const std::vector<glm::dvec3>& values,
                                   double spacing) {
    std::vector<glm::dvec3> mixed;
    if (!line.empty()) mixed.push_back(values.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
        const int pieces = piecesOf(glm::distance(line[i - 1], line[i]), spacing);
        for (int k = 1; k < pieces; ++k)
            mixed.push_back(glm::mix(values[i - 1], values[i], static_cast<double>(k) / pieces));
        mixed.push_back(values[i]);
    }
    return mixed;
}

} // namespace

std::vector<glm::dvec3> rasterRows(const glm::dvec3& corner, const glm::dvec3& opposite, double stepOver) {
    const glm::dvec3 size = level(opposite - corner);
    const bool alongX = std::abs(size.x) >= std::abs(size.y);
    const glm::dvec3 row = alongX ? glm::dvec3(size.x, 0.0, 0.0) : glm::dvec3(0.0, size.y, 0.0);
    const glm::dvec3 across = size - row;
    const double width = glm::length(across);
    const int gaps = width < leastExtent ? 0 : piecesOf(width, stepOver);
    std::vector<glm::dvec3> ends;
    ends.reserve(2 * (static_cast<std::size_t>(gaps) + 1));
    for (int i = 0; i <= gaps; ++i) {
        const glm::dvec3 begin = corner + across * (gaps == 0 ? 0.0 : static_cast<double>(i) / gaps);
        const bool there = i % 2 == 0;
        ends.push_back(there ? begin : begin + row);
        ends.push_back(there ? begin + row : begin);
    }
    return ends;
}

double subdividedCount(const std::vector<glm::dvec3>& line, double spacing) {
    double count = line.empty() ? 0.0 : 1.0;
    for (std::size_t i = 1; i < line.size(); ++i) count += 1.0 + glm::distance(line[i - 1], line[i]) / spacing;
    return count;
}

std::vector<glm::dvec3> subdivided(const std::vector<glm::dvec3>& line, double spacing) {
    return mixedAlong(line, line, spacing);
}

std::vector<glm::dvec3> subdividedAxes(const std::vector<glm::dvec3>& line, const std::vector<glm::dvec3>& axes,
                                       double spacing) {
    std::vector<glm::dvec3> mixed = mixedAlong(line, axes, spacing);
    for (glm::dvec3& axis : mixed) axis = glm::normalize(axis);
    return mixed;
}

std::optional<glm::dvec3> acrossOf(const std::vector<glm::dvec3>& line) {
    glm::dvec3 farthest(0.0);
    for (const glm::dvec3& place : line) {
        const glm::dvec3 way = level(place - line.front());
        if (glm::length(way) > glm::length(farthest)) farthest = way;
    }
    if (glm::length(farthest) < leastExtent) return std::nullopt;
    return glm::normalize(glm::dvec3(-farthest.y, farthest.x, 0.0));
}

std::optional<glm::dvec3> directionAtEnd(const std::vector<glm::dvec3>& line, double length) {
    for (std::size_t i = line.size(); i-- > 0;) {
        const glm::dvec3 way = level(line.back() - line[i]);
        if (glm::length(way) >= length) return glm::normalize(way);
    }
    return std::nullopt;
}

glm::dvec3 locked(StrokeLock lock, const glm::dvec3& anchor, const glm::dvec3& direction, const glm::dvec3& place) {
    switch (lock) {
    case StrokeLock::none:
        return place;
    case StrokeLock::alongX:
        return {place.x, anchor.y, place.z};
    case StrokeLock::alongY:
        return {anchor.x, place.y, place.z};
    case StrokeLock::direction:
        break;
    }
    const double way = glm::dot(level(place - anchor), direction);
    return {anchor.x + way * direction.x, anchor.y + way * direction.y, place.z};
}

} // namespace burin
