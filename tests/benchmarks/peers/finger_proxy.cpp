// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/peers/finger_proxy.h"

#include <algorithm>
#include <cmath>

namespace burin::benchmarks {

namespace {

constexpr double skin = 1e-4; // mm of distance kept from what was touched
constexpr double nearlyNone = 1e-12;

/// The least root of a t² + 2 b t + c = 0, at which the sphere enters; nullopt if it never does.
std::optional<double> entry(double a, double b, double c) {
    if (!(a > nearlyNone) || b >= 0.0) return std::nullopt; // it moves away
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0) return std::nullopt;
    return (-b - std::sqrt(discriminant)) / a;
}

} // namespace

/// Only surfaces that it moves against count; a surface that it touches already is contacted at once.
void FingerProxy::take(double share, const glm::dvec3& normal, const glm::dvec3& way, std::optional<Contact>& first) {
    if (!(share <= 1.0) || glm::dot(normal, way) >= 0.0) return;
    const double length = glm::length(way);
    if (share * length < -10.0 * skin) return; // it is behind the sphere
    const double bounded = std::max(0.0, share);
    if (!first || bounded < first->share) first = Contact{bounded, normal};
}

void FingerProxy::meetFace(const Triangle& triangle, const glm::dvec3& way, std::optional<Contact>& first) const {
    const glm::dvec3 area = areaNormal(triangle);
    const double size = glm::length(area);
    if (!(size > nearlyNone)) return;
    const glm::dvec3 normal = area / size;
    const double approach = glm::dot(way, normal);
    if (!(approach < 0.0)) return;
    const double share = (radius_ - glm::dot(centre_ - triangle[0], normal)) / approach;
    const glm::dvec3 touched = centre_ + share * way - radius_ * normal;
    for (std::size_t i = 0; i < 3; ++i)
        if (glm::dot(glm::cross(triangle[(i + 1) % 3] - triangle[i], touched - triangle[i]), normal) < 0.0) return;
    take(share, normal, way, first);
}

void FingerProxy::meetEdge(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& way,
                           std::optional<Contact>& first) const {
    const glm::dvec3 edge = to - from;
    const double squared = glm::dot(edge, edge);
    if (!(squared > nearlyNone)) return;
    const auto across = [&](const glm::dvec3& v) { return v - edge * (glm::dot(v, edge) / squared); };
    const glm::dvec3 start = across(centre_ - from), motion = across(way);
    const auto share =
        entry(glm::dot(motion, motion), glm::dot(start, motion), glm::dot(start, start) - radius_ * radius_);
    if (!share) return;
    const glm::dvec3 at = centre_ + *share * way;
    const double along = glm::dot(at - from, edge) / squared;
    if (along < 0.0 || along > 1.0) return;
    take(*share, glm::normalize(at - from - along * edge), way, first);
}

void FingerProxy::meetCorner(const glm::dvec3& corner, const glm::dvec3& way, std::optional<Contact>& first) const {
    const glm::dvec3 start = centre_ - corner;
    const auto share = entry(glm::dot(way, way), glm::dot(start, way), glm::dot(start, start) - radius_ * radius_);
    if (share) take(*share, glm::normalize(start + *share * way), way, first);
}

void FingerProxy::meet(const Triangle& triangle, const glm::dvec3& way, std::optional<Contact>& first) const {
    meetFace(triangle, way, first);
    for (std::size_t i = 0; i < 3; ++i) {
        meetEdge(triangle[i], triangle[(i + 1) % 3], way, first);
        meetCorner(triangle[i], way, first);
    }
}

std::optional<FingerProxy::Contact> FingerProxy::firstContact(const glm::dvec3& way) {
    part_.trianglesNear(centre_ + 0.5 * way, radius_ + 0.5 * glm::length(way) + 10.0 * skin, near_);
    std::optional<Contact> first;
    for (const std::uint32_t number : near_) meet(part_.triangles()[number], way, first);
    return first;
}

const glm::dvec3& FingerProxy::advance(const glm::dvec3& goal) {
    std::array<glm::dvec3, 3> planes{};
    glm::dvec3 target = goal;
    for (std::size_t count = 0; count < 3;) {
        const glm::dvec3 way = target - centre_;
        const double length = glm::length(way);
        if (!(length > nearlyNone)) break;
        const std::optional<Contact> contact = firstContact(way);
        if (!contact) {
            centre_ = target;
            break;
        }
        centre_ += way * std::max(0.0, contact->share - skin / length);
        planes[count++] = contact->normal;
        const glm::dvec3 request = goal - centre_;
        if (count == 1) target = centre_ + request - planes[0] * std::min(0.0, glm::dot(request, planes[0]));
        if (count == 2) {
            const glm::dvec3 line = glm::cross(planes[0], planes[1]);
            const double squared = glm::dot(line, line);
            if (!(squared > 1e-9)) break; // the same plane again
            target = centre_ + line * (glm::dot(request, line) / squared);
        }
    }
    return centre_;
}

} // namespace burin::benchmarks
