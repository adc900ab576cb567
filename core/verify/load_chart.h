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

/// A program that was replayed: what its moves met, and when.
struct ReplayedProgram {
    const ParsedProgram* program = nullptr;
    const std::vector<ToolMove>* moves = nullptr;
    const std::vector<MoveCut>* cuts = nullptr;  ///< by move
    const std::vector<StepCut>* steps = nullptr; ///< of the moves
    std::span<const Tool> tools;                 ///< those that ToolMove::tool counts
    const MachiningTime* time = nullptr;
    double voxel = 0.0; ///< mm
};

struct LoadRecord {
    std::vector<MotionLoad> motions; ///< of those that remove something, in program order
    std::vector<LoadStep> steps;     ///< over time, where something is removed
};
/// The load of a step; all but for the call.
struct ToldLoad {
    std::uint32_t number = 0; ///< of the motion, place in ParsedProgram::motions
    const NcMotion& motion;
    std::size_t tool = 0; ///< place in ReplayedProgram::tools
    const CutLoad& load;
    double feed = 0.0; ///< mm/min that the tip reaches there, the feed at most
    /// What the same step asks for at another feed, mm/min, > 0.
    const std::function<CutLoad(double feed)>& at;
};
/// Gets the load of every step.
using LoadVisitor = std::function<void(const ToldLoad&)>;

/// The load of a program, step by step. A step's engaged surface S and the area A that it shows along the move are
/// means over a quarter of the tool's radius of path about it, so that they do not follow single voxels; a path that
/// bends by more than 45 degrees is looked at on either side by itself. With v the feed, or what the machine reaches of
/// it, n the turns and z the teeth: MRR = A v, mean chip h = MRR / (n z S), power P = K(h) MRR + Kte n z S, Ft = P / v
/// of the edge, Fr = Kr (Ft of the chip) + Kre z S / (2 pi R) (Chen & Yang 2004, eq. 12; shear and edge forces as
/// Altintas has them). Where a step meets several materials, each has its own S, A and K, and the loads add up.
/// core/verify/README.md states the rules.
LoadRecord recordLoads(const ReplayedProgram& replayed, const PropertyList& properties, const LoadVisitor& visit);

/// The motion whose peak has the greatest force, or removal rate where no force is known; null for none.
const MotionLoad* peakLoad(const std::vector<MotionLoad>& loads);

} // namespace burin
