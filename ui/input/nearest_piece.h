// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"

#include <QPointF>

#include <cstddef>
#include <functional>
#include <optional>

namespace burin {

/// How near the pointer has to be to something that it means, device-independent pixels.
inline constexpr double pointerReach = 8.0;

/// Where a place in the setup frame appears, device-independent pixels.
using Appearance = std::function<QPointF(const glm::dvec3&)>;

/// A piece of a path: a straight line from `from` to `to`, mm, setup frame, or an arc between them.
struct PathPiece {
    glm::dvec3 from{0.0}, to{0.0};
    std::optional<Arc> arc{};

    /// mm; @param share of the piece, of an arc's sweep: 0 at its beginning, 1 at its end
    glm::dvec3 at(double share) const;
};

/// A place on one of several pieces.
struct NearestPlace {
    std::size_t piece = 0;
    double share = 0.0; ///< as PathPiece::at has it
};

/// The place that appears nearest to the pointer, within its reach, on the pieces themselves. Nothing: none is.
/// @param pieceAt of a number below `count`; nothing: it is not asked for
std::optional<NearestPlace> nearestPlace(const QPointF& pointer, std::size_t count,
                                         const std::function<std::optional<PathPiece>(std::size_t)>& pieceAt,
                                         const Appearance& appearance);

} // namespace burin
