// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"

#include <QPointF>

#include <cstddef>
#include <functional>
#include <optional>

namespace burin {

/// Distance within which the pointer picks something, device-independent pixels.
inline constexpr double pointerReach = 8.0;

/// The position of a point of the setup frame in the picture, device-independent pixels.
using Appearance = std::function<QPointF(const glm::dvec3&)>;

/// A piece of a path: a straight line from `from` to `to`, mm, setup frame, or an arc between them.
struct PathPiece {
    glm::dvec3 from{0.0}, to{0.0};
    std::optional<Arc> arc{};

    /// mm; @param share of the piece, for an arc of its sweep: 0 at its start, 1 at its end
    glm::dvec3 at(double share) const;
};

/// A point on one of several pieces.
struct NearestPlace {
    std::size_t piece = 0;
    double share = 0.0; ///< as in PathPiece::at
};

/// The point on the pieces that appears nearest to the pointer, within its reach. Empty if there is none.
/// @param pieceAt returns the piece of a number below `count`; empty: the piece is skipped
std::optional<NearestPlace> nearestPlace(const QPointF& pointer, std::size_t count,
                                         const std::function<std::optional<PathPiece>(std::size_t)>& pieceAt,
                                         const Appearance& appearance);

} // namespace burin
