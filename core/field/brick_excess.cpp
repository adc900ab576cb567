// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/brick_excess.h"

#include "core/field/brick_field.h"
#include "core/field/cube.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

constexpr std::size_t along = BrickField::samplesAlong, count = along * along * along;
using Numbers = std::array<std::int32_t, count>; // one for each sample of a brick

/// Mask with all bits set for samples whose index along an axis satisfies `holds`; step: between samples along the
/// axis.
template <class Holds>
constexpr Numbers maskOf(std::size_t step, const Holds& holds) noexcept {
    Numbers mask{};
    for (std::size_t i = 0; i < count; ++i) mask[i] = holds(i / step % along) ? -1 : 0;
    return mask;
}
template <std::size_t step>
constexpr Numbers inside = maskOf(step, [](std::size_t i) { return i > 0 && i + 1 < along; });
template <std::size_t step>
constexpr Numbers outermost = maskOf(step, [](std::size_t i) { return i == 1 || i + 2 == along; });

/// The largest excess of all lines along an axis. A kink by `turn` at a share u of its cell lifts the chord by u (1 -
/// u) turn, and shows in the second differences at the cell's ends: (1 - u) turn in one, u turn in the other. In the
/// outermost cells only one of these is known; there the turn is limited to that between the two steepest possible
/// slopes.
template <std::size_t step>
float excessAlong(const Numbers& samples, float cell, std::int32_t floor) noexcept {
    Numbers turns{}; // only towards greater slopes: others make the chord too low
    std::int32_t outer = 0, inner = 0;
    for (std::size_t i = step; i < count - step; ++i) {
        const std::int32_t before = samples[i - step], after = samples[i + step];
        const std::int32_t counts = std::max(before, after) >= floor ? inside<step>[i] : 0;
        turns[i] = std::max(before - 2 * samples[i] + after, 0) & counts;
        outer = std::max(outer, turns[i] & outermost<step>[i]);
    }
    for (std::size_t i = step; i < count - step; ++i) inner = std::max(inner, turns[i] + turns[i + step]);
    const float known = std::min(static_cast<float>(outer), cell);
    return std::min(0.5F * cell, std::max(0.25F * static_cast<float>(inner), known - known * known / (2.0F * cell)));
}

} // namespace

float kinkExcess(const std::int16_t* samples, float cell, float floor) noexcept {
    Numbers numbers;
    std::copy_n(samples, count, numbers.begin());
    const auto least = static_cast<std::int32_t>(floor);
    const float sum = excessAlong<1>(numbers, cell, least) + excessAlong<along>(numbers, cell, least) +
                      excessAlong<along * along>(numbers, cell, least);
    return std::min(sum, halfDiagonalAbove * cell); // no position is farther from a sample
}

} // namespace burin
