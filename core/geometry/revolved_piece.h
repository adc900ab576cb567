// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// A convex solid of revolution about the tool axis: a frustum whose bottom edge may be rounded. A tool is a stack of
/// them (flutes, shank, holder), so that geometry below needs to know nothing of tools.
/// Ball end: bottomRadius = topRadius = cornerRadius. Flat end: cornerRadius = 0. Bull nose: between.
struct RevolvedPiece {
    double bottom = 0.0;       ///< mm above the tip along the axis
    double top = 0.0;          ///< mm above the tip, > bottom, >= bottom + cornerRadius
    double bottomRadius = 0.0; ///< mm, before rounding
    double topRadius = 0.0;    ///< mm
    double cornerRadius = 0.0; ///< mm, 0 … bottomRadius; only where bottomRadius == topRadius
};

/// Signed distance with its slopes along the two cylinder coordinates: unit length together, except on the piece's
/// inner ridges, where they are those of one of the faces that meet there (a subgradient).
struct PieceDistance {
    double distance = 0.0; ///< mm, negative inside
    double alongRadius = 0.0;
    double alongHeight = 0.0;
};

/// Signed distance, mm, from a point to the piece, negative inside; the point in cylinder coordinates of the tool
/// frame: `radius` >= 0 from the axis, `height` above the tip. Exact outside and inside; convex; 1-Lipschitz.
double signedDistance(const RevolvedPiece& piece, double radius, double height) noexcept;

/// The same with its slopes.
PieceDistance signedDistanceAndSlope(const RevolvedPiece& piece, double radius, double height) noexcept;

} // namespace burin
