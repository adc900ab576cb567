// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"
#include "core/job/recorded_time.h"

#include <memory>
#include <vector>

namespace burin {

/// A program along the time that the machine takes for it, in the form of recordings: a "take" for each stretch with
/// one tool, in ticks of `tick`. Curves are those of its check.
struct ProgramTime {
    /// Where the check found something.
    struct FindingMoment {
        TakeMoment at;
        std::size_t finding = 0; ///< place in VerifyReport::findings
    };

    RecordedTime time;                   ///< without kept workpieces and markers
    double tick = 0.0;                   ///< s
    std::vector<FindingMoment> findings; ///< in order
    /// The motion (place in ParsedProgram::motions) that is under way, or begins, at a moment; at the end the last.
    /// There must be one.
    std::size_t motionAt(const TakeMoment& moment) const noexcept;
    /// Where the tool is then, setup frame: on its way at the mean speed of the motion.
    ToolPose poseAt(const TakeMoment& moment) const noexcept;
    /// The moment at which a motion begins, to a tick.
    TakeMoment beginOf(std::size_t motion) const noexcept;

    std::vector<ToolPose> poses;        ///< when each tick of all takes is over, one behind the other
    std::vector<std::uint32_t> motions; ///< the same: under way then
    std::vector<std::uint64_t> first;   ///< by take: ticks before it

private:
    std::uint64_t ticksBefore(const TakeMoment& moment) const noexcept;
};

/// Spreads a program over its time. Ticks are 10 ms, longer where a program takes more than an hour and a half. Any
/// thread. Errors: cancelled.
Result<ProgramTime> programTime(const CheckedProgram& program, const MachineProfile& machine,
                                const glm::dvec3& workOffset, const Progress& progress);

} // namespace burin
