// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/cleared_heights.h"
#include "core/path/evaluate.h"
#include "core/path/part_guard.h"

#include <utility>
#include <vector>

namespace burin {

/// A tool that lies on the part by rounding does not enter it, mm.
inline constexpr double touchTolerance = 1e-6;

/// A level route from above one point to above another: straight, or by corners.
struct LinkRoute {
    double height = 0.0; ///< mm
    std::vector<glm::dvec2> corners;
};

/// Where links may lead: above what the height map says is left, clear of part and obstacles.
class LinkRoom {
public:
    /// Keeps a reference to the guard. @param safeHeight mm: nothing stands higher
    LinkRoom(const Link& edit, const PartGuard& guard, const PathContext& context, double safeHeight);

    double safeHeight() const noexcept { return safeHeight_; }
    double approach() const noexcept { return approach_; }
    double rounding() const noexcept { return rounding_; } ///< mm; 0: corners stay sharp
    ClearedHeights& cleared() noexcept { return cleared_; }
    const ClearedHeights& cleared() const noexcept { return cleared_; }

    /// From the end of a stroke to the start of the next one, as the edit asks for.
    LinkRoute wayTo(const glm::dvec3& from, const glm::dvec3& to) const;
    /// The same route with its corners rounded inside, as far as there is room.
    std::vector<glm::dvec3> rounded(const std::vector<glm::dvec3>& way) const;
    /// The largest quarter of a circle up that keeps what the stroke keeps from the part, the margin of obstacles,
    /// shank and holder in empty space, and a free way up from its end; the tip alone where there is none or the stroke
    /// is not level. @param move from or to the tip  @param required mm from the part
    std::vector<glm::dvec3> swing(const glm::dvec3& tip, const glm::dvec3& move, double required) const;
    /// Whether the tool may go straight on at its cutting feed: not far, clear of part and obstacles, and shank and
    /// holder in empty space. What lies in between meets the flutes at the feed that is theirs.
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
    Box area_;                  // where ways round may lead
    double safeHeight_, reach_; // mm
    const PartGuard& guard_;
    std::vector<std::pair<PartGuard, double>> obstacles_; // with the margin to keep, mm
    ClearedHeights cleared_;
};

} // namespace burin
