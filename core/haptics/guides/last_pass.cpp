// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/guides/last_pass.h"

#include <algorithm>

namespace burin {
namespace {

double distanceToSegment(const glm::dvec3& place, const glm::dvec3& from, const glm::dvec3& to) noexcept {
    const glm::dvec3 way = to - from;
    const double square = glm::dot(way, way);
    const double share = square > 0.0 ? std::clamp(glm::dot(place - from, way) / square, 0.0, 1.0) : 0.0;
    return glm::length(place - from - share * way);
}

double lengthOf(std::span<const glm::dvec3> points) noexcept {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length += glm::length(points[i] - points[i - 1]);
    return length;
}

} // namespace

void LastPass::add(const glm::dvec3& tip) noexcept {
    Pass& pass = underWay();
    if (pass.count == 0) return keep(tip);
    const glm::dvec3 before = waiting_ > 0 ? window_[waiting_ - 1] : pass.points[pass.count - 1];
    if (glm::length(tip - before) < smallestMove) return;
    if (waiting_ == windowCapacity || !straightTo(tip)) keep(before);
    window_[waiting_++] = tip;
}

/// Whether the segment from the last kept point to a tip is within the tolerance of all tips in between.
bool LastPass::straightTo(const glm::dvec3& tip) const noexcept {
    const Pass& pass = passes_[1 - last_];
    const glm::dvec3 from = pass.points[pass.count - 1];
    return std::all_of(window_.begin(), window_.begin() + static_cast<std::ptrdiff_t>(waiting_),
                       [&](const glm::dvec3& place) { return distanceToSegment(place, from, tip) <= tolerance; });
}

void LastPass::keep(const glm::dvec3& tip) noexcept {
    Pass& pass = underWay();
    if (pass.count == 0) pass.errorBound = tolerance + smallestMove;
    if (pass.count == capacity) thin(pass);
    pass.points[pass.count++] = tip;
    waiting_ = 0;
}

/// Drops every second point; the error grows by the distance of the dropped points from the remaining line.
void LastPass::thin(Pass& pass) noexcept {
    double worst = 0.0;
    for (std::size_t i = 1; i + 1 < pass.count; i += 2)
        worst = std::max(worst, distanceToSegment(pass.points[i], pass.points[i - 1], pass.points[i + 1]));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pass.count; i += 2) pass.points[kept++] = pass.points[i];
    if (pass.count % 2 == 0) pass.points[kept++] = pass.points[pass.count - 1];
    pass.count = kept;
    pass.errorBound += worst;
}

void LastPass::finish() noexcept {
    Pass& pass = underWay();
    if (waiting_ > 0) keep(window_[waiting_ - 1]);
    if (pass.count >= 2 && lengthOf({pass.points.data(), pass.count}) >= shortestPass) {
        last_ = 1 - last_;
        ++number_;
    }
    underWay().count = 0;
    waiting_ = 0;
}

void LastPass::forget() noexcept {
    passes_[0].count = passes_[1].count = 0;
    waiting_ = 0;
}

} // namespace burin
