// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/tool/piece_chord.h"
#include "core/tool/shadow_edge.h"
#include "core/tool/span.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace burin {

/// The solid swept by a piece with a fixed axis of any direction on a straight move between two tips, intersected by
/// lines along Z. The swept solid is convex: a line's lower end lies on the piece at the first tip, on the piece at the
/// last one, or on the wall swept by its outline (seen along the move) in between, and is the lowest of these.
class TiltedSweep {
public:
    TiltedSweep(const RevolvedPiece& piece, const glm::dvec3& fromTip, const glm::dvec3& toTip,
                const glm::dvec3& axis) noexcept;

    std::optional<Span> along(double x, double y) const noexcept;
    std::optional<Span> shadow(double y) const noexcept;
    const Box& bounds() const noexcept { return bounds_; }

private:
    /// Right-handed view along the move.
    struct View {
        glm::dvec3 across{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, depth{0.0, 0.0, 1.0};
    };
    static View viewAlong(const glm::dvec3& way) noexcept;
    bool isBetweenSides(double x, double y) const noexcept;
    double wallAt(const ShadowEdge& edge, double side, double x, double y) const noexcept;

    glm::dvec3 from_{0.0}, to_{0.0};
    PieceChord chord_;
    View view_;
    double length_ = 0.0;                  ///< mm, of the move
    double sine_ = 0.0;                    ///< of the angle between move and lines
    bool leavesWall_ = false;              ///< the move is not parallel to the lines
    Span sides_;                           ///< mm across the move from the first tip; lines on or beyond them miss
    ShadowEdge lower_, upper_;             ///< outline along the move; the upper one is stored upside down
    ShadowEdge left_, right_;              ///< outline along the lines, lowest towards -x and +x
    std::array<glm::dvec2, 2> tangents_{}; ///< mm from the tip, where the move is tangent to that outline
    Box bounds_;
};

} // namespace burin
