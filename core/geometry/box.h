// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace burin {

/// Axis-aligned box, mm, in whatever frame its points are in. Starts empty (low > high); `include` grows it.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    bool empty() const noexcept { return low.x > high.x || low.y > high.y || low.z > high.z; }
    /// mm; meaningless for an empty box, like its centre.
    glm::dvec3 size() const noexcept { return high - low; }
    glm::dvec3 centre() const noexcept { return 0.5 * (low + high); }
    void include(const glm::dvec3& point) noexcept {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void include(const Box& other) noexcept {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    /// Corner 0 … 7: the high x where bit 0 is set, the high y with bit 1, the high z with bit 2.
    glm::dvec3 corner(unsigned i) const noexcept {
        return {(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z};
    }
    /// @param margin  mm to each side; a negative one shrinks the box, which may become empty
    Box grown(double margin) const noexcept { return {low - glm::dvec3(margin), high + glm::dvec3(margin)}; }
    /// Whether the point is in the box, faces included.
    bool contains(const glm::dvec3& p) const noexcept {
        return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y && p.z <= high.z;
    }
};

} // namespace burin
