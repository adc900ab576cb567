// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"
#include "core/tool/span.h"

#include <glm/glm.hpp>

#include <optional>

namespace burin {

/// The intersection of lines along Z with a piece at rest whose axis has any direction. Closed forms for ball, cylinder
/// and cone; the torus of a bull nose or a barrel by Newton steps on its distance, which is convex along the line, so
/// that steps from outside never pass the surface; exact to 1e-9 mm except for rounding.
class PieceChord {
public:
    /// @param axis unit length
    PieceChord(const RevolvedPiece& piece, const glm::dvec3& axis) noexcept;

    /// @param x, y of the line, mm from the tip. @return mm from the tip; empty if the line misses the piece. A line
    /// that touches it in one point, within rounding, may return that point: low == high. Depends only on the
    /// arguments. Does not allocate.
    std::optional<Span> along(double x, double y) const noexcept;

private:
    /// A line in the frame of the plane spanned by axis and lines.
    struct Line {
        double aside = 0.0;  ///< mm, between the line and the axis
        double before = 0.0; ///< mm, along the horizontal direction of the axis
    };
    double heightAt(const Line& line, double z) const noexcept { return line.before * lean_ + z * rise_; }
    bool clipToFaces(const Line& line, Span& span) const noexcept;
    bool clipToCylinder(const Line& line, Span& span) const noexcept;
    bool clipToCone(const Line& line, Span& span) const noexcept;
    bool clipToBall(const Line& line, double radius, Span& span) const noexcept;
    bool clipToCorner(const Line& line, Span& span) const noexcept;
    bool clipToBulge(const Line& line, Span& span) const noexcept;
    /// A point on a line relative to the rounding's ring, mm.
    struct RingPlace {
        double across = 0.0, fromAxis = 0.0; ///< distance from the axis: in the plane of axis and lines, and in total
        double out = 0.0, over = 0.0;        ///< beyond the ring's radius and above its height, if the piece is round
        double fromRing = 0.0;
    };
    inline RingPlace ringPlaceAt(const Line& line, double z) const noexcept;
    bool advance(const Line& line, double direction, double& z) const noexcept;
    bool enterRounding(const Line& line, bool low, bool high, Span& span) const noexcept;

    RevolvedPiece piece_;
    glm::dvec2 direction_{1.0, 0.0};             ///< unit, horizontal direction of the axis
    double lean_ = 0.0;                          ///< sine of the angle between axis and lines
    double rise_ = 1.0;                          ///< its cosine
    double widening_ = 0.0;                      ///< mm/mm of a cone
    double tipRadius_ = 0.0;                     ///< mm, of that cone at the height of the tip
    double opening_ = 0.0;                       ///< of the cone's outline: not positive if it has none
    double openingRoot_ = 0.0;                   ///< its square root
    double outlineUnit_ = 0.0;                   ///< weight of a millimetre of distance from the cone's outline
    double roundRadius_ = 0.0;                   ///< mm, of corner or bulge
    double ringRadius_ = 0.0, ringHeight_ = 0.0; ///< mm, centre of that rounding
};

} // namespace burin
