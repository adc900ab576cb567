// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/tool_bounds.h"

namespace burin::benchmarks {

/// What there is between the wish to mill and the first cut.
struct FirstCut {
    double ready = 0.0;          ///< s until a session can begin
    double cut = 0.0;            ///< s until stock is removed; the hand's own time in it
    double hand = 0.0;           ///< s that the hand needed: from where a session begins into the stock
    std::size_t fieldBytes = 0;  ///< of the boundary, when stock is removed
    std::uint64_t ticksHeld = 0; ///< in which the boundary kept the tool behind the hand
};

/// Works out what bounds the rig's tool and leads it, at 1 kHz and in real time, from above the middle of the stock
/// down into it, a voxel deep: as a session of the window begins. Cuts the workpiece. Errors: those of
/// ToolBounds::grow; notSupported (a part fills the stock there, so that nothing is cut within 30 s).
Result<FirstCut> firstCut(MillingContext& milling, Progress& progress);

} // namespace burin::benchmarks
