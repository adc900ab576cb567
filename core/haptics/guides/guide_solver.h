// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_shape.h"

#include <array>

namespace burin {

/// Combines the guides that hold: an orthonormal basis of the directions that they hold, from their planes in order
/// (Gram-Schmidt), so that each direction can fade individually, and so that at full weight the result is the nearest
/// point on all guides. Called in the haptic tick.
class GuideSolver {
public:
    static constexpr int capacity = 3; ///< there are no more than three directions

    /// Sine of the angle to the directions already held below which a plane adds no information, or contradicts them.
    static constexpr double smallestSine = 0.2;
    /// The same for a guide that is to be captured: a somewhat larger angle.
    static constexpr double capturingSine = 0.3;

    struct Direction {
        glm::dvec3 normal{0.0};
        double offset = 0.0;   ///< mm: dot(normal, point) on the guides
        std::size_t guide = 0; ///< the guide that it comes from
    };

    void clear() noexcept { size_ = 0; }
    /// Returns false if a plane can't be added; the planes before it stay.
    bool add(std::size_t guide, const GuideRows& rows) noexcept;
    /// Sine of the smallest angle between the planes' normals and the directions held.
    double independence(const GuideRows& rows) const noexcept;
    /// Whether directions of a guide contribute to what holds along the planes' normals.
    bool concerns(std::size_t guide, const GuideRows& rows) const noexcept;
    /// The nearest point to `hand` on all guides.
    glm::dvec3 nearest(const glm::dvec3& hand) const noexcept;

    int size() const noexcept { return size_; }
    const Direction* begin() const noexcept { return directions_.data(); }
    const Direction* end() const noexcept { return directions_.data() + size_; }

private:
    std::array<Direction, capacity> directions_{};
    int size_ = 0;
};

} // namespace burin
