// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace burin {

/// Segments in plan, sorted into squares, so that those near a point are found without looking at all of them.
class NearSegments {
public:
    /// @param edge of a square, mm: about the distance that is asked for
    explicit NearSegments(double edge) : edge_(edge) {}

    void add(const glm::dvec2& from, const glm::dvec2& to);
    void addRing(const PlanRing& ring);
    /// Whether a segment is nearer to a point than a distance, mm. Any number of threads may ask.
    bool anyWithin(const glm::dvec2& place, double distance) const noexcept;
    /// The nearest point of all segments, if it is nearer than a distance, mm. Any number of threads may ask.
    std::optional<glm::dvec2> nearestWithin(const glm::dvec2& place, double distance) const noexcept;

private:
    /// Visits segments, at least those nearer than a distance, until `visit` returns true; returns whether it did.
    template <class Visit>
    bool visitNear(const glm::dvec2& place, double distance, const Visit& visit) const;
    std::int64_t squareOf(const glm::ivec2& square) const noexcept {
        return (static_cast<std::int64_t>(square.x) << 32) ^ (square.y & 0xffffffffLL);
    }
    glm::ivec2 squareAt(const glm::dvec2& place) const noexcept { return glm::ivec2(glm::floor(place / edge_)); }

    double edge_;
    std::vector<std::pair<glm::dvec2, glm::dvec2>> segments_;
    std::unordered_map<std::int64_t, std::vector<std::uint32_t>> squares_;
};

} // namespace burin
