// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/sample_grid.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// One axis of a grid: runs of `run` floats that follow each other `count` times, `repeats` times over.
struct Layout {
    std::size_t run, count, repeats;
};

/// Doubles the samples along one axis.
void refineAxis(const std::array<const float*, 4>& from, const std::array<float*, 4>& to, const Layout& layout,
                std::size_t axis, float spacing, LineCheck& check) noexcept {
    const std::size_t along = axis + 1, across = 1 + (axis + 1) % 3, other = 1 + (axis + 2) % 3;
    const auto [run, count, repeats] = layout;
    const float floor = check.floor;
    float bendSquared = 0.0F, residualSquared = 0.0F;
    for (std::size_t repeat = 0; repeat < repeats; ++repeat)
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t a = (repeat * count + i) * run, out = (repeat * (2 * count - 1) + 2 * i) * run;
            for (std::size_t c = 0; c < 4; ++c) std::copy_n(from[c] + a, run, to[c] + out);
            if (i + 1 == count) break;
            const std::size_t b = a + run, middle = out + run;
            for (std::size_t k = 0; k < run; ++k) {
                const float low = from[0][a + k], high = from[0][b + k];
                const float fromSlope = from[along][a + k], toSlope = from[along][b + k];
                const float bend = (fromSlope - toSlope) * (spacing * 0.125F);
                const float mean = 0.5F * (fromSlope + toSlope), rise = high - low;
                const float residual = rise - mean * spacing;
                const float counts = std::max(low, high) >= floor ? 1.0F : 0.0F;
                bendSquared = std::max(bendSquared, counts * bend * bend);
                residualSquared = std::max(residualSquared, counts * residual * residual);
                to[0][middle + k] = 0.5F * (low + high) + bend;
                to[along][middle + k] = 1.5F * rise / spacing - 0.5F * mean;
                to[across][middle + k] = 0.5F * (from[across][a + k] + from[across][b + k]);
                to[other][middle + k] = 0.5F * (from[other][a + k] + from[other][b + k]);
            }
        }
    const float bend = std::sqrt(bendSquared);
    check.bend = std::max(check.bend, bend);
    check.bends += bend;
    check.residual = std::max(check.residual, std::sqrt(residualSquared));
}

} // namespace

void refine(const SampleGrid& coarse, SampleGrid& fine, float spacing, LineCheck& check) {
    const auto n = static_cast<std::size_t>(coarse.side), m = 2 * n - 1;
    constexpr std::size_t most = 9;
    std::array<std::array<float, most * most * most>, 4> first, second;
    std::array<const float*, 4> from;
    std::array<float*, 4> to, between, out;
    for (std::size_t c = 0; c < 4; ++c) {
        from[c] = coarse.values[c].data();
        to[c] = first[c].data();
        between[c] = second[c].data();
        out[c] = fine.values[c].data();
    }
    const auto constant = [](const std::array<float*, 4>& p) {
        return std::array<const float*, 4>{p[0], p[1], p[2], p[3]};
    };
    refineAxis(from, to, {n * n, n, 1}, 2, spacing, check);
    refineAxis(constant(to), between, {n, n, m}, 1, spacing, check);
    refineAxis(constant(between), out, {1, n, m * m}, 0, spacing, check);
}

} // namespace burin
