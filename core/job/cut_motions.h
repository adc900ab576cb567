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

    /// @param sample of the take, that the motion ends with
    using Use = std::function<Result<void>(const ToolPose& from, const ToolPose& to, std::uint64_t sample)>;
    /// Calls `use` with each motion that one of these samples ends; its first error ends the search.
    /// @param next samples, behind those of the call before
    Result<void> find(std::span<const Sample> next, const Use& use);

private:
    UndoneSamples undone_;
    std::uint64_t index_ = 0;
    std::optional<ToolPose> before_;
};

/// Motions that cut, in their order, to the bit, and which samples they end with: 28 bytes each where the axis is
/// fixed, against 336 of a sample, so that hours of milling can be handed to the thread that cuts them again.
class CutMotions {
public:
    /// Adds a motion behind the others. @param sample no smaller than that of the motion before, below 2^32 (49 days of
    /// a take)
    void add(const ToolPose& from, const ToolPose& to, std::uint64_t sample);
    std::uint64_t count() const noexcept { return samples_.size(); }
    /// Calls `use` with each of them. Errors: its first one.
    Result<void> visit(const CutFinder::Use& use) const { return visit(0, count(), use); }
    /// The same with those from `first` on and before `end`, counted from 0.
    Result<void> visit(std::uint64_t first, std::uint64_t end, const CutFinder::Use& use) const;
    /// How many of them end with one of the first `samples` of the take.
    std::uint64_t countWithin(std::uint64_t samples) const noexcept;
    /// The sample that a motion ends with. @param motion below `count`
    std::uint64_t sampleOf(std::uint64_t motion) const noexcept { return samples_[motion]; }

private:
    /// Motions behind each other with one axis; its tips one more than motions.
    struct Run {
        glm::dvec3 firstAxis, axis; ///< of its first pose, and of all others
        std::uint64_t before = 0;   ///< motions of the runs before it
        std::vector<glm::dvec3> tips;
    };
    std::vector<Run> runs_;
    std::vector<std::uint32_t> samples_; ///< by motion
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
