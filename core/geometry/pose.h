// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace burin {

inline bool isFinite(const glm::dvec3& v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// `v`, shortened to `maximum` if it is longer, with the same direction.
inline glm::dvec3 clampLength(const glm::dvec3& v, double maximum) noexcept {
    const double length = glm::length(v);
    return length > maximum ? v * (maximum / length) : v;
}

/// Pose of a tool: the position of its tip and the direction of its axis, from the tip towards the holder. A cutter of
/// revolution needs no rotation about that axis.
struct ToolPose {
    glm::dvec3 tip{0.0};            ///< mm, setup frame
    glm::dvec3 axis{0.0, 0.0, 1.0}; ///< unit length, setup frame
};

/// Pose of a six-degree-of-freedom input. `rotation` takes the tool frame (tip at the origin, axis +Z towards the
/// holder) to the frame that `position` is given in.
struct Pose {
    glm::dvec3 position{0.0};                             ///< mm
    glm::dquat rotation = glm::dquat(1.0, 0.0, 0.0, 0.0); ///< unit quaternion (w, x, y, z)
};

inline ToolPose toolPose(const Pose& pose) noexcept {
    return {pose.position, pose.rotation * glm::dvec3(0.0, 0.0, 1.0)};
}

} // namespace burin
