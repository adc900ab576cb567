// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/run_volume.h"
#include "tests/core/volume/volumes.h"
#include "tests/oracles/dense_grid.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_brick_clearing {

using namespace burin::test;
using burin::oracles::DenseGrid;

namespace {

/// Positions are multiples of this, so that ends often coincide.
constexpr RunPosition step = 64;

RunPosition placeUpTo(RunPosition end) {
    return step * *rc::gen::inRange<RunPosition>(0, end / step + 1);
}

/// A brick typical of a cut workpiece: lines similar to their neighbours, with an interval of air, and some different
/// ones.
void fillBrick(RunVolume& volume, DenseGrid& dense) {
    const RunPosition end = volume.grid().lineEnd();
    const int layers = *rc::gen::element(0, 1, 3, 6, 14);
    const auto put = [&](LineIndex line, RunPosition from, RunPosition to, PropertyIndex property) {
        RC_ASSERT(volume.fillSpan(line, from, to, property));
        dense.fillSpan(line, from, to, property);
    };
    for (LineIndex line; line.v < volume.grid().lineCountV(); ++line.v)
        for (line.u = 0; line.u < volume.grid().lineCountU(); ++line.u) {
            const bool own = *rc::gen::inRange(0, 5) == 0;
            for (int i = 0; i < layers; ++i) {
                const RunPosition from = own ? placeUpTo(end) : end * static_cast<RunPosition>(i) / 15;
                put(line, from, std::min(end, from + placeUpTo(end) / 2),
                    static_cast<PropertyIndex>(own ? *rc::gen::inRange(0, 4) : 1 + i % 3));
            }
            if (*rc::gen::inRange(0, 2) == 0) put(line, end / 4, end / 2, airProperty);
        }
}

struct Spans {
    std::uint64_t lines = 0;
    std::array<RunPosition, 64> from{}, to{};
};

Spans anySpans(RunPosition end) {
    Spans spans;
    for (std::size_t line = 0; line < spans.from.size(); ++line) {
        if (*rc::gen::inRange(0, 5) == 0) continue;
        const RunPosition one = placeUpTo(end), other = placeUpTo(end);
        const bool widens = *rc::gen::inRange(0, 2) == 0; // the air left by fillBrick
        spans.from[line] = widens ? end / 4 - std::min(one / 8, end / 4) : std::min(one, other);
        spans.to[line] = widens ? end / 2 + other / 8 : std::max(one, other);
        if (spans.from[line] < spans.to[line]) spans.lines |= std::uint64_t{1} << line;
    }
    return spans;
}

} // namespace

class BrickClearingTest : public QObject {
    Q_OBJECT

private slots:
    /// Lines with any number of runs, including protected ones, cleared once and again, held by a snapshot or not.
    void clearedBricksEqualADenseGrid() {
        const Grid grid = cubeGrid({8, 8, 4});
        const bool held = rc::check("clearing", [&] {
            RunVolume volume = emptyVolume(grid, std::size_t{1} << 20);
            DenseGrid dense(grid);
            fillBrick(volume, dense);
            const VolumeSnapshot shown = *rc::gen::arbitrary<bool>() ? volume.snapshot() : VolumeSnapshot();
            const DenseGrid then = dense;
            for (int time = 0; time < 2; ++time) {
                const Spans spans = anySpans(grid.lineEnd());
                BrickRoom room;
                if (*rc::gen::arbitrary<bool>()) RC_ASSERT(volume.setAside({3, 5}, room));
                RC_ASSERT(volume.clear({3, 5}, {spans.lines, spans.from, spans.to}, room));
                RC_ASSERT(room.empty());
                RunAmounts removed;
                for (int line = 0; line < 64; ++line)
                    if ((spans.lines >> line & 1) != 0)
                        dense.removeSpan(
                            {line % 8, line / 8}, spans.from[std::size_t(line)], spans.to[std::size_t(line)],
                            [](PropertyIndex property) { return property == part; }, removed);
                RC_ASSERT(dense.equals(volume));
                RC_ASSERT(volume.amounts() == dense.amounts());
            }
            if (!shown.empty()) RC_ASSERT(then.equals(shown));
        });
        QVERIFY(held);
    }
};

BURIN_TEST(BrickClearingTest, NoApplication)

} // namespace burin::tst_brick_clearing

#include "tst_brick_clearing.moc"
