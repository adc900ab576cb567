// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"

#include <glm/glm.hpp>

#include <array>

namespace burin {

/// The shadow of a tilted piece along the runs: the convex hull of the shadows of its two ends; that of a ball is a
/// circle, that of a disc an ellipse. Lengths: voxels across the runs, from the tip.
struct TiltedShadow {
    /// x ranges from middle + slope · dy - half · root to middle + slope · dy + half · root, root = sqrt(1 - dy² ·
    /// perSquare).
    struct Ellipse {
        glm::vec2 middle{0.0F};
        float slope = 0.0F, half = 0.0F, perSquare = 1.0F;
    };
    std::array<Ellipse, 2> ends;
    glm::vec2 contact{0.0F};         ///< start of a straight side, from an end's middle; the other side is opposite
    glm::dvec2 low{0.0}, high{-1.0}; ///< its extent
    std::array<float, 2> outmost{};  ///< rows of its outermost points, towards -x and +x
};

/// @param piece in voxels @param axis unit length
TiltedShadow shadowOf(const RevolvedPiece& piece, const glm::dvec3& axis) noexcept;

} // namespace burin
