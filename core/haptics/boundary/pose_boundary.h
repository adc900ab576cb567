// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

#include <cstdint>
#include <optional>

namespace burin {

/// The clearance of a tool at a pose from what it must not enter, and its derivatives.
struct PoseSample {
    double clearance = 0.0;   ///< mm; negative: inside
    glm::dvec3 gradient{0.0}; ///< of the clearance with respect to the tip, about unit length
    /// mm/rad, derivative of the clearance with respect to a rotation about the tip; perpendicular to the axis
    glm::dvec3 turning{0.0};
    bool fine = false; ///< near enough to the surface for a tool to slide along the gradient
};

/// A tile of a boundary that grows (GrowingBoundary) comes into force, or is released.
struct TileChange {
    std::uint32_t tile = 0;
    bool there = false;
};

/// Limits the poses of one tool: a solid that it must not enter, or a space that it must not leave. The haptic loop's
/// proxy moves within it. Used by one thread at a time, as it may cache its last results; they depend only on the poses
/// queried, so that a replay gets the same results. No allocation, no exception.
class PoseBoundary {
public:
    virtual ~PoseBoundary() = default;
    /// The clearance at a pose. It decreases no faster than the tool's farthest point moves.
    /// @param enough mm: for a larger clearance any value from `enough` to the true clearance may be returned, not fine
    virtual PoseSample at(const ToolPose& pose, double enough) noexcept = 0;
    /// Largest error of a fine clearance, mm.
    virtual double errorBound() const noexcept = 0;
    /// Distance over which the gradient of a sample is valid, mm; walls thicker than a quarter of it are not missed.
    virtual double spacing() const noexcept = 0;
    /// Largest motion, mm, of any point of the tool in one step for which the tool still overlaps its previous
    /// position, so that it can't pass through a solid undetected. 0: not known.
    virtual double overlap() const noexcept = 0;
    /// Distance from the tip to the farthest relevant point of the tool, mm; 0 if rotations have no effect.
    virtual double reach() const noexcept = 0;
    /// The total work of all queries so far, in the units of ClearanceAsker::work; the same poses give the same value
    /// on any machine. 0 if queries are too fast to count.
    virtual std::uint64_t work() const noexcept { return 0; }
    /// Called between two ticks: the next part of the boundary that has become available or has to be released. Returns
    /// the following one only after this one was applied.
    /// @param tool its current pose
    virtual std::optional<TileChange> nextChange(const ToolPose&) noexcept { return std::nullopt; }
    /// Applies a change returned by `nextChange`, now or when a session was recorded.
    virtual void apply(const TileChange&) noexcept {}
};

} // namespace burin
