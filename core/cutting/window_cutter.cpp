// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/window_cutter.h"

#include "core/cutting/pose_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

static_assert(SpanRows::unitsAVoxel == unitsPerVoxel);

/// The largest cost of a tick, in groups of eight lines. The longest resulting time, that of a ball of R 200 at first
/// contact, was 0.31 to 0.57 ms (cut.first_contact.r200): the next tick is due after 1 ms.
constexpr double tickBudget = 40000.0;
constexpr double leastBudget = 15000.0; // for the work that was put off, which must be finished eventually, whatever
                                        // else a tick has to do
constexpr double costOfReading = 5.0;   // of a line of the volume, in groups
constexpr double costOfBrick = 12.0;    // of a brick that was not in the cache
constexpr double costOfWriting = 100.0; // of a brick of the volume

RevolvedPiece inVoxels(const RevolvedPiece& piece, double edge) noexcept {
    RevolvedPiece scaled;
    scaled.bottom = piece.bottom / edge;
    scaled.top = piece.top / edge;
    scaled.bottomRadius = piece.bottomRadius / edge;
    scaled.topRadius = piece.topRadius / edge;
    scaled.cornerRadius = piece.cornerRadius / edge;
    return scaled;
}

/// Returns the number of lines from its middle that a piece covers: upright, or leaning at any angle, up to an
/// affordable limit.
double windowReach(const SpanRows& spans, double radius) noexcept {
    constexpr double affordable = 250.0;
    const double upright = radius + 0.5 * spans.longestWay({0.0, 0.0, 1.0}) + 1.0;
    return std::max(upright, std::min(0.5 * (spans.reach() + radius) + upright - radius, affordable));
}

} // namespace

WindowCutter::WindowCutter(const RevolvedPiece& piece, const Grid& grid)
    : grid_(grid)
    , radius_(piece.bottomRadius / grid.edge())
    , spans_(inVoxels(piece, grid.edge()), static_cast<std::int32_t>(grid.lineEnd()))
    , window_(grid, windowReach(spans_, radius_))
    , brickSpans_(static_cast<std::size_t>(grid.lineCountU()) / 8 + 2) {}

LinePose WindowCutter::inLines(const ToolPose& pose) const noexcept {
    const int u = grid_.axisOfU(), v = grid_.axisOfV(), along = grid_.axisOfRuns();
    const glm::dvec3 place = (pose.tip - grid_.low()) / grid_.edge();
    return {{place[u] - 0.5, place[v] - 0.5, place[along]}, {pose.axis[u], pose.axis[v], pose.axis[along]}};
}

LineInterval WindowCutter::rowsOf(const LineInterval& rows) const noexcept {
    return {std::max(rows.first, 0), std::min(rows.last, grid_.lineCountV() - 1)};
}

LineInterval WindowCutter::groupsOf(const LineInterval& lines) const noexcept {
    const std::int32_t first = std::max(lines.first, 0), last = std::min(lines.last, grid_.lineCountU() - 1);
    return last < first ? LineInterval{} : LineInterval{first >> 3, last >> 3};
}

/// Returns false if the leaning piece is larger than the cache, which must then be moved along row by row.
bool WindowCutter::fits(const LineInterval& rows, const LineInterval& groups) const noexcept {
    return (rows.last >> 3) - (rows.first >> 3) < window_.side() && groups.last - groups.first < window_.side();
}

/// Takes some rows of one brick for the current move. @return their cost, in groups
double WindowCutter::takeRows(RunVolume& workpiece, std::int32_t first, std::int32_t end, const LineInterval& groups,
                              RemovedUnits& removed) noexcept {
    const auto count =
        static_cast<std::size_t>(spans_.intervals(first, end - first, groups, brickSpans_.data(), rowSpans_.data()));
    const std::span<const RowSpans> rows = std::span(rowSpans_).first(count);
    spans_.spans(rows);
    double cost = costOfReading * window_.take(workpiece, rows, removed);
    for (const RowSpans& row : rows) cost += row.groups;
    return cost;
}

/// Takes one row that is wider than the cache, which is moved along it. @return its cost, in groups
double WindowCutter::takeWideRow(RunVolume& workpiece, std::int32_t v, LineInterval groups,
                                 RemovedUnits& removed) noexcept {
    double cost = 0.0;
    for (; groups.first <= groups.last && !removed.outOfMemory; groups.first += window_.side()) {
        const std::int32_t last = std::min(groups.last, groups.first + window_.side() - 1);
        const std::optional<int> claimed = window_.cover(workpiece, v, v, groups.first, last);
        if (claimed)
            cost += costOfBrick * *claimed + takeRows(workpiece, v, v + 1, {groups.first, last}, removed);
        else
            removed.outOfMemory = true;
    }
    return cost;
}

