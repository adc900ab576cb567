// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/guides/guide_axis.h"

#include <cmath>

namespace burin {
namespace {

constexpr double usableGradient = 0.2;
constexpr double smallestAngle = 1e-6; // rad

} // namespace

void GuideAxis::forget() noexcept {
    known_ = false;
    feed_ = normal_ = glm::dvec3(0.0);
}

void GuideAxis::follow(const glm::dvec3& goal) noexcept {
    const glm::dvec3 rope = goal - behind_;
    const double length = glm::length(rope);
    if (length <= feedLength) return;
    feed_ = rope / length;
    behind_ = goal - feed_ * feedLength;
}

glm::dvec3 GuideAxis::wanted(const Guide& guide, const ClearanceField& field, const glm::dvec3& goal) noexcept {
    glm::dvec3 normal = guide.direction;
    if (guide.onSurface) {
        const FieldSample sample = field.at(goal);
        const double steepness = glm::length(sample.gradient);
        if (sample.fine && steepness > usableGradient) normal_ = sample.gradient / steepness;
        if (normal_ != glm::dvec3(0.0)) normal = normal_;
    }
    const glm::dvec3 along = feed_ - normal * glm::dot(normal, feed_);
    const double length = glm::length(along);
    if (length < smallestAngle) return normal; // the tool has not moved yet, or moves along the normal
    const glm::dvec3 forward = along / length, left = glm::cross(normal, forward);
    return std::cos(guide.tilt) * (std::cos(guide.lead) * normal + std::sin(guide.lead) * forward) +
           std::sin(guide.tilt) * left;
}

glm::dvec3 GuideAxis::lean(const Guide* guide, const ClearanceField& field, const ToolPose& hand,
                           const glm::dvec3& goal, double period) noexcept {
    if (!known_) {
        behind_ = goal;
        handAxis_ = hand.axis;
        follower_.forget();
        known_ = true;
    }
    follow(goal);
    const double own = angleBetween(handAxis_, hand.axis);
    handAxis_ = hand.axis;
    return follower_.turn(guide != nullptr ? wanted(*guide, field, goal) : hand.axis, own, period);
}

} // namespace burin
