// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/segment_tree.h"

#include "core/geometry/segment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr std::uint32_t leafSize = 4;
constexpr std::size_t mostLevels = 64; // enough, as fewer than 2^32 segments are halved at each level

double squareDistance(const glm::dvec3& point, const Box& box) noexcept {
    const glm::dvec3 apart = glm::max(glm::max(box.low - point, point - box.high), glm::dvec3(0.0));
    return glm::dot(apart, apart);
}

double squareDistance(const glm::dvec3& point, const StraightSegment& segment) noexcept {
    const glm::dvec3 apart = point - nearestOnSegment(point, segment.from, segment.to);
    return glm::dot(apart, apart);
}

int longestAxis(const glm::dvec3& size) noexcept {
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

} // namespace

SegmentTree::SegmentTree(std::vector<StraightSegment> segments) : segments_(std::move(segments)) {
    if (!segments_.empty()) divide(0, static_cast<std::uint32_t>(segments_.size()));
}

void SegmentTree::divide(std::uint32_t first, std::uint32_t end) {
    Box box, middles;
    for (std::uint32_t i = first; i < end; ++i) {
        box.include(segments_[i].from);
        box.include(segments_[i].to);
        middles.include(segments_[i].from + segments_[i].to);
    }
    const std::size_t own = nodes_.size();
    nodes_.push_back({box, first, end - first, 0});
    if (end - first <= leafSize) return;
    const int axis = longestAxis(middles.size());
    const std::uint32_t half = first + (end - first) / 2;
    const auto at = [&](std::uint32_t i) { return segments_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(half), at(end), [axis](const StraightSegment& a, const StraightSegment& b) {
        return a.from[axis] + a.to[axis] < b.from[axis] + b.to[axis];
    });
    nodes_[own].count = 0;
    divide(first, half);
    nodes_[own].second = static_cast<std::uint32_t>(nodes_.size());
    divide(half, end);
}

double SegmentTree::distance(const glm::dvec3& point, std::uint32_t& near) const noexcept {
    double least = squareDistance(point, segments_[near]);
    struct Open {
        std::uint32_t node;
        double square;
    };
    std::array<Open, mostLevels> open{};
    std::size_t depth = 0;
    open[depth++] = {0, squareDistance(point, nodes_[0].box)};
    while (depth > 0) {
        const Open next = open[--depth];
        if (next.square >= least) continue;
        const Node& node = nodes_[next.node];
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (const double square = squareDistance(point, segments_[i]); square < least) {
                least = square;
                near = i;
            }
        if (node.count > 0) continue;
        Open a{next.node + 1, squareDistance(point, nodes_[next.node + 1].box)};
        Open b{node.second, squareDistance(point, nodes_[node.second].box)};
        if (a.square < b.square) std::swap(a, b);
        open[depth++] = a;
        open[depth++] = b; // on top: the nearer one is visited first
    }
    return std::sqrt(least);
}

} // namespace burin
