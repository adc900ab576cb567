// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cutting/removal.h"
#include "core/recording/sample.h"
#include "core/tool/tool.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Finds the motions of a recording that cut and were not taken back, while its samples are read in their order.
class CutFinder {
public:
    /// @param undone of the take; outlives the finder
    explicit CutFinder(std::span<const SampleRange> undone) noexcept : undone_(undone) {}

    using Use = std::function<Result<void>(const ToolPose& from, const ToolPose& to)>;
    /// Calls `use` with each motion that one of these samples ends; its first error ends the search.
    /// @param next samples, behind those of the call before
    Result<void> find(std::span<const Sample> next, const Use& use);

private:
    UndoneSamples undone_;
    std::uint64_t index_ = 0;
    std::optional<ToolPose> before_;
};

/// Motions that cut, in their order, to the bit: 24 bytes each where the axis is fixed, against 336 of a sample, so
/// that hours of milling can be handed to the thread that cuts them again.
class CutMotions {
public:
    /// Adds a motion behind the others.
    void add(const ToolPose& from, const ToolPose& to);
    std::uint64_t count() const noexcept { return count_; }
    /// Calls `use` with each of them. Errors: its first one.
    Result<void> visit(const CutFinder::Use& use) const;

private:
    /// Motions behind each other with one axis; its tips one more than motions.
    struct Run {
        glm::dvec3 firstAxis, axis; ///< of its first pose, and of all others
        std::vector<glm::dvec3> tips;
    };
    std::vector<Run> runs_;
    std::uint64_t count_ = 0;
};

/// Cuts a recording again, as the hand's ticks cut, so that the result is theirs to the last unit.
class CutReplay {
public:
    /// @param workpiece outlives the replay
    CutReplay(const Tool& tool, RunVolume& workpiece);

    /// Errors: volumeOutOfMemory.
    Result<void> cut(const ToolPose& from, const ToolPose& to);
    /// All cuts are in the workpiece. Errors: volumeOutOfMemory.
    Result<void> finish();

private:
    RunVolume& workpiece_;
    MaterialRemoval removal_;
};

} // namespace burin
