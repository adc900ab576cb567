// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// A loop on one level.
struct LevelLoop {
    PlanRing ring; ///< mm, the room for the tool to its left
    int step = 0;  ///< how many step-overs it is from the part
};

/// A stretch of a loop that takes something away.
struct LevelRun {
    std::vector<glm::dvec2> places; ///< mm, in the direction of the loop; a closed one ends where it begins
    bool closed = false;
    int step = 0;
};

/// A ring with its corners, and places between them at most `spacing` > 0 apart.
std::vector<glm::dvec2> spaced(const PlanRing& ring, double spacing);

/// The run, begun at one of its places where it is closed.
LevelRun begunAt(LevelRun run, std::size_t start);

/// What a loop has to do at a place.
enum class LevelPlace : std::uint8_t {
    idle,     ///< nothing is to be taken away
    cuts,     ///< something is
    forbidden ///< the tool must not be there
};
/// Stretches of a closed line of places on which something is taken away, with a place more at either end where that is
/// allowed; idle gaps of up to `gap` places are gone as well. @param work by place
std::vector<LevelRun> runsAlong(const std::vector<glm::dvec2>& places, std::vector<LevelPlace> work, std::size_t gap);

/// Puts runs of a level in order: each comes behind those that are beside it and one step farther from the part, and of
/// those that may come the nearest comes. Closed ones begin where the tool is near, a little ahead of it, so that it
/// goes into them askew.
class LevelOrder {
public:
    /// @param stepOver mm, between loops
    LevelOrder(std::vector<LevelRun> runs, double stepOver);

    /// The next one, nothing when all have been. @param tip where the tool is; nothing: it may begin anywhere
    std::optional<LevelRun> next(std::optional<glm::dvec2> tip);

private:
    void findWhatComesFirst();

    std::vector<LevelRun> runs_;
    double stepOver_;
    std::vector<std::vector<std::size_t>> behind_; ///< by run: those that wait for it
    std::vector<int> waitsFor_;                    ///< by run: how many have to come before it
    std::vector<bool> done_;
};

} // namespace burin
