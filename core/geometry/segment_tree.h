// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <cstdint>
#include <vector>

namespace burin {

/// From one place to another, straight, mm.
struct StraightSegment {
    glm::dvec3 from{0.0}, to{0.0};
};

/// Finds the nearest of many straight segments by a tree of boxes. Exact to rounding. Any thread, once it is made.
class SegmentTree {
public:
    explicit SegmentTree(std::vector<StraightSegment> segments);

    bool empty() const noexcept { return segments_.empty(); }
    /// Distance from a point to the nearest segment, mm. Not for an empty tree.
    /// @param near a segment that may be near, as the one of a neighbouring point is: the nearer, the faster; becomes
    /// the nearest one. 0 will do
    double distance(const glm::dvec3& point, std::uint32_t& near) const noexcept;

private:
    struct Node {
        Box box;
        std::uint32_t first = 0, count = 0; ///< segments of a leaf
        std::uint32_t second = 0;           ///< the other child; the first one follows its parent
    };
    void divide(std::uint32_t first, std::uint32_t end);

    std::vector<StraightSegment> segments_;
    std::vector<Node> nodes_;
};

} // namespace burin
