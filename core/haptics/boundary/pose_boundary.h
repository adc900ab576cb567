// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

#include <cstdint>
#include <optional>

namespace burin {

/// How far a tool at a pose keeps from what it must not enter, and how that changes.
struct PoseSample {
    double clearance = 0.0;   ///< mm; negative: inside
    glm::dvec3 gradient{0.0}; ///< of the clearance by the tip, about unit length
    glm::dvec3 turning{0.0};  ///< mm/rad, of the clearance by a turn about the tip; square to the axis
    bool fine = false;        ///< near enough for the gradient to be one that a tool can slide along
};

/// A tile of a boundary that grows (GrowingBoundary) comes into force, or is given up.
struct TileChange {
    std::uint32_t tile = 0;
    bool there = false;
};

/// Bounds the poses of one tool: something solid that it must not enter, or a space that it must not leave. The haptic
/// loop's proxy moves in it. One thread at a time, as it may remember its last answers; those depend on the poses asked
/// alone, so that a replay gets the same ones. No allocation, no exception.
class PoseBoundary {
public:
    virtual ~PoseBoundary() = default;
    /// The clearance falls no faster than the tool's farthest point moves.
    /// @param enough mm: a clearance above it may be answered as any from `enough` up to the true one, not fine
    virtual PoseSample at(const ToolPose& pose, double enough) noexcept = 0;
    /// Largest error of a fine `clearance`, mm.
    virtual double errorBound() const noexcept = 0;
    /// mm over which a sample's gradients tell about its neighbourhood; walls thicker than a quarter are not missed.
    virtual double spacing() const noexcept = 0;
    /// mm that no point of the tool may move by, at once, for the tool to overlap where it was: so far nothing solid
    /// passes it unseen. 0: not known.
    virtual double overlap() const noexcept = 0;
    /// mm from the tip to the farthest point of the tool that counts; 0 where a turn changes nothing.
    virtual double reach() const noexcept = 0;
    /// What all answers took together, in units as ClearanceAsker::work; the same poses take the same, on any machine.
    /// 0 where answers are too quick to count.
    virtual std::uint64_t work() const noexcept { return 0; }
    /// Between two ticks: what of the boundary has come meanwhile, or has to go; the next after it was applied.
    /// @param tool where it is
    virtual std::optional<TileChange> nextChange(const ToolPose&) noexcept { return std::nullopt; }
    /// What `nextChange` told, or told when a session was recorded.
    virtual void apply(const TileChange&) noexcept {}
};

} // namespace burin
