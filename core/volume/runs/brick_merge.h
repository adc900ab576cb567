// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/tile.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace burin {

/// Joins the segments of two bricks, line by line. Segments are processed in their packed form, the end above eight
/// bits of property, and no branch depends on their values, because the order of runs can't be predicted. Each step
/// depends on the one before; therefore two halves of the brick are processed at the same time.
///
/// @tparam Operation  `std::uint32_t pick(std::uint32_t a, std::uint32_t b)`: returns the resulting property in the
///        lower eight bits, from the segments of both operands at one position; the other bits are ignored.
template <class Operation>
class BrickMerge {
public:
    /// @param a, b  segments of the two bricks; linesOfA, linesOfB: where each line begins
    /// @param segments  has room for the segments of a and b together
    /// @param offsets   receives where each of the 64 lines begins, and the end
    static void run(const Segment* a, const Segment* b, const Tile& linesOfA, const Tile& linesOfB, RunPosition lineEnd,
                    Segment* segments, std::uint32_t* offsets) noexcept {
        const std::uint32_t middleA = linesOfA.offset(half), middleB = linesOfB.offset(half);
        const std::uint32_t endPacked = (lineEnd << propertyBits) | properties;
        Walk first(a, b, segments), second(a + middleA, b + middleB, segments + middleA + middleB);
        do {
            first.step(endPacked);
            second.step(endPacked);
        } while ((first.line != half) & (second.line != half));
        while (first.line != half) first.step(endPacked);
        while (second.line != half) second.step(endPacked);

        const std::uint32_t count = first.ends[half - 1] + 1, countSecond = second.ends[half - 1] + 1;
        std::memmove(segments + count, segments + middleA + middleB, countSecond * sizeof(Segment));
        offsets[0] = 0;
        for (std::size_t line = 0; line < half; ++line) {
            offsets[line + 1] = first.ends[line] + 1;
            offsets[half + line + 1] = count + second.ends[line] + 1;
        }
    }

private:
    static constexpr std::size_t half = linesPerTile / 2;
    static constexpr std::uint32_t propertyBits = 8, properties = 0xff;

    struct Walk {
        Walk(const Segment* itsA, const Segment* itsB, Segment* itsResult) noexcept
            : a(itsA), b(itsB), result(itsResult) {}

        void step(std::uint32_t lineEnd) noexcept {
            const auto inA = std::bit_cast<std::uint32_t>(a[placeA]), inB = std::bit_cast<std::uint32_t>(b[placeB]);
            const std::uint32_t endA = inA | properties, endB = inB | properties;
            const std::uint32_t end = std::min(endA, endB), property = Operation::pick(inA, inB) | ~properties;
            last += property != before ? 1 : 0; // otherwise the segment is continued
            result[last] = std::bit_cast<Segment>(end & property);
            ends[line] = static_cast<std::uint32_t>(last);
            const bool lineEnds = end >= lineEnd;
            before = property & (lineEnds ? 0U : ~0U);
            line += lineEnds ? 1 : 0;
            placeA += inA <= endB ? 1 : 0;
            placeB += inB <= endA ? 1 : 0;
        }

        const Segment *a, *b;
        Segment* result;
        std::size_t placeA = 0, placeB = 0, line = 0;
        std::size_t last = ~std::size_t{0};   ///< index of the last segment of the result so far
        std::uint32_t before = 0;             ///< its property; 0 at the start of a line
        std::array<std::uint32_t, half> ends; ///< last segment of each line
    };
};

} // namespace burin
