// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/parser.h"
#include "core/tool/tool.h"
#include "core/verify/load.h"
#include "core/verify/machine_time.h"
#include "core/verify/replay.h"
#include "core/volume/property_list.h"

#include <span>
#include <vector>

namespace burin {

/// The load of every motion that removes something, in program order. K is that of the mean chip of a slot at the
/// motion's own feed per tooth (2 fz / pi), where the material has a law of the chip (core/cutting/cutting_force.h);
/// Ft = 1000 K MRR / v with v the speed of the flutes' edge (Chen & Yang 2004, eq. 12).
/// @param moves    those that `cuts` belong to
/// @param tools    those that ToolMove::tool counts
/// @param material what is removed
std::vector<MotionLoad> loadChart(const ParsedProgram& program, const std::vector<ToolMove>& moves,
                                  const std::vector<MoveCut>& cuts, std::span<const Tool> tools,
                                  const MachiningTime& time, const PropertyList& properties, PropertyIndex material);

/// The motion with the greatest force, or removal rate where no force is known; null for none.
const MotionLoad* peakLoad(const std::vector<MotionLoad>& chart);

} // namespace burin
