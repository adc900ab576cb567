// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "tests/oracles/tilted_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace burin::oracles {

/// The true motion of a rotating tool (paper, eqs. 6, 7): the tip moves straight at constant speed, the axis rotates at
/// constant speed. @param part 0 … 1
inline ToolPose motionAt(const ToolPose& from, const ToolPose& to, double part) {
    const double angle = std::acos(std::clamp(glm::dot(from.axis, to.axis), -1.0, 1.0));
    const glm::dvec3 axis =
        angle < 1e-9
            ? to.axis
            : (from.axis * std::sin((1.0 - part) * angle) + to.axis * std::sin(part * angle)) / std::sin(angle);
    return {glm::mix(from.tip, to.tip, part), glm::normalize(axis)};
}

/// Flutes on their motion between two poses, by samples of the true motion, directly from the definition of their
/// pieces: no formulas for sections or sweeps are used.
class SweptCutter {
public:
    enum class Verdict { inside, near, outside };

    /// @param pieces of the flutes, from the tip up, each on top of the previous one
    /// @param margin mm, distance by which a point must lie inside or outside the flutes to count as such
    /// @param spacing mm, largest movement of any point of the flutes between two samples
    SweptCutter(const std::vector<RevolvedPiece>& pieces, const ToolPose& from, const ToolPose& to, double margin,
                double spacing)
        : margin_(margin), spacing_(spacing) {
        double reach = 0.0;
        for (const RevolvedPiece& piece : pieces) {
            reach = std::max(reach, std::hypot(piece.top, piece.widestRadius()));
            const double rise = piece.top - piece.bottom, widens = piece.topRadius - piece.bottomRadius;
            pieces_.push_back({piece, piece.bulges() ? 1.0 : std::hypot(1.0, widens / rise)});
        }
        const double turn = std::acos(std::clamp(glm::dot(from.axis, to.axis), -1.0, 1.0));
        const double way = glm::length(to.tip - from.tip) + turn * reach;
        const int samples = 1 + static_cast<int>(std::ceil(way / spacing));
        for (int i = 0; i <= samples; ++i) poses_.push_back(motionAt(from, to, static_cast<double>(i) / samples));
    }

    /// Inside: at some moment deeper in the flutes than the margin. Outside: never within the margin.
    Verdict at(const glm::dvec3& place) const {
        const double undecided = margin_ + 0.5 * spacing_; // error from the motion between two samples
        bool comesNear = false;
        for (std::size_t i = 0;;) {
            const ToolPose& pose = poses_[i];
            const glm::dvec3 q = place - pose.tip;
            const double height = glm::dot(q, pose.axis), radius = glm::length(q - height * pose.axis);
            const double beyond = beyondPieces(radius, height);
            if (beyond < 0.0 && isDeep(radius, height)) return Verdict::inside;
            comesNear = comesNear || beyond < undecided;
            if (i + 1 == poses_.size()) return comesNear ? Verdict::near : Verdict::outside;
            // The flutes cannot come near the point within this many samples.
            const auto skipped = static_cast<std::size_t>(std::max(1.0, (beyond - undecided) / spacing_));
            i = std::min(i + skipped, poses_.size() - 1);
        }
    }

private:
    struct Part {
        RevolvedPiece piece;
        double steepness = 1.0; ///< slope of `beyondSide` with respect to the distance from a cone's side
    };

    /// A lower bound of the distance from the flutes, mm; negative inside.
    double beyondPieces(double radius, double height) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Part& part : pieces_) {
            const double beyondFaces = std::max(part.piece.bottom - height, height - part.piece.top);
            if (beyondFaces >= least) continue;
            least = std::min(least, std::max(beyondFaces, beyondSide(part.piece, radius, height) / part.steepness));
        }
        return least;
    }
    /// Whether everything within the margin lies in the flutes: the plane where two pieces meet is no surface.
    bool isDeep(double radius, double height) const {
        if (height - margin_ < pieces_.front().piece.bottom || height + margin_ > pieces_.back().piece.top)
            return false;
        return std::ranges::all_of(pieces_, [&](const Part& part) {
            return height + margin_ < part.piece.bottom || height - margin_ > part.piece.top ||
                   beyondSide(part.piece, radius, height) / part.steepness < -margin_;
        });
    }

    std::vector<Part> pieces_;
    std::vector<ToolPose> poses_;
    double margin_, spacing_;
};

} // namespace burin::oracles
