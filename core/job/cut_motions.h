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

/// Finds the motions of a recording that cut and were not undone, while its samples are read in order.
class CutFinder {
public:
    /// @param undone undone samples of the take; must outlive the finder
    explicit CutFinder(std::span<const SampleRange> undone) noexcept : undone_(undone) {}

    /// @param sample the sample of the take that the motion ends with
    using Use = std::function<Result<void>(const ToolPose& from, const ToolPose& to, std::uint64_t sample)>;
    /// Calls `use` with each motion that ends with one of these samples; its first error ends the search.
    /// @param next the samples that follow those of the previous call
    Result<void> find(std::span<const Sample> next, const Use& use);

private:
    UndoneSamples undone_;
    std::uint64_t index_ = 0;
    std::optional<ToolPose> before_;
};

/// Motions that cut, in order and bitwise exact, and the samples that they end with. A motion takes 28 bytes if the
/// axis is fixed, against 336 of a sample, so that hours of milling can be passed to the thread that cuts them again.
class CutMotions {
public:
    /// Appends a motion. @param sample not smaller than that of the previous motion, below 2^32 (49 days of a take)
    void add(const ToolPose& from, const ToolPose& to, std::uint64_t sample);
    std::uint64_t count() const noexcept { return samples_.size(); }
    /// Calls `use` with each motion. Errors: the first one of `use`.
    Result<void> visit(const CutFinder::Use& use) const { return visit(0, count(), use); }
    /// Calls `use` with the motions in [first, end), counted from 0. Errors: the first one of `use`.
    Result<void> visit(std::uint64_t first, std::uint64_t end, const CutFinder::Use& use) const;
    /// Returns the number of motions that end with one of the first `samples` samples of the take.
    std::uint64_t countWithin(std::uint64_t samples) const noexcept;
    /// Returns the sample that a motion ends with. @param motion below `count`
    std::uint64_t sampleOf(std::uint64_t motion) const noexcept { return samples_[motion]; }

private:
    /// Consecutive motions with the same axis; has one more tip than motions.
    struct Run {
        glm::dvec3 firstAxis, axis; ///< of the first pose, and of all other poses
        std::uint64_t before = 0;   ///< motions of the preceding runs
        std::vector<glm::dvec3> tips;
    };
    std::vector<Run> runs_;
    std::vector<std::uint32_t> samples_; ///< by motion
};

/// Cuts a recording again in the same ticks as the hand, so that the result is identical to the last unit.
class CutReplay {
public:
    /// @param workpiece must outlive the replay
    CutReplay(const Tool& tool, RunVolume& workpiece);

    /// Errors: volumeOutOfMemory.
    Result<void> cut(const ToolPose& from, const ToolPose& to);
    /// Completes the replay: afterwards all cuts are in the workpiece. Errors: volumeOutOfMemory.
    Result<void> finish();

private:
    RunVolume& workpiece_;
    MaterialRemoval removal_;
};

} // namespace burin
