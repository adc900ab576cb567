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

/// What a piece of a tool sweeps on its straight way between two tips, its axis standing, met by lines along Z of the
/// frame that tips and axis are given in. Exact: the piece is convex, so the swept solid is the convex hull of its two
/// ends, and each line meets it in one span; closed forms where there are, iterations to 1e-9 mm elsewhere.
/// Equals the paper's interpolation of poses (eqs. 6–10) in the limit of infinitely many.
/// The span at either end of the way depends on that end alone, to the last bit: two ways that meet in a tip agree on
/// what the piece covers there, so a tool that stands still after a move finds nothing left to take.
class SweptPiece {
public:
    /// Axis +Z.
    SweptPiece(const RevolvedPiece& piece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept
        : SweptPiece(piece, fromTip, toTip, {0.0, 0.0, 1.0}) {}
    /// @param axis unit length
    SweptPiece(const RevolvedPiece& piece, const glm::dvec3& fromTip, const glm::dvec3& toTip,
               const glm::dvec3& axis) noexcept;

    /// Nothing where the line at (x, y), mm, misses the solid or touches it in a point, to rounding; a line that lies
    /// in a side of the solid, to rounding, may count either way. No allocation.
    std::optional<Span> along(double x, double y) const noexcept {
        if (const UprightSweep* const upright = std::get_if<UprightSweep>(&sweep_)) return upright->along(x, y);
        return std::get_if<TiltedSweep>(&sweep_)->along(x, y);
    }
    /// Where `along` begins, mm, for whom its end is no matter: quicker upright.
    std::optional<double> bottomAlong(double x, double y) const noexcept {
        if (const UprightSweep* const upright = std::get_if<UprightSweep>(&sweep_)) return upright->bottomAlong(x, y);
        const std::optional<Span> span = along(x, y);
        return span ? std::optional(span->low) : std::nullopt;
    }
    /// Stretch of x that the solid covers at this y, mm: its shadow along Z. Nothing where it has none.
    std::optional<Span> shadow(double y) const noexcept;
    /// Box of the swept solid, mm.
    Box bounds() const noexcept;

private:
    std::variant<UprightSweep, TiltedSweep> sweep_;
};

} // namespace burin
