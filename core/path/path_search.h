// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/path/path.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// A position on a path: on the move from point `piece` to the next.
struct PlaceOnPath {
    std::size_t piece = 0;
    double share = 0.0;    ///< of the move, for an arc of its sweep: 0 at its start, 1 at its end
    glm::dvec3 place{0.0}; ///< mm, setup frame
    double distance = 0.0; ///< mm, from the point that it was searched for
};

/// The position on the move between two points that is nearest to a third one. `piece` is 0. Arcs count as chords with
/// a deviation of 0.02 mm.
PlaceOnPath nearestOnMove(const PathPoint& from, const PathPoint& to, const glm::dvec3& place);

/// Whether a point can be taken by the hand: it has a moment of a source, and no rapid move leads to it.
bool canBeTaken(const PathPoint& point) noexcept;

/// Finds the position of a path that is nearest to a point of space, among the moves between points that can be taken
/// and these points themselves. Many searches of one path: a search looks at some hundred points only.
class PathSearch {
public:
    /// Cost: linear. @param points outlive the search
    explicit PathSearch(const std::vector<PathPoint>& points);

    /// Empty if nothing is within reach. @param place mm, setup frame @param reach mm, > 0
    std::optional<PlaceOnPath> nearest(const glm::dvec3& place, double reach) const;

private:
    static constexpr std::size_t blockSize = 128; ///< moves

    std::optional<PlaceOnPath> onPiece(std::size_t piece, const glm::dvec3& place) const;

    const std::vector<PathPoint>& points_;
    std::vector<Box> blocks_; ///< of each `blockSize` moves, mm; empty if none of them can be taken
};

} // namespace burin
