// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"
#include "core/job/recorded_time.h"

#include <memory>
#include <vector>

namespace burin {

/// A program over its machining time, in the form of recordings: one "take" for each section with one tool, in ticks of
/// `tick`. The curves are those of its check.
struct ProgramTime {
    /// The moment of a finding of the check.
    struct FindingMoment {
        TakeMoment at;
        std::size_t finding = 0; ///< index in VerifyReport::findings
    };

    RecordedTime time;                   ///< without kept workpieces and markers
    double tick = 0.0;                   ///< s
    std::vector<FindingMoment> findings; ///< in order
    /// Returns the motion (index in ParsedProgram::motions) that is in progress, or begins, at a moment; at the end the
    /// last motion. There must be one.
    std::size_t motionAt(const TakeMoment& moment) const noexcept;
    /// Returns the pose of the tool at a moment, setup frame, interpolated at the mean speed of the motion.
    ToolPose poseAt(const TakeMoment& moment) const noexcept;
    /// Returns the moment at which a motion begins, with the resolution of a tick.
    TakeMoment beginOf(std::size_t motion) const noexcept;

    std::vector<ToolPose> poses;        ///< at the end of each tick, of all takes in sequence
    std::vector<std::uint32_t> motions; ///< in progress at the end of each tick
    std::vector<std::uint64_t> first;   ///< per take: number of ticks before it

private:
    std::uint64_t ticksBefore(const TakeMoment& moment) const noexcept;
};

/// Spreads a program over its machining time. Ticks are 10 ms, longer if a program takes more than an hour and a half.
/// Thread-safe. Errors: cancelled.
Result<ProgramTime> programTime(const CheckedProgram& program, const MachineProfile& machine,
                                const glm::dvec3& workOffset, const Progress& progress);

} // namespace burin
