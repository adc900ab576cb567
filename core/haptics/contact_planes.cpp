// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/contact_planes.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double sameFaceCosine = 0.98;
/// mm; below what a path can tell apart, far above rounding at the size of a workpiece.
constexpr double rounding = 1e-9;

/// Nearest point to `goal` on one plane.
glm::dvec3 onPlane(const ContactPlane& a, const glm::dvec3& goal) noexcept {
    return goal - a.normal * (glm::dot(a.normal, goal) + a.gap);
}

/// Nearest point to `goal` on the line that two planes share; false where they are parallel.
bool onLine(const ContactPlane& a, const ContactPlane& b, const glm::dvec3& goal, glm::dvec3& point) noexcept {
    const double c = glm::dot(a.normal, b.normal);
    const double determinant = 1.0 - c * c;
    if (determinant < 1e-6) return false;
    const double missingA = -a.gap - glm::dot(a.normal, goal), missingB = -b.gap - glm::dot(b.normal, goal);
    const double alongA = (missingA - c * missingB) / determinant, alongB = (missingB - c * missingA) / determinant;
    // A negative multiplier would hold the point at a plane that pulls instead of pushing.
    if (alongA < 0.0 || alongB < 0.0) return false;
    point = goal + a.normal * alongA + b.normal * alongB;
    return true;
}

/// The point that three planes share; false where they share none or a line.
bool atCorner(const ContactPlane& a, const ContactPlane& b, const ContactPlane& c, glm::dvec3& point) noexcept {
    const glm::dvec3 bc = glm::cross(b.normal, c.normal), ca = glm::cross(c.normal, a.normal),
                     ab = glm::cross(a.normal, b.normal);
    const double determinant = glm::dot(a.normal, bc);
    if (std::abs(determinant) < 1e-4) return false;
    point = (-a.gap * bc - b.gap * ca - c.gap * ab) / determinant;
    return true;
}

} // namespace

void ContactPlanes::add(ContactPlane plane) noexcept {
    plane.gap = std::max(plane.gap, 0.0);
    const auto begin = planes_.begin(), end = planes_.begin() + size_;
    const auto same = std::find_if(
        begin, end, [&](const ContactPlane& held) { return glm::dot(held.normal, plane.normal) > sameFaceCosine; });
    if (same != end) {
        *same = plane;
        return;
    }
    if (size_ < capacity) {
        planes_[static_cast<std::size_t>(size_++)] = plane;
        return;
    }
    *std::max_element(begin, end, [](const ContactPlane& a, const ContactPlane& b) { return a.gap < b.gap; }) = plane;
}

bool ContactPlanes::allows(const glm::dvec3& point) const noexcept {
    return std::all_of(planes_.begin(), planes_.begin() + size_, [&](const ContactPlane& plane) {
        return glm::dot(plane.normal, point) >= -plane.gap - rounding;
    });
}

glm::dvec3 ContactPlanes::nearestTo(const glm::dvec3& goal) const noexcept {
    if (allows(goal)) return goal;
    glm::dvec3 best(0.0);
    double bestDistance = glm::dot(goal, goal);
    const auto consider = [&](const glm::dvec3& point) {
        const glm::dvec3 rest = point - goal;
        const double distance = glm::dot(rest, rest);
        if (distance >= bestDistance || !allows(point)) return;
        best = point;
        bestDistance = distance;
    };
    glm::dvec3 point;
    for (int i = 0; i < size_; ++i) {
        consider(onPlane((*this)[i], goal));
        for (int j = i + 1; j < size_; ++j)
            if (onLine((*this)[i], (*this)[j], goal, point)) consider(point);
    }
    if (size_ == capacity && atCorner(planes_[0], planes_[1], planes_[2], point)) consider(point);
    return best;
}

void ContactPlanes::moveOrigin(const glm::dvec3& offset, double clearance) noexcept {
    constexpr double bend = 1e-4; // mm, as fine as the proxy rests at the surface
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
        ContactPlane plane = (*this)[i];
        plane.gap += glm::dot(plane.normal, offset);
        if (plane.gap < clearance - bend) continue;
        plane.gap = std::max(plane.gap, 0.0);
        planes_[static_cast<std::size_t>(kept++)] = plane;
    }
    size_ = kept;
}

} // namespace burin
