// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace burin {

/// On which side of the motion the material lies, for a spindle that turns clockwise seen from above (M3).
enum class MillingSide : std::uint8_t {
    neither,      ///< material on both sides or none: a slot, a plunge, a face from above
    climb,        ///< material to the right of the motion: chips begin thick
    conventional, ///< material to the left: chips begin thin
};

/// Consecutive moves of a path with the same side: those that end in points first … last.
struct MillingInterval {
    std::size_t first = 0, last = 0;
    MillingSide side = MillingSide::neither;
};

} // namespace burin
