// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/cutting/tool_beam.h"
#include "core/verify/findings.h"
#include "core/verify/load_chart.h"

#include <array>
#include <map>
#include <span>
#include <vector>

namespace burin {

/// Judges what a program asks of spindle and tools, step by step: power and torque against the machine, bending stress,
/// chip, depth and width against the tool's limits, bending against a tolerance. Limits that are not stated are not
/// judged. One thread.
class LoadJudge {
public:
    /// All outlive the judge. @param bending mm that a tool may deflect by
    LoadJudge(const MachineProfile& machine, std::span<const Tool> tools, double bending);

    void look(const ToldLoad& told);
    /// Beyond a stated limit: a finding. Beyond an estimated one, or bending: a warning. One of a kind within a
    /// tool's diameter (10 mm of a smaller one), with its worst line; `Finding::count` tells how many lines it
    /// stands for; at most 20 of a kind, the worst first, the last of which counts those left out.
    void conclude(Findings& findings, std::vector<Finding>& warnings) const;
    /// Of the motions that ask for more than is stated or estimated, in program order: the greatest feed at which each
    /// asks for no more power, torque, bending stress and chip than that.
    std::vector<FeedLimit> feedLimits() const;

private:
    /// What comes down with the feed, beside its limit; a limit of 0 is none.
    struct Asked {
        FindingKind kind = FindingKind::spindlePower;
        double amount = 0.0, limit = 0.0;
        bool estimated = false;
    };
    std::array<Asked, 4> askedByFeed(const NcMotion& motion, std::size_t tool, const CutLoad& load) const;
    static bool areWithin(const std::array<Asked, 4>& asked);
    struct Excess {
        Finding finding;
        double diameter = 0.0; ///< mm, of the tool
        bool warns = false;
        double share() const noexcept { return finding.amount / finding.limit; }
    };
    void judge(const ToldLoad& told, const Asked& asked);
    void limitFeed(const ToldLoad& told);
    static std::vector<Excess> gathered(std::vector<Excess> all);

    const MachineProfile* machine_;
    std::span<const Tool> tools_;
    double bending_;
    std::vector<ToolBeam> beams_;                                   ///< by tool
    std::map<std::pair<FindingKind, std::uint32_t>, Excess> worst_; ///< by kind and line
    std::map<std::uint32_t, double> feeds_;                         ///< mm/min, by motion
};

/// The tangential force that tool and spindle bear at most, and which of their limits that is.
struct ForceLimit {
    double force = 0.0;                           ///< N; 0: nothing is stated
    FindingKind kind = FindingKind::toolBreakage; ///< or spindlePower, spindleTorque
};
/// The tool as if all of the force attacked its tip. @param spindleSpeed 1/min, > 0
ForceLimit forceLimit(const Tool& tool, const MachineProfile& machine, double spindleSpeed);

/// A cut of which the depth is looked for.
struct BearableCut {
    double width = 0.0;   ///< mm, across the move; the tool's diameter at most
    double bending = 0.0; ///< mm that the tool may deflect by, > 0
};
/// mm: the deepest cut of a width that spindle and tool bear, and every shallower one, and under which the tool bends
/// by no more than it may, at the feed and speed of the tables; the flutes' length where they bear that. Forces of a
/// straight cut in the mean over a turn, as `recordLoads` has them; tangential and radial count as if each had one
/// direction all the turn, which is more than the tool feels.
double bearableDepth(const Tool& tool, const CuttingConditions& conditions, const CuttingCoefficients::Entry& material,
                     const MachineProfile& machine, const BearableCut& cut);

} // namespace burin
