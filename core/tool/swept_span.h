// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/revolved_piece.h"
#include "core/tool/span.h"
#include "core/tool/tilted_sweep.h"
#include "core/tool/upright_sweep.h"

#include <glm/glm.hpp>

#include <optional>
#include <variant>

namespace burin {

/// The solid swept by a piece of a tool on a straight move between two tips with a constant axis, intersected by lines
/// along Z of the frame in which tips and axis are given. Exact: the piece is convex, so the swept solid is the convex
/// hull of its two ends, and each line meets it in one span; closed forms where they exist, iterations to 1e-9 mm
/// elsewhere.
/// Equals the paper's interpolation of poses (eqs. 6–10) in the limit of infinitely many poses.
/// The span at either end of the move depends only on that end, to the last bit: two moves that meet in a tip position
/// agree on what the piece covers there, so a tool that rests after a move finds nothing left to remove.
class SweptPiece {
public:
    /// With the axis +Z.
    SweptPiece(const RevolvedPiece& piece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept
        : SweptPiece(piece, fromTip, toTip, {0.0, 0.0, 1.0}) {}
    /// @param axis unit length
    SweptPiece(const RevolvedPiece& piece, const glm::dvec3& fromTip, const glm::dvec3& toTip,
               const glm::dvec3& axis) noexcept;

    /// Returns the span of the line at (x, y), mm. Empty if the line misses the solid or touches it in one point,
    /// within rounding; a line in a side of the solid, within rounding, may count either way. Does not allocate.
    std::optional<Span> along(double x, double y) const noexcept {
        if (const UprightSweep* const upright = std::get_if<UprightSweep>(&sweep_)) return upright->along(x, y);
        return std::get_if<TiltedSweep>(&sweep_)->along(x, y);
    }
    /// Returns the lower end of `along`, mm; faster for an upright axis.
    std::optional<double> bottomAlong(double x, double y) const noexcept {
        if (const UprightSweep* const upright = std::get_if<UprightSweep>(&sweep_)) return upright->bottomAlong(x, y);
        const std::optional<Span> span = along(x, y);
        return span ? std::optional(span->low) : std::nullopt;
    }
    /// Returns the interval of x that the solid covers at this y, mm: its shadow along Z. Empty if there is none.
    std::optional<Span> shadow(double y) const noexcept;
    /// Returns the bounding box of the swept solid, mm.
    Box bounds() const noexcept;

private:
    std::variant<UprightSweep, TiltedSweep> sweep_;
};

} // namespace burin
