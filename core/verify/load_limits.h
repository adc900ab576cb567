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

/// Judges the loads of a program on spindle and tools, step by step: power and torque against the machine; bending
/// stress, chip, depth and width against the limits of the tool; bending against a tolerance. Limits that are not
/// stated are not judged. Not thread-safe.
class LoadJudge {
public:
    /// Keeps references; all must outlive the judge. @param bending allowed deflection of a tool, mm
    LoadJudge(const MachineProfile& machine, std::span<const Tool> tools, double bending);

    void look(const ToldLoad& told);
    /// Reports what exceeds a stated limit as a finding, and what exceeds an estimated limit, or the bending tolerance,
    /// as a warning. One of each kind is reported within a tool's diameter (within 10 mm for smaller tools), with its
    /// worst line; `Finding::count` is the number of lines that it stands for. At most 20 of a kind, the worst first;
    /// the last one counts those left out.
    void conclude(Findings& findings, std::vector<Finding>& warnings) const;
    /// For the motions that exceed a stated or estimated limit, in program order: the greatest feed at which power,
    /// torque, bending stress and chip are all within their limits.
    std::vector<FeedLimit> feedLimits() const;

private:
    /// A load that decreases with the feed, with its limit; a limit of 0 means none.
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

/// The greatest tangential force that tool and spindle can bear, and the limit that determines it.
struct ForceLimit {
    double force = 0.0;                           ///< N; 0: nothing is stated
    FindingKind kind = FindingKind::toolBreakage; ///< or spindlePower, spindleTorque
};
/// Computed as if the whole force acted on the tip. @param spindleSpeed 1/min, > 0
ForceLimit forceLimit(const Tool& tool, const MachineProfile& machine, double spindleSpeed);

/// A cut whose depth is to be determined.
struct BearableCut {
    double width = 0.0;   ///< mm, across the move; at most the diameter of the tool
    double bending = 0.0; ///< allowed deflection of the tool, mm, > 0
};
/// The deepest cut of a width, mm, such that at this and every smaller depth spindle and tool can bear the load and the
/// tool bends by no more than allowed, at the feed and speed of the tables; the flute length if even that is possible.
/// The forces are means over a turn in a straight cut, as in `recordLoads`; tangential and radial force count as if
/// each kept one direction throughout the turn, which overestimates the load on the tool.
double bearableDepth(const Tool& tool, const CuttingConditions& conditions, const CuttingCoefficients::Entry& material,
                     const MachineProfile& machine, const BearableCut& cut);

} // namespace burin
