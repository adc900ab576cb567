// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/four_floats.h"
#include "core/geometry/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {

/// Lower bounds, over the boxes and plates of four children at once, of the signed distance to any ball of a group:
/// equal balls whose centres lie in a box, and between two planes within a radius of its middle. Computed from the
/// tangent of the middle ball's distance at the middle of each box, as EntrySearch does for other pieces one by one.
class BallGroup {
public:
    struct Spread {
        glm::dvec3 half{0.0}, normal{0.0, 0.0, 1.0};
        double below = 0.0, above = 0.0, radius = 0.0;
    };
    /// @param middle  of the balls' centres  @param axis  of the tools; what lies above a centre does not concern its
    ///        ball
    /// @param lowest  mm, the lowest height of a centre relative to the middle, <= 0
    BallGroup(const TriangleTree& tree, const glm::dvec3& middle, double ball, const Spread& spread,
              const glm::dvec3& axis, double lowest) noexcept {
        const glm::dvec3 at = middle - tree.origin();
        for (int i = 0; i < 3; ++i) {
            const auto place = static_cast<std::size_t>(i);
            at_[place] = FourFloats{} + static_cast<float>(at[i]);
            axis_[place] = FourFloats{} + static_cast<float>(axis[i]);
            half_[place] = FourFloats{} + static_cast<float>(spread.half[i]);
            normal_[place] = FourFloats{} + static_cast<float>(spread.normal[i]);
        }
        ball_ = FourFloats{} + static_cast<float>(ball);
        below_ = FourFloats{} + static_cast<float>(spread.below);
        above_ = FourFloats{} + static_cast<float>(spread.above);
        radius_ = FourFloats{} + static_cast<float>(spread.radius);
        // Single precision represents coordinates to a few units of the seventh digit of the greatest of them.
        const glm::dvec3 far = glm::abs(at);
        slack_ = 1e-6F * static_cast<float>(std::max({far.x, far.y, far.z}) + ball + spread.radius);
        lowest_ = FourFloats{} + (static_cast<float>(lowest) - slack_);
    }

    /// mm; minus infinity for children that reach above the lowest centre.
    FourFloats of(const TreeNode& node) const noexcept {
        const FourFloats zero{}, one = zero + 1.0F;
        std::array<FourFloats, 3> way, half;
        FourFloats squared{}, highest{};
        for (std::size_t i = 0; i < 3; ++i) {
            const FourFloats low = fourAt(node.low[i].data()), high = fourAt(node.high[i].data());
            half[i] = 0.5F * (high - low);
            way[i] = 0.5F * (low + high) - at_[i];
            squared += way[i] * way[i];
            highest += way[i] * axis_[i] + absolute(axis_[i]) * half[i];
        }
        const FourFloats distance = rootsOf(squared);
        const FourFloats inverse = one / greater(distance, zero + 1e-6F);
        std::array<FourFloats, 3> normal;
        FourFloats overBox{}, alongPlate{}, riseInBox{}, alongSpread{};
        for (std::size_t i = 0; i < 3; ++i) {
            way[i] *= inverse; // the slope from here on
            normal[i] = fourAt(node.normal[i].data());
            overBox += absolute(way[i]) * half[i];
            riseInBox += absolute(way[i]) * half_[i];
            alongPlate += way[i] * normal[i];
            alongSpread += way[i] * normal_[i];
        }
        const FourFloats radius = fourAt(node.radius.data());
        const FourFloats thickness = alongPlate > 0.0F ? fourAt(node.below.data()) : fourAt(node.above.data());
        const FourFloats overPlate = partAcross(way, normal, alongPlate) * radius - alongPlate * thickness;
        const FourFloats riseInPlate =
            partAcross(way, normal_, alongSpread) * radius_ + alongSpread * (alongSpread > 0.0F ? above_ : below_);
        const FourFloats fall = overBox < overPlate ? overBox : overPlate;
        const FourFloats rise = riseInBox < riseInPlate ? riseInBox : riseInPlate;
        // The slope is accurate to slack / distance.
        const FourFloats bound = distance - ball_ - fall - rise - slack_ * (one + (radius + radius_) * inverse) -
                                 1e-6F * (radius + distance);
        return highest < lowest_ ? bound : zero - std::numeric_limits<float>::infinity();
    }

private:
    std::array<FourFloats, 3> at_, axis_, half_, normal_;
    FourFloats ball_, below_, above_, radius_, lowest_;
    float slack_;
};

} // namespace burin
