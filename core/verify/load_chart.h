// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/parser.h"
#include "core/tool/tool.h"
#include "core/verify/load.h"
#include "core/verify/machine_time.h"
#include "core/verify/replay.h"
#include "core/volume/runs/property_list.h"

#include <functional>
#include <span>
#include <vector>

namespace burin {

/// A replayed program: what its moves met, and when.
struct ReplayedProgram {
    const ParsedProgram* program = nullptr;
    const std::vector<ToolMove>* moves = nullptr;
    const std::vector<MoveCut>* cuts = nullptr;  ///< by move
    const std::vector<StepCut>* steps = nullptr; ///< of the moves
    std::span<const Tool> tools;                 ///< indexed by ToolMove::tool
    const MachiningTime* time = nullptr;
    double voxel = 0.0; ///< mm
};

struct LoadRecord {
    std::vector<MotionLoad> motions; ///< only motions that remove material, in program order
    std::vector<LoadStep> steps;     ///< over time, where material is removed
};
/// The load of a step; valid only during the call.
struct ToldLoad {
    std::uint32_t number = 0; ///< of the motion, index in ParsedProgram::motions
    const NcMotion& motion;
    std::size_t tool = 0; ///< index in ReplayedProgram::tools
    const CutLoad& load;
    double feed = 0.0; ///< mm/min that the tip reaches there, at most the programmed feed
    /// The load of the same step at another feed, mm/min, > 0.
    const std::function<CutLoad(double feed)>& at;
};
/// Called with the load of every step.
using LoadVisitor = std::function<void(const ToldLoad&)>;

/// The load of a program, step by step. The engaged surface S of a step and the area A that it presents along the move
/// are means over a quarter of the tool's radius of path around it, so that they do not follow single voxels; at a bend
/// of the path by more than 45 degrees each side is treated separately. With v the feed, or what the machine reaches of
/// it, n the spindle speed and z the number of teeth: MRR = A v, mean chip h = MRR / (n z S), power P = K(h) MRR + Kte
/// n z S, Ft = P / v of the edge, Fr = Kr (Ft of the chip) + Kre z S / (2 pi R) (Chen & Yang 2004, eq. 12; shear and
/// edge forces as in Altintas). Where a step meets several materials, each has its own S, A and K, and the loads add
/// up. core/verify/README.md states the rules.
LoadRecord recordLoads(const ReplayedProgram& replayed, const PropertyList& properties, const LoadVisitor& visit);

/// The motion whose peak has the greatest force, or removal rate if no force is known; null if there is none.
const MotionLoad* peakLoad(const std::vector<MotionLoad>& loads);

} // namespace burin
