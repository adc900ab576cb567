// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/coolant.h"
#include "core/geometry/pose.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// How the machine gets to a point.
enum class MoveKind : std::uint8_t {
    rapid,  ///< no contact with the workpiece
    plunge, ///< feed downwards into or close above material
    cut,    ///< cutting feed
    retract ///< feed away from material, upwards
};

/// How a move turns on its way: an arc of a circle, or a helix of at most one turn, about an axis of the frame, as
/// Arc (core/geometry/arc.h) has it.
struct PathArc {
    glm::dvec3 centre{0.0}; ///< mm, setup frame; its component along the axis has no meaning
    int axis = 2;           ///< 0 X, 1 Y, 2 Z
    bool clockwise = false; ///< seen against the axis

    friend bool operator==(const PathArc&, const PathArc&) = default;
};

/// A place that the machine goes to from the point before: in a straight line, or along an arc.
struct PathPoint {
    ToolPose pose;                 ///< setup frame
    MoveKind kind = MoveKind::cut; ///< of the move that ends here
    double feed = 0.0;             ///< mm/min; 0: not decided yet, and for rapids
    std::int64_t source = 0;       ///< PathSource::id of the moment behind it; 0: made by an edit
    std::int64_t sample = -1;      ///< Moment::tick within the source; -1: made by an edit
    std::optional<PathArc> arc{};  ///< nothing: straight; never a rapid
    double spindleSpeed = 0.0;     ///< 1/min, of a move that is no rapid; 0: the path's
};

/// mm, of the move to a point.
double lengthOf(const glm::dvec3& from, const PathPoint& to) noexcept;

/// What the machine shall do with one tool, axis +Z.
struct Path {
    std::string name;
    std::string toolId;
    double spindleSpeed = 0.0; ///< 1/min, where its points state none of their own
    Coolant coolant = Coolant::off;
    /// mm/min, down to which feeds may come where the check of a program finds more load than spindle and tool bear; 0:
    /// they stay as they are.
    double leastFeed = 0.0;
    std::vector<PathPoint> points;
};

} // namespace burin
