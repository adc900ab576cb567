// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// Which way the teeth go through what they cut, with a spindle that turns clockwise seen from above (M3).
enum class MillingSide : std::uint8_t {
    neither,      ///< material on both sides or none: a slot, a plunge, a face from above
    climb,        ///< it lies to the right of the motion: chips begin thick
    conventional, ///< it lies to the left: chips begin thin
};

/// Moves of a path that follow each other and are alike: those that end in points first … last.
struct MillingStretch {
    std::size_t first = 0, last = 0;
    MillingSide side = MillingSide::neither;
};

/// Which it is along a path: by the stock that is left on either side of the flutes, known from the height map that
/// links use; where that stands on both sides or on none, by the side on which the part is nearest, within a radius of
/// the tool. Rapids and moves straight up or down are neither. `Reverse` (recording_edits.h) changes it.
/// Errors: argumentInvalid (no part, no stock).
Result<std::vector<MillingStretch>> millingSides(const Path& path, const PathContext& context);

} // namespace burin
