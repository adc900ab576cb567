// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/tool_bounds.h"

namespace burin::benchmarks {

/// The times between the request to mill and the first cut.
struct FirstCut {
    double ready = 0.0;          ///< s until a session can begin
    double cut = 0.0;            ///< s until stock is removed, including the hand's own time
    double hand = 0.0;           ///< s that the hand needs from the start of a session into the stock
    std::size_t fieldBytes = 0;  ///< memory of the boundary when stock is removed
    std::uint64_t ticksHeld = 0; ///< ticks in which the boundary kept the tool behind the hand
};

/// Computes the bounds of the tool and moves it at 1 kHz in real time from above the middle of the stock into it, a
/// voxel deep, as a session in the window begins. Cuts the workpiece. Errors: those of ToolBounds::grow; notSupported
/// (a part fills the stock there, so that nothing is cut within 30 s).
Result<FirstCut> firstCut(MillingContext& milling, Progress& progress);

} // namespace burin::benchmarks
