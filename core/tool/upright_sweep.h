// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/revolved_piece.h"
#include "core/tool/span.h"

#include <glm/glm.hpp>

#include <optional>

namespace burin {

/// The solid swept by a piece with a straight side and axis +Z on a straight move between two tips, intersected by
/// lines along Z: the common case, in closed form except for the corner of a bull nose.
class UprightSweep {
public:
    UprightSweep(const RevolvedPiece& piece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept;

    std::optional<Span> along(double x, double y) const noexcept;
    /// Returns where the line enters the solid, mm, for a solid that does not end below the requested part of the line;
    /// half the cost.
    std::optional<double> bottomAlong(double x, double y) const noexcept;
    std::optional<Span> shadow(double y) const noexcept;
    Box bounds() const noexcept;

private:
    /// One end face of the piece as height over the distance from the axis; the upper one is stored upside down, so
    /// that both are convex and their smallest value is needed.
    struct Face {
        double height = 0.0;         ///< mm, of its flat middle
        double flatRadius = 0.0;     ///< mm, of its flat middle
        double cornerRadius = 0.0;   ///< mm, of the rounding outside of it, 0 for none
        double slope = 0.0;          ///< mm/mm, of the cone outside of it, 0 for none
        double rise = 0.0;           ///< mm over the move, in this face's orientation
        double from = 0.0, to = 0.0; ///< mm, height of the tip at the ends, in this face's orientation
    };
    /// A line relative to the piece.
    struct Line {
        double squareAtFrom = 0.0, squareAtTo = 0.0;   ///< mm², of its distance from the axis at both ends
        bool insideAtFrom = false, insideAtTo = false; ///< the outline, at both ends
        bool passes = false;                           ///< the axis comes closest between the ends, line inside
        double ahead = 0.0;                            ///< mm, along the move in the plane, from the first axis
        double aside = 0.0;                            ///< mm, across it, >= 0
    };
    std::optional<Line> lineAt(double x, double y) const noexcept;
    double heightAt(const Face& face, double square) const noexcept;
    double least(const Face& face, const Line& line) const noexcept;
    double leastBetween(const Face& face, const Line& line) const noexcept;
    double chordOf(const Line& line) const noexcept;
    double bestOffset(const Face& face, const Line& line, double low, double high) const noexcept;
    double bestOffsetOnCorner(const Face& face, const Line& line, double low, double high) const noexcept;

    RevolvedPiece piece_;
    glm::dvec3 from_{0.0}, to_{0.0};
    glm::dvec2 direction_{1.0, 0.0}; ///< unit, of the move in the plane
    double reach_ = 0.0;             ///< mm, length of the move in the plane
    double outline_ = 0.0;           ///< mm, largest radius
    double outlineSquare_ = 0.0;     ///< mm²
    double sineSquare_ = 0.0;        ///< of the move's slope
    Face lower_, upper_;
};

} // namespace burin
