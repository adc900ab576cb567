// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/pose_steps.h"

#include "core/geometry/frame_along.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double mostSteps = 1 << 30; // far beyond any reasonable tool and tolerance

} // namespace

double reachOf(std::span<const RevolvedPiece> pieces) noexcept {
    double reach = 0.0;
    for (const RevolvedPiece& piece : pieces) {
        const double height = std::max(std::abs(piece.bottom), std::abs(piece.top));
        reach = std::max(reach, std::hypot(piece.widestRadius(), height));
    }
    return reach;
}

PoseSteps::PoseSteps(const ToolPose& from, const ToolPose& to, double reach, double tolerance) noexcept
    : from_(from), to_(to) {
    if (!isFinite(from.tip) || !isFinite(to.tip) || !isFinite(from.axis) || !isFinite(to.axis)) return;
    count_ = 1;
    if (from.axis == to.axis) return;
    const glm::dvec3 normal = glm::cross(from.axis, to.axis);
    const double sine = glm::length(normal);
    angle_ = std::atan2(sine, glm::dot(from.axis, to.axis));
    turning_ = sine > 1e-12 ? glm::cross(normal, from.axis) / sine : anyAcross(from.axis);
    // A step's axis is off by at most half the rotation of a step; a point is then off by less than that angle times
    // its reach.
    const double steps = std::ceil(0.5 * angle_ * reach / tolerance);
    count_ = 1 + static_cast<std::int32_t>(std::clamp(steps, 1.0, mostSteps));
}

ToolPose PoseSteps::poseAt(double part) const noexcept {
    if (part <= 0.0) return from_;
    if (part >= 1.0) return to_;
    const glm::dvec3 tip = from_.tip + part * (to_.tip - from_.tip);
    if (angle_ == 0.0) return {tip, from_.axis};
    return {tip, std::cos(part * angle_) * from_.axis + std::sin(part * angle_) * turning_};
}

PoseStep PoseSteps::step(std::int32_t k) const noexcept {
    if (count_ == 1) return {from_.tip, to_.tip, from_.axis};
    const double turns = count_ - 1;
    return {poseAt((k - 0.5) / turns).tip, poseAt((k + 0.5) / turns).tip, poseAt(k / turns).axis};
}

} // namespace burin
