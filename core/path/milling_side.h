// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/cleared_heights.h"
#include "core/path/evaluate.h"

#include <array>
#include <memory>
#include <vector>

namespace burin {

struct MilledSides {
    std::vector<MillingStretch> stretches;         ///< in order
    std::shared_ptr<const ClearedHeights> cleared; ///< what this path and those before it clear; never null
};

/// Which it is along a path: by the stock that is left on either side of the flutes, known from the height map that
/// links use; where that stands on both sides or on none, by the side on which the part is nearest, within a radius of
/// the tool. Rapids and moves straight up or down are neither. `Reverse` (recording_edits.h) changes it. Cancellable.
/// Errors: argumentInvalid (no part, no stock), cancelled.
Result<MilledSides> millingSides(const Path& path, const PathContext& context, Progress& progress);

/// mm that a path cuts on either side, by MillingSide.
std::array<double, 3> lengthsBySide(const Path& path, const std::vector<MillingStretch>& stretches);

} // namespace burin
