// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cut_cache.h"
#include "core/geometry/pose.h"
#include "core/tool/span_rows.h"

#include <array>
#include <vector>

namespace burin {

/// Removes the volume that one convex piece sweeps from a workpiece through a CutCache, within the bounds of a tick:
/// work that exceeds a tick (a large tool's first contact) is put off to the next ones and done oldest first. The
/// bounds hold as long as no more than 64 moves are put off (`SpanRows::longestWay`); a tick that adds more, as a
/// leaning bull nose with a corner of a tenth of a voxel does at 6 voxels a tick, executes the oldest at once.
/// Only on the workpiece's writer thread.
class WindowCutter {
public:
    /// Largest deviation of a point of a piece from its position while the axis rotates, voxels.
    static constexpr double turnTolerance = 0.1;
    /// @param piece mm; one for which `serves` is true. Allocates.
    WindowCutter(const RevolvedPiece& piece, const Grid& grid);
    static bool serves(const RevolvedPiece& piece) noexcept { return SpanRows::serves(piece); }

    /// Cuts along a move. If reserved memory runs out, the remainder of this move is not removed.
    /// @return true: part of it is put off
    bool cut(RunVolume& workpiece, const ToolPose& from, const ToolPose& to, RemovedUnits& removed) noexcept;
    void approach(RunVolume& workpiece, const ToolPose& pose) noexcept;
    /// Removes what was put off, and writes everything.
    void settle(RunVolume& workpiece, RemovedUnits& removed) noexcept;
    bool settled() const noexcept { return stepCount_ == 0 && window_.owesNothing(); }
    /// Forgets the workpiece and everything that is pending.
    void reset() noexcept;
    const CutCache& window() const noexcept { return window_; }

private:
    /// A move with a fixed axis.
    struct Step {
        LinePose from;
        glm::dvec3 to{0.0};
        bool withStart = true;
        std::int32_t nextRow = 0; ///< the rows before it are done
    };
    static constexpr std::size_t mostSteps = 64; ///< largest number that is put off at once

    LinePose inLines(const ToolPose& pose) const noexcept;
    glm::dvec2 intervalNearGrid(const glm::dvec3& from, const glm::dvec3& to) const noexcept;
    std::size_t addParts(RunVolume& workpiece, const LinePose& from, const glm::dvec3& to, bool withStart,
                         RemovedUnits& removed) noexcept;
    void lookAround(RunVolume& workpiece, const ToolPose& pose) noexcept;
    std::size_t addWay(RunVolume& workpiece, const LinePose& from, const glm::dvec3& to, bool withStart,
                       RemovedUnits& removed) noexcept;
    std::size_t addTurn(RunVolume& workpiece, const LinePose& from, const LinePose& to, bool withStart,
                        RemovedUnits& removed) noexcept;
    bool add(RunVolume& workpiece, const Step& step, RemovedUnits& removed) noexcept;
    double advance(RunVolume& workpiece, double budget, RemovedUnits& removed) noexcept;
    LineInterval groupsOf(const LineInterval& lines) const noexcept;
    LineInterval rowsOf(const LineInterval& rows) const noexcept;
    bool fits(const LineInterval& rows, const LineInterval& groups) const noexcept;
    double takeRows(RunVolume& workpiece, std::int32_t first, std::int32_t end, const LineInterval& groups,
                    RemovedUnits& removed) noexcept;
    double takeWideRow(RunVolume& workpiece, std::int32_t v, LineInterval groups, RemovedUnits& removed) noexcept;

    Grid grid_;
    double radius_;
    SpanRows spans_;
    CutCache window_;
    std::vector<BrickOfSpans> brickSpans_; ///< of the rows that are taken at once
    std::array<RowSpans, SpanRows::rowsAtOnce> rowSpans_;

    std::array<Step, mostSteps> steps_; ///< a ring buffer
    std::size_t firstStep_ = 0, stepCount_ = 0;
    bool hasArrived_ = false; ///< the piece has already been at the end of the last move (or will have, once all steps
                              ///< are done)
    LinePose arrived_;
};

} // namespace burin