/// Continues the oldest step. @return the remaining budget; the step is done if any is left
double WindowCutter::advance(RunVolume& workpiece, double budget, RemovedUnits& removed) noexcept {
    Step& step = steps_[firstStep_];
    spans_.begin(step.from, step.to, step.withStart);
    const LineInterval rows = rowsOf(spans_.rows()), groups = groupsOf(spans_.columns());
    if (rows.first <= rows.last && groups.first <= groups.last) {
        const bool covered = fits(rows, groups);
        if (covered) {
            const std::optional<int> claimed =
                window_.cover(workpiece, rows.first, rows.last, groups.first, groups.last);
            if (!claimed) {
                removed.outOfMemory = true;
                return budget;
            }
            budget -= costOfBrick * *claimed;
        }
        const double dearestRow = (groups.last - groups.first + 1) * (1.0 + 8.0 * costOfReading);
        std::int32_t v = std::max(rows.first, step.nextRow);
        while (v <= rows.last) {
            // The rows of a brick at once, unless they might exceed the remaining budget by far.
            const std::int32_t most = static_cast<std::int32_t>(std::clamp(budget / dearestRow, 1.0, 8.0));
            const std::int32_t end = covered ? std::min({rows.last, v | 7, v + most - 1}) + 1 : v + 1;
            budget -=
                covered ? takeRows(workpiece, v, end, groups, removed) : takeWideRow(workpiece, v, groups, removed);
            if (removed.outOfMemory) return budget; // the same rows again next time
            step.nextRow = v = end;
            if (budget < 0.0 && v <= rows.last) return budget;
        }
    }
    firstStep_ = (firstStep_ + 1) % mostSteps;
    --stepCount_;
    return std::max(budget, 0.0);
}

/// Returns false if out of memory; the step was not added then.
bool WindowCutter::add(RunVolume& workpiece, const Step& step, RemovedUnits& removed) noexcept {
    while (stepCount_ == mostSteps) {
        static_cast<void>(advance(workpiece, std::numeric_limits<double>::infinity(), removed));
        if (removed.outOfMemory) return false;
    }
    steps_[(firstStep_ + stepCount_++) % mostSteps] = step;
    return true;
}

/// Returns the interval of a move in which the piece may reach the grid, as fractions of the move: a jump over miles
/// must not cost more than one over the stock.
glm::dvec2 WindowCutter::intervalNearGrid(const glm::dvec3& from, const glm::dvec3& to) const noexcept {
    const double reach = spans_.reach() + 1.0;
    const glm::dvec3 size(grid_.lineCountU(), grid_.lineCountV(), grid_.voxelsPerLine());
    double first = 0.0, last = 1.0;
    for (int i = 0; i < 3; ++i) {
        const double way = to[i] - from[i], low = -reach - from[i], high = size[i] + reach - from[i];
        if (way == 0.0) {
            if (low > 0.0 || high < 0.0) return {1.0, 0.0};
            continue;
        }
        first = std::max(first, std::min(low / way, high / way));
        last = std::min(last, std::max(low / way, high / way));
    }
    return {first, last};
}

/// Adds the straight move between two tips with a fixed axis, in parts that are short enough.
std::size_t WindowCutter::addWay(RunVolume& workpiece, const LinePose& from, const glm::dvec3& to, bool withStart,
                                 RemovedUnits& removed) noexcept {
    const double ways = glm::length(to - from.tip) / spans_.longestWay(from.axis);
    if (ways <= mostSteps) return addParts(workpiece, from, to, withStart, removed);
    const glm::dvec2 near = intervalNearGrid(from.tip, to);
    if (near[0] > near[1]) return 0;
    const LinePose first{glm::mix(from.tip, to, near[0]), from.axis};
    return addParts(workpiece, first, glm::mix(from.tip, to, near[1]), withStart, removed);
}

std::size_t WindowCutter::addParts(RunVolume& workpiece, const LinePose& from, const glm::dvec3& to, bool withStart,
                                   RemovedUnits& removed) noexcept {
    constexpr double mostParts = 1e6; // no grid is so wide
    const double ways = std::ceil(glm::length(to - from.tip) / spans_.longestWay(from.axis) - 1e-9);
    const int parts = static_cast<int>(std::clamp(ways, 1.0, mostParts));
    std::size_t added = 0;
    glm::dvec3 tip = from.tip;
    for (int i = 1; i <= parts; ++i) {
        const glm::dvec3 next = i == parts ? to : glm::mix(from.tip, to, static_cast<double>(i) / parts);
        if (withStart || next != tip) {
            if (!add(workpiece, {{tip, from.axis}, next, withStart, 0}, removed)) return added;
            ++added;
        }
        withStart = false;
        tip = next;
    }
    return added;
}

