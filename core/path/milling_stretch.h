// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

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

} // namespace burin
