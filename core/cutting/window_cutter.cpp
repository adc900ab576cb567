// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/window_cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

/// What a tick may cost, in groups of eight lines: half a millisecond on the machine of the README's figures.
constexpr double tickBudget = 50000.0;
constexpr double costOfReading = 5.0; // of a line of the volume, in groups

RevolvedPiece inVoxels(const RevolvedPiece& piece, double edge) noexcept {
    return {piece.bottom / edge, piece.top / edge, piece.bottomRadius / edge, piece.topRadius / edge,
            piece.cornerRadius / edge};
}

} // namespace

WindowCutter::WindowCutter(const RevolvedPiece& piece, const Grid& grid)
    : grid_(grid)
    , radius_(piece.bottomRadius / grid.edge())
    , spans_(inVoxels(piece, grid.edge()), static_cast<std::int32_t>(grid.lineEnd()))
    , window_(grid, radius_ + 0.5 * spans_.longestWay() + 1.0)
    , low_(static_cast<std::size_t>(grid.lineCountU()) / 8 + 2)
    , high_(low_.size()) {}

LinePose WindowCutter::inLines(const ToolPose& pose) const noexcept {
    const int u = grid_.axisOfU(), v = grid_.axisOfV(), along = grid_.axisOfRuns();
    const glm::dvec3 place = (pose.tip - grid_.low()) / grid_.edge();
    return {{place[u] - 0.5, place[v] - 0.5, place[along]}, {pose.axis[u], pose.axis[v], pose.axis[along]}};
}

LineStretch WindowCutter::groupsOf(const LineStretch& lines) const noexcept {
    const std::int32_t first = std::max(lines.first, 0), last = std::min(lines.last, grid_.lineCountU() - 1);
    return last < first ? LineStretch{} : LineStretch{first >> 3, last >> 3};
}

bool WindowCutter::cover(RunVolume& workpiece, const LineStretch& rows) noexcept {
    const LineStretch groups = groupsOf(spans_.columns());
    if (groups.last < groups.first) return true;
    return window_.cover(workpiece, rows.first, rows.last, groups.first, groups.last);
}

/// Goes on with the oldest step. @return what is left of the budget; the step is done where any is
double WindowCutter::advance(RunVolume& workpiece, double budget, RemovedUnits& removed) noexcept {
    Step& step = steps_[firstStep_];
    spans_.begin(step.from, step.to, step.withStart);
    LineStretch rows = spans_.rows();
    rows = {std::max(rows.first, 0), std::min(rows.last, grid_.lineCountV() - 1)};
    if (rows.first <= rows.last && !cover(workpiece, rows)) {
        removed.outOfMemory = true;
        return budget;
    }
    for (std::int32_t v = std::max(rows.first, step.nextRow); v <= rows.last; ++v) {
        const LineStretch groups = groupsOf(spans_.row(v));
        if (groups.last < groups.first) continue;
        const std::int32_t count = groups.last - groups.first + 1;
        spans_.spans(v, groups.first, count, low_.data(), high_.data());
        const int read = window_.take(workpiece, v, groups.first, count, low_.data(), high_.data(), removed);
        step.nextRow = v; // again, should memory have run out within
        if (removed.outOfMemory) return budget;
        step.nextRow = v + 1;
        budget -= count + costOfReading * read;
        if (budget < 0.0 && v < rows.last) return budget;
    }
    firstStep_ = (firstStep_ + 1) % mostSteps;
    --stepCount_;
    return std::max(budget, 0.0);
}

/// False: out of memory, the step is not among the others.
bool WindowCutter::add(RunVolume& workpiece, const Step& step, RemovedUnits& removed) noexcept {
    while (stepCount_ == mostSteps) {
        static_cast<void>(advance(workpiece, std::numeric_limits<double>::infinity(), removed));
        if (removed.outOfMemory) return false;
    }
    steps_[(firstStep_ + stepCount_++) % mostSteps] = step;
    return true;
}

bool WindowCutter::cut(RunVolume& workpiece, const ToolPose& from, const ToolPose& to,
                       RemovedUnits& removed) noexcept {
    const LinePose start = inLines(from), end = inLines(to);
    std::size_t added = 0;
    const bool connected = hasArrived_ && arrived_.tip == start.tip && arrived_.axis == start.axis;
    hasArrived_ = false;
    const int parts = std::max(1, static_cast<int>(std::ceil(glm::length(end.tip - start.tip) / spans_.longestWay())));
    glm::dvec3 tip = start.tip;
    for (int i = 1; i <= parts && !removed.outOfMemory; ++i) {
        const glm::dvec3 next = i == parts ? end.tip : glm::mix(start.tip, end.tip, static_cast<double>(i) / parts);
        if (!(connected && next == tip) && add(workpiece, {{tip, start.axis}, next, i == 1 && !connected, 0}, removed))
            ++added;
        tip = next;
    }
    double budget = tickBudget;
    while (stepCount_ > 0 && budget > 0.0 && !removed.outOfMemory) budget = advance(workpiece, budget, removed);
    if (!window_.writeDue(workpiece)) removed.outOfMemory = true;
    if (removed.outOfMemory) {
        stepCount_ -= std::min(stepCount_, added); // older ones are still to be taken
        return stepCount_ > 0;
    }
    hasArrived_ = true;
    arrived_ = end;
    return stepCount_ > 0;
}

void WindowCutter::approach(RunVolume& workpiece, const ToolPose& pose) noexcept {
    const LinePose place = inLines(pose);
    spans_.begin(place, place.tip, true);
    LineStretch rows = spans_.rows();
    rows = {std::max(rows.first, 0), std::min(rows.last, grid_.lineCountV() - 1)};
    if (rows.first > rows.last || !cover(workpiece, rows)) return;
    double budget = tickBudget;
    for (std::int32_t v = rows.first; v <= rows.last && budget > 0.0; ++v) {
        const LineStretch groups = groupsOf(spans_.row(v));
        if (groups.last < groups.first) continue;
        const std::int32_t count = groups.last - groups.first + 1;
        spans_.spans(v, groups.first, count, low_.data(), high_.data());
        budget -= count + costOfReading * window_.look(workpiece, v, groups.first, count, low_.data(), high_.data());
    }
}

void WindowCutter::settle(RunVolume& workpiece, RemovedUnits& removed) noexcept {
    while (stepCount_ > 0 && !removed.outOfMemory)
        static_cast<void>(advance(workpiece, std::numeric_limits<double>::infinity(), removed));
    if (!window_.writeAll(workpiece)) removed.outOfMemory = true;
}

void WindowCutter::reset() noexcept {
    window_.forget();
    stepCount_ = 0;
    hasArrived_ = false;
}

} // namespace burin
