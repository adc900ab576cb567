// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/envelope_boundary.h"

#include "core/cutting/pose_steps.h"

#include <limits>
#include <utility>

namespace burin {
namespace {

glm::dvec3 unitAlong(int axis, double sign) noexcept {
    glm::dvec3 unit(0.0);
    unit[axis] = sign;
    return unit;
}

/// Distance in mm from a point to the face of a box in the given direction.
double toFace(const Box& box, int axis, double sign, const glm::dvec3& point) noexcept {
    return sign > 0.0 ? box.high[axis] - point[axis] : point[axis] - box.low[axis];
}

glm::dvec3 farthestPoint(const RevolvedPiece& piece, const ToolPose& pose, const glm::dvec3& direction) noexcept {
    const double axial = glm::dot(direction, pose.axis);
    const glm::dvec3 across = direction - axial * pose.axis;
    const double radial = glm::length(across);
    const ProfilePoint ring = farthestIn(piece, radial, axial);
    // A smaller value is a rounding error, and its direction may be along the axis.
    const glm::dvec3 outwards = radial > 1e-9 ? across / radial : glm::dvec3(0.0);
    return pose.tip + ring.height * pose.axis + ring.radius * outwards;
}

} // namespace

EnvelopeBoundary::EnvelopeBoundary(const Envelope& envelope, std::vector<RevolvedPiece> tool, double voxel)
    : envelope_(envelope)
    , tool_(std::move(tool))
    , voxel_(voxel)
    , reach_(envelope.tools.empty() ? 0.0 : reachOf(tool_)) {}

/// A box has no features that could be missed: if both ends of a motion are inside, so is the motion.
double EnvelopeBoundary::overlap() const noexcept {
    return std::numeric_limits<double>::infinity();
}

PoseSample EnvelopeBoundary::at(const ToolPose& pose, double enough) noexcept {
    PoseSample sample{enough, glm::dvec3(0.0), glm::dvec3(0.0), false};
    const auto consider = [&](double clearance, const glm::dvec3& inwards, const glm::dvec3& point) {
        if (!(clearance < sample.clearance)) return;
        const glm::dvec3 turning = glm::cross(point - pose.tip, inwards);
        sample = {clearance, inwards, turning - glm::dot(turning, pose.axis) * pose.axis, true};
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            const glm::dvec3 outwards = unitAlong(axis, sign);
            if (!envelope_.tips.empty()) consider(toFace(envelope_.tips, axis, sign, pose.tip), -outwards, pose.tip);
            if (envelope_.tools.empty()) continue;
            for (const RevolvedPiece& piece : tool_) {
                const glm::dvec3 point = farthestPoint(piece, pose, outwards);
                consider(toFace(envelope_.tools, axis, sign, point), -outwards, point);
            }
        }
    return sample;
}

} // namespace burin
