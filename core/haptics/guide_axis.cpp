// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/guide_axis.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double usableGradient = 0.2;
constexpr double smallestAngle = 1e-6; // rad

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) noexcept {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// `from`, turned towards `to` by at most an angle.
glm::dvec3 turned(const glm::dvec3& from, const glm::dvec3& to, double most) noexcept {
    const double angle = angleBetween(from, to);
    if (angle <= most) return to;
    const glm::dvec3 towards = to - from * glm::dot(from, to);
    const double length = glm::length(towards);
    // Straight opposite: any way round does.
    const glm::dvec3 side = length > smallestAngle   ? towards / length
                            : std::abs(from.x) < 0.7 ? glm::normalize(glm::cross(from, glm::dvec3(1, 0, 0)))
                                                     : glm::normalize(glm::cross(from, glm::dvec3(0, 1, 0)));
    return glm::normalize(from * std::cos(most) + side * std::sin(most));
}

} // namespace

void GuideAxis::forget() noexcept {
    known_ = holds_ = false;
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
    if (length < smallestAngle) return normal; // the tool has not moved yet, or goes straight in
    const glm::dvec3 forward = along / length, left = glm::cross(normal, forward);
    return std::cos(guide.tilt) * (std::cos(guide.lead) * normal + std::sin(guide.lead) * forward) +
           std::sin(guide.tilt) * left;
}

glm::dvec3 GuideAxis::operator()(const Guide* guide, const ClearanceField& field, const ToolPose& hand,
                                 const glm::dvec3& goal, double period) noexcept {
    if (!known_) {
        behind_ = goal;
        axis_ = handAxis_ = hand.axis;
        known_ = true;
    }
    follow(goal);
    const double turn = turningSpeed * period + angleBetween(handAxis_, hand.axis);
    handAxis_ = hand.axis;
    if (guide == nullptr && !holds_) return axis_ = hand.axis;
    axis_ = turned(axis_, guide != nullptr ? wanted(*guide, field, goal) : hand.axis, turn);
    holds_ = guide != nullptr || axis_ != hand.axis;
    return axis_;
}

} // namespace burin
