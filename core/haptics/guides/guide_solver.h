// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_shape.h"

#include <array>

namespace burin {

/// Guides held together: an orthonormal basis of what they hold, from their rows in order (Gram-Schmidt), so that each
/// direction can fade on its own, and so that in full force the nearest point on all of them comes out. Tick code.
class GuideSolver {
public:
    static constexpr int capacity = 3; ///< more directions there are not

    /// sin of the angle to what is held already, below which a row says nothing new, or contradicts.
    static constexpr double smallestSine = 0.2;
    /// The same for a guide that is to be captured: a little farther off.
    static constexpr double capturingSine = 0.3;

    struct Direction {
        glm::dvec3 normal{0.0};
        double offset = 0.0;   ///< mm: dot(normal, point) on the guides
        std::size_t guide = 0; ///< whose row it is
    };

    void clear() noexcept { size_ = 0; }
    /// False: a row does not do; those before it stay.
    bool add(std::size_t guide, const GuideRows& rows) noexcept;
    /// sin of the smallest angle between the rows and what is held.
    double independence(const GuideRows& rows) const noexcept;
    /// Whether a guide's directions take part in what the rows hold.
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
