// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "core/path/height_map.h"

#include <array>
#include <memory>
#include <vector>

namespace burin {

struct MilledSides {
    std::vector<MillingInterval> intervals;   ///< in order
    std::shared_ptr<const HeightMap> cleared; ///< what this path and those before it clear; never null
};

/// Determines climb or conventional milling along a path: by the remaining stock on either side of the flutes, known
/// from the height map that links use; where there is stock on both sides or on neither, by the side on which the part
/// is nearest, within a radius of the tool. Rapids and moves straight up or down are neither. `Reverse`
/// (recording_edits.h) changes the side. Cancellable.
/// Errors: argumentInvalid (no part, no stock), cancelled.
Result<MilledSides> millingSides(const Path& path, const PathContext& context, Progress& progress);

/// The lengths that a path cuts on either side, mm, indexed by MillingSide.
std::array<double, 3> lengthsBySide(const Path& path, const std::vector<MillingInterval>& intervals);

} // namespace burin
