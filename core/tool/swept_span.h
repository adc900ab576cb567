// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/revolved_piece.h"

#include <glm/glm.hpp>

#include <optional>

namespace burin {

/// Stretch of a line parallel to the tool axis, mm along +Z; low < high.
struct Span {
    double low = 0.0, high = 0.0;
};

/// What a piece of a tool with axis +Z sweeps on its straight way between two tips, met by lines along Z. Exact: the
/// piece is convex, so the swept solid is the convex hull of its two ends, and each line meets it in one span.
/// Equals the paper's interpolation of poses (eqs. 6–10) in the limit of infinitely many.
class SweptPiece {
public:
    SweptPiece(const RevolvedPiece& piece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept;

    /// Nothing where the line at (x, y), mm, misses the solid or only touches it. No allocation.
    std::optional<Span> along(double x, double y) const noexcept;
    /// Box of the swept solid, mm.
    Box bounds() const noexcept;

private:
    RevolvedPiece piece_;
    glm::dvec3 from_{0.0}, to_{0.0};
    glm::dvec2 direction_{1.0, 0.0}; ///< unit, of the way in the plane
    double reach_ = 0.0;             ///< mm, length of the way in the plane
};

} // namespace burin