/// Adds the move of a piece whose axis rotates, in steps with a fixed axis. Each step also takes what its axis covers
/// at the step's start, as the gaps hold only what another axis covered there.
std::size_t WindowCutter::addTurn(RunVolume& workpiece, const LinePose& from, const LinePose& to, bool withStart,
                                  RemovedUnits& removed) noexcept {
    const double angle = std::atan2(glm::length(glm::cross(from.axis, to.axis)), glm::dot(from.axis, to.axis));
    std::size_t added = 0;
    if (angle * spans_.reach() <= turnTolerance) {
        // The last axis is used for the whole move. The start with the first axis is within the tolerance of that with
        // the last one, and where a rim could increase the difference, the spans of leaning pieces include the start
        // anyway.
        if (withStart) added += addWay(workpiece, from, from.tip, true, removed);
        const bool asksForStart = from.tip == to.tip || spans_.isUpright(to.axis);
        return added + addWay(workpiece, {from.tip, to.axis}, to.tip, asksForStart, removed);
    }
    const PoseSteps steps({from.tip, from.axis}, {to.tip, to.axis}, spans_.reach(), turnTolerance);
    for (std::int32_t k = 0; k < steps.count() && !removed.outOfMemory; ++k) {
        const PoseStep step = steps.step(k);
        added += addWay(workpiece, {step.fromTip, step.axis}, step.toTip, withStart || k > 0, removed);
    }
    return added;
}

bool WindowCutter::cut(RunVolume& workpiece, const ToolPose& from, const ToolPose& to, RemovedUnits& removed) noexcept {
    const LinePose start = inLines(from), end = inLines(to);
    const bool connected = hasArrived_ && arrived_.tip == start.tip && arrived_.axis == start.axis;
    hasArrived_ = false;
    const std::size_t added = start.axis == end.axis ? addWay(workpiece, start, end.tip, !connected, removed)
                                                     : addTurn(workpiece, start, end, !connected, removed);
    double budget = std::max(tickBudget - costOfWriting * window_.writesDue(), leastBudget);
    while (stepCount_ > 0 && budget > 0.0 && !removed.outOfMemory) budget = advance(workpiece, budget, removed);
    window_.collect(removed);
    if (!window_.writeDue(workpiece)) removed.outOfMemory = true;
    if (removed.outOfMemory) {
        stepCount_ -= std::min(stepCount_, added); // older steps are still to be taken
        return stepCount_ > 0;
    }
    hasArrived_ = true;
    arrived_ = end;
    return stepCount_ > 0;
}

void WindowCutter::approach(RunVolume& workpiece, const ToolPose& pose) noexcept {
    lookAround(workpiece, pose);
    // This is a tick like any other: the pending writes of earlier cuts must not wait for the next cut. If out of
    // memory, they stay pending.
    static_cast<void>(window_.writeDue(workpiece));
}

void WindowCutter::lookAround(RunVolume& workpiece, const ToolPose& pose) noexcept {
    const LinePose place = inLines(pose);
    spans_.begin(place, place.tip, true);
    const LineInterval rows = rowsOf(spans_.rows()), all = groupsOf(spans_.columns());
    if (rows.first > rows.last || all.first > all.last || !fits(rows, all)) return;
    const std::optional<int> claimed = window_.cover(workpiece, rows.first, rows.last, all.first, all.last);
    if (!claimed) return;
    double budget = tickBudget - costOfBrick * *claimed - costOfWriting * window_.writesDue();
    for (std::int32_t v = rows.first; v <= rows.last && budget > 0.0; ++v) {
        if (spans_.intervals(v, 1, all, brickSpans_.data(), rowSpans_.data()) == 0) continue;
        spans_.spans({rowSpans_.data(), 1});
        budget -= rowSpans_[0].groups + costOfReading * window_.look(workpiece, rowSpans_[0]);
    }
}

void WindowCutter::settle(RunVolume& workpiece, RemovedUnits& removed) noexcept {
    while (stepCount_ > 0 && !removed.outOfMemory)
        static_cast<void>(advance(workpiece, std::numeric_limits<double>::infinity(), removed));
    window_.collect(removed);
    if (!window_.writeAll(workpiece)) removed.outOfMemory = true;
}

void WindowCutter::reset() noexcept {
    window_.forget();
    stepCount_ = 0;
    hasArrived_ = false;
}

} // namespace burin
