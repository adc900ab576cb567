// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The speed of reading programs: plain G1 blocks of three axes, as for a finished surface.
#include "core/base/numbers.h"
#include "core/nc/lint.h"
#include "core/nc/parser.h"

#include <benchmark/benchmark.h>

#include <cmath>

using namespace burin;

namespace {

constexpr int blocks = 200000;

const std::string& relief() {
    static const std::string text = [] {
        std::string made = "G21 G90 G94\nG0 X0 Y0 Z5\nG1 Z0 F1200\n";
        for (int i = 0; i < blocks; ++i)
            made += "X" + formatFixed(0.3 * (i % 400), 3) + " Y" + formatFixed(0.3 * (i / 400), 3) + " Z" +
                    formatFixed(std::sin(0.01 * i), 3) + "\n";
        return made + "M2\n";
    }();
    return text;
}

void blocksPerSecond(benchmark::State& state) {
    const std::string& text = relief();
    for (auto _ : state) {
        auto program = parseProgram(text, "relief");
        benchmark::DoNotOptimize(program);
    }
    state.SetItemsProcessed(state.iterations() * blocks);
}

void lintedBlocksPerSecond(benchmark::State& state) {
    const std::string& text = relief();
    for (auto _ : state) {
        auto marks = lint(text, {});
        benchmark::DoNotOptimize(marks);
    }
    state.SetItemsProcessed(state.iterations() * blocks);
}

} // namespace

BENCHMARK(blocksPerSecond)->Name("parser.blocks_per_s")->Unit(benchmark::kMillisecond);
BENCHMARK(lintedBlocksPerSecond)->Name("lint.blocks_per_s")->Unit(benchmark::kMillisecond);
