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

/// The kind of motion to a point.
enum class MoveKind : std::uint8_t {
    rapid,  ///< no contact with the workpiece
    plunge, ///< feed downwards into or close above material
    cut,    ///< cutting feed
    retract ///< feed away from material, upwards
};

/// An arc of a circle, or a helix of at most one turn, about an axis of the frame, as described at Arc
/// (core/geometry/arc.h).
struct PathArc {
    glm::dvec3 centre{0.0}; ///< mm, setup frame; its component along the axis is ignored
    int axis = 2;           ///< 0 X, 1 Y, 2 Z
    bool clockwise = false; ///< seen against the axis

    friend bool operator==(const PathArc&, const PathArc&) = default;
};

/// A point that the machine moves to from the point before: in a straight line, or along an arc.
struct PathPoint {
    ToolPose pose;                    ///< setup frame
    MoveKind kind = MoveKind::cut;    ///< of the move that ends here
    double feed = 0.0;                ///< mm/min; 0: not set yet, and for rapids
    std::int64_t source = 0;          ///< PathSource::id of its moment; 0: made by an edit
    std::int64_t sample = -1;         ///< Moment::tick within the source; -1: made by an edit
    std::optional<PathArc> arc{};     ///< empty: straight; never for a rapid
    double spindleSpeed = 0.0;        ///< 1/min, for a move other than a rapid; 0: that of the path
    std::optional<Coolant> coolant{}; ///< for a move other than a rapid; empty: that of the path
};

/// The length of the move to a point, mm.
double lengthOf(const glm::dvec3& from, const PathPoint& to) noexcept;

/// The motion of the machine with one tool, axis +Z.
struct Path {
    std::string name;
    std::string toolId;
    double spindleSpeed = 0.0;      ///< 1/min, for points without a speed of their own
    Coolant coolant = Coolant::off; ///< for points without a coolant of their own
    /// mm/min, limit down to which feeds may be reduced where the check of a program finds more load than spindle and
    /// tool bear; 0: feeds stay as they are.
    double leastFeed = 0.0;
    std::vector<PathPoint> points;
};

/// Returns the spindle speed of the move to a point, 1/min. @param ofPath for a point without a speed of its own
inline double speedOf(const PathPoint& point, double ofPath) noexcept {
    return point.spindleSpeed > 0.0 ? point.spindleSpeed : ofPath;
}
inline double speedOf(const Path& path, const PathPoint& point) noexcept {
    return speedOf(point, path.spindleSpeed);
}
/// Returns the coolant of the move to a point.
inline Coolant coolantOf(const Path& path, const PathPoint& point) noexcept {
    return point.coolant.value_or(path.coolant);
}

} // namespace burin
