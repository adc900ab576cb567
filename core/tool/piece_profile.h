// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"

#include <array>
#include <cstddef>
#include <span>

namespace burin {

/// A circle about the tool axis.
struct ProfileDisc {
    double radius = 0.0; ///< mm, >= 0
    double height = 0.0; ///< mm above the tip
};

/// The convex profile of a piece of a tool for geometry based on directions: the edges of its discs, the rounded part
/// and the straight side, each with the directions of its outward normals. Directions are given by the sine of their
/// angle above the plane perpendicular to the axis.
class PieceProfile {
public:
    /// An arc with outward normals lowSine … highSine. A vertex has none.
    struct Arc {
        double centreRadius = 0.0; ///< mm, from the axis; negative beyond it
        double centreHeight = 0.0; ///< mm above the tip
        double radius = 0.0;       ///< mm; 0: the profile has no rounded part
        double lowSine = 0.0, highSine = 0.0;
    };
    /// Straight side between two discs.
    struct Side {
        bool present = false;
        ProfileDisc lower, upper;
        double sine = 0.0, cosine = 1.0; ///< of its outward normal
    };

    explicit PieceProfile(const RevolvedPiece& piece) noexcept;

    /// Returns the edges of all faces, from below.
    std::span<const ProfileDisc> discs() const noexcept { return {discs_.data(), count_}; }
    const Arc& arc() const noexcept { return arc_; }
    const Side& side() const noexcept { return side_; }
    /// Returns the point of the profile that lies farthest in a direction. @param cosine >= 0
    ProfileDisc farthest(double sine, double cosine) const noexcept;

private:
    std::array<ProfileDisc, 3> discs_{};
    std::size_t count_ = 0;
    Arc arc_;
    Side side_;
};

} // namespace burin
