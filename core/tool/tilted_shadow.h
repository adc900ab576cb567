// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"

#include <glm/glm.hpp>

#include <array>

namespace burin {

/// The shadow of a leaning piece along the runs, with a margin about it: the convex hull of the shadows of its two
/// ends, of which a ball's is a circle and a disc's an ellipse. Lengths: voxels across the runs.
class TiltedShadow {
public:
    /// Stretch of x; none where low > high.
    struct Stretch {
        double low = 0.0, high = -1.0;
    };

    TiltedShadow() noexcept = default;
    /// @param piece in voxels @param axis unit length @param tip across the runs
    TiltedShadow(const RevolvedPiece& piece, const glm::dvec3& axis, const glm::dvec2& tip, double margin) noexcept;

    const glm::dvec2& low() const noexcept { return low_; }
    const glm::dvec2& high() const noexcept { return high_; }
    /// What lies in the shadow of the line at this y, or a little more of it.
    Stretch row(double y) const noexcept;

private:
    /// x runs from middle + slope · dy - half · root to … + …, root = sqrt(1 - dy² · perSquare).
    struct Ellipse {
        glm::dvec2 middle{0.0};
        double slope = 0.0, half = 0.0, perSquare = 1.0;
        glm::dvec2 reach{0.0};
        double outmost = 0.0; ///< dy of its outmost place towards +x
    };
    Ellipse ellipse(const glm::dvec2& middle, const glm::dvec2& heading, double radius, double flatness) const noexcept;
    double edge(double y, double side) const noexcept;

    double margin_ = 0.0;
    std::array<Ellipse, 2> ends_;
    glm::dvec2 contact_{0.0}; ///< from an end's middle, where a straight side begins
    glm::dvec2 low_{0.0}, high_{-1.0};
    std::array<double, 2> outmost_{}; ///< rows of the hull's outmost places, towards -x and +x
};

} // namespace burin
