// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "core/path/height_map.h"
#include "core/path/part_guard.h"

#include <utility>
#include <vector>

namespace burin {

/// Penetration by rounding of a tool that touches the part, which does not count as a collision, mm.
inline constexpr double touchTolerance = 1e-6;

/// A level route from above one point to above another: straight, or via corners.
struct LinkRoute {
    double height = 0.0; ///< mm
    std::vector<glm::dvec2> corners;
};

/// Where links may go: above the remaining stock according to the height map, clear of part and obstacles.
class LinkRoom {
public:
    /// Keeps a reference to the guard. @param safeHeight mm: nothing is higher
    LinkRoom(const Link& edit, const PartGuard& guard, const PathContext& context, double safeHeight);

    double safeHeight() const noexcept { return safeHeight_; }
    double approach() const noexcept { return approach_; }
    double rounding() const noexcept { return rounding_; } ///< mm; 0: corners stay sharp
    HeightMap& cleared() noexcept { return cleared_; }
    const HeightMap& cleared() const noexcept { return cleared_; }

    /// The route from the end of a stroke to the start of the next one, as the edit requests.
    LinkRoute wayTo(const glm::dvec3& from, const glm::dvec3& to) const;
    /// The same route with its corners rounded on the inside, as far as there is room.
    std::vector<glm::dvec3> rounded(const std::vector<glm::dvec3>& way) const;
    /// The largest upward quarter of a circle that keeps the stroke's distance from the part, the margins of obstacles,
    /// and shank and holder in empty space, with a free way up from its end; only the tip if there is none or the
    /// stroke is not level. @param move from or to the tip @param required mm from the part
    std::vector<glm::dvec3> swing(const glm::dvec3& tip, const glm::dvec3& move, double required) const;
    /// Whether the tool may go straight on at its cutting feed: a short distance, clear of part and obstacles, with
    /// shank and holder in empty space. Material in between is cut by the flutes at their own feed.
    bool canJoin(const glm::dvec3& end, const glm::dvec3& start, double required) const;

private:
    bool mayCut(const std::vector<glm::dvec3>& places, double required) const;
    bool mayPass(const std::vector<glm::dvec3>& places) const;
    bool isClear(const glm::dvec3& from, const glm::dvec3& to) const;
    bool isClearAbove(const glm::dvec3& tip, double height) const;
    bool isClearAcross(const glm::dvec2& from, const glm::dvec2& to, double height) const;
    bool isFree(const glm::dvec3& tip, double spare) const;
    LinkRoute around(const glm::dvec3& from, const glm::dvec3& to) const;

    double approach_; // mm
    Link::Travel travel_;
    double rounding_; // mm
    bool rapidsAreStraight_;
    Box area_;                  // where routes around obstacles may lead
    double safeHeight_, reach_; // mm
    const PartGuard& guard_;
    std::vector<std::pair<PartGuard, double>> obstacles_; // with the margin to keep, mm
    HeightMap cleared_;
};

} // namespace burin
