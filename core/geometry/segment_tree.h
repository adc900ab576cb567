// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <cstdint>
#include <vector>

namespace burin {

/// A straight line segment, mm.
struct StraightSegment {
    glm::dvec3 from{0.0}, to{0.0};
};

/// Finds the nearest of many straight segments by a tree of boxes. Exact to rounding. Thread-safe once constructed.
class SegmentTree {
public:
    explicit SegmentTree(std::vector<StraightSegment> segments);

    bool empty() const noexcept { return segments_.empty(); }
    /// Returns the distance from a point to the nearest segment, mm. The tree must not be empty.
    /// @param near initial guess, such as the nearest segment of a neighbouring point, or 0: the nearer it is, the
    /// faster the search; set to the nearest segment
    double distance(const glm::dvec3& point, std::uint32_t& near) const noexcept;

private:
    struct Node {
        Box box;
        std::uint32_t first = 0, count = 0; ///< segments of a leaf
        std::uint32_t second = 0;           ///< index of the second child; the first one follows its parent
    };
    void divide(std::uint32_t first, std::uint32_t end);

    std::vector<StraightSegment> segments_;
    std::vector<Node> nodes_;
};

} // namespace burin
