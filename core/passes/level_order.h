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
    PlanRing ring; ///< mm, with the free side to its left
    int step = 0;  ///< number of step-overs between it and the part
};

/// A part of a loop that removes stock.
struct LevelRun {
    std::vector<glm::dvec2> places; ///< mm, in the direction of the loop; a closed run ends at its first point
    bool closed = false;
    int step = 0;
};

/// The corners of a ring, with points between them at most `spacing` (> 0) apart.
std::vector<glm::dvec2> spaced(const PlanRing& ring, double spacing);

/// The run; a closed one is rotated so that it begins at point `start`.
LevelRun begunAt(LevelRun run, std::size_t start);

/// What happens at a point of a loop.
enum class LevelPlace : std::uint8_t {
    idle,     ///< no stock to remove
    cuts,     ///< stock is removed
    forbidden ///< the tool must not be there
};
/// The parts of a closed polyline on which stock is removed, each extended by one point at either end where that is
/// allowed. Idle gaps of up to `gap` points are traversed too. @param work the state of each point
std::vector<LevelRun> runsAlong(const std::vector<glm::dvec2>& places, std::vector<LevelPlace> work, std::size_t gap);

/// Orders the runs of a level. A run comes after its neighbours that are one step-over farther from the part; of the
/// runs that are possible next, the nearest is taken. Closed runs begin near the tool, a little ahead of it, so that it
/// enters them at an angle.
class LevelOrder {
public:
    /// @param stepOver distance between loops, mm
    LevelOrder(std::vector<LevelRun> runs, double stepOver);

    /// Returns the next run, or nothing when none is left. @param tip position of the tool; if empty, the run may begin
    /// anywhere
    std::optional<LevelRun> next(std::optional<glm::dvec2> tip);

private:
    void findWhatComesFirst();

    std::vector<LevelRun> runs_;
    double stepOver_;
    std::vector<std::vector<std::size_t>> behind_; ///< by run: the runs that wait for it
    std::vector<int> waitsFor_;                    ///< by run: the number of runs that must come before it
    std::vector<bool> done_;
};

} // namespace burin
