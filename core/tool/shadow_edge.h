// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/piece_profile.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace burin {

/// The lower edge of the shadow (projection) of a piece along the depth of a view. The view's frame is right-handed: x
/// across, y up, z depth. The shadow is the convex hull of the discs' ellipses, of the straight side's two outermost
/// lines and of the rounding's outline; each of these that reaches a position gives a candidate that lies in the
/// shadow, and the lowest of them is the edge. Closed forms, except for a torus: Newton steps in a bracket, then along
/// the tangent, so that the result is never above the edge's tangent and within 1e-10 mm of the edge.
class ShadowEdge {
public:
    struct Point {
        double up = 0.0;    ///< mm, infinite if there is no shadow
        double depth = 0.0; ///< mm, of a point of the piece that is projected there
    };
    /// @param axis of the piece in the view's frame, unit length; the tip is projected onto the origin.
    ShadowEdge(const PieceProfile& profile, const glm::dvec3& axis) noexcept;

    /// Returns the lowest point of the shadow at a position across. Does not allocate.
    Point lowest(double across) const noexcept;

private:
    struct Side {
        glm::dvec3 from{0.0}, to{0.0}; ///< view's frame, from.x < to.x
    };
    /// Part of a torus' outline, parametrised by the angle of its outward normal (sin angle across, -cos angle up).
    struct Arc {
        double low = 0.0, high = 0.0; ///< rad, within ±pi/2
        double sign = 1.0;            ///< side of the axis that it lies on
        double acrossLow = 0.0, acrossHigh = 0.0;
    };
    struct ArcPoint {
        glm::dvec3 place{0.0};
        double curvatureRadius = 0.0;
    };
    void addSides() noexcept;
    void addArcs() noexcept;
    ArcPoint onArc(double sine, double cosine, double sign) const noexcept;
    Point lowestOnArc(const Arc& arc, double across) const noexcept;
    void lowestOnDisc(const ProfileDisc& disc, double across, Point& best) const noexcept;
    void lowestOnBall(double across, Point& best) const noexcept;

    PieceProfile profile_;
    glm::dvec3 axis_{0.0};
    glm::dvec2 along_{1.0, 0.0}; ///< unit, direction of the projected axis
    double tilt_ = 0.0;          ///< length of the projected axis: sine of its angle with the depth
    double width_ = 0.0;         ///< ratio of the width of a disc's shadow to its own
    glm::dvec2 slope_{0.0};      ///< change of up and depth per disc radius, going across
    glm::dvec2 sink_{0.0};       ///< change of up and depth per disc radius, from the middle to the lower half
    std::array<Side, 2> sides_{};
    std::size_t sideCount_ = 0;
    std::array<Arc, 4> arcs_{};
    std::size_t arcCount_ = 0;
};

} // namespace burin
