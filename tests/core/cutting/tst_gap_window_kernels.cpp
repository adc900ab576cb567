// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/gap_window_kernels.h"

#include <QtTest>
#include <rapidcheck.h>

#include <cstring>
#include <vector>

using namespace burin;

namespace {

constexpr std::int32_t side = 8; // bricks, of the window

/// Rows of gaps with spans to be taken, as random as they come: known and unknown gaps, neighbours of three materials
/// or none, bricks that are ready and some that are not.
struct Scene {
    std::vector<GapWindow::Gap> gaps = std::vector<GapWindow::Gap>((side + 1) * 9); // one to be fetched ahead
    std::vector<GapWindow::Brick> bricks = std::vector<GapWindow::Brick>(side);
    std::vector<EightIntegers> low, high;
    std::vector<RowSpans> spans;
    GapWindow::Sums sums;
    std::vector<GapWindow::Open> open = std::vector<GapWindow::Open>(side * 8);

    GapWindow::Rows rows() { return {gaps.data(), side + 1, bricks.data(), side - 1, spans}; }
};

int drawn(int low, int high) {
    return *rc::gen::inRange(low, high);
}

void drawLane(GapWindow::Gap& gap, int lane) {
    const bool known = drawn(0, 10) != 0;
    const int low = drawn(1000, 2000), high = low + drawn(0, 800);
    gap.low[lane] = known ? low : 1 << 29;
    gap.high[lane] = known ? high : -(1 << 29);
    gap.left[lane] =
        known && drawn(0, 6) != 0 ? std::uint32_t(low - drawn(1, 900)) << 8 | std::uint32_t(drawn(1, 4)) : 0;
    gap.right[lane] =
        known && drawn(0, 6) != 0 ? std::uint32_t(high + drawn(1, 900)) << 8 | std::uint32_t(drawn(1, 4)) : 0;
}

Scene drawScene() {
    Scene scene;
    for (GapWindow::Gap& gap : scene.gaps)
        for (int lane = 0; lane < 8; ++lane) drawLane(gap, lane);
    for (GapWindow::Brick& brick : scene.bricks) brick.ready = drawn(0, 12) != 0;
    const int rows = drawn(1, 9);
    scene.low.resize(std::size_t(rows) * side);
    scene.high.resize(scene.low.size());
    const int v = 8 * drawn(0, 100);
    for (int row = 0; row < rows; ++row) {
        const std::size_t at = std::size_t(row) * side;
        scene.spans.push_back({v + row, drawn(0, 100), drawn(1, side + 1), &scene.low[at], &scene.high[at]});
        for (std::size_t i = at; i < at + side; ++i)
            for (int lane = 0; lane < 8; ++lane) {
                scene.low[i][lane] = drawn(700, 2100);
                scene.high[i][lane] = scene.low[i][lane] + drawn(-100, 1500);
            }
    }
    scene.sums.originU = 40;
    scene.sums.originV = v;
    scene.sums.alongOrigin = 3000;
    return scene;
}

template <class Value>
bool sameBytes(const std::vector<Value>& a, const std::vector<Value>& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

bool sameSums(const GapWindow::Sums& a, const GapWindow::Sums& b) {
    const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
    return same(a.byProperty, b.byProperty) && a.used == b.used && same(a.units, b.units) &&
           same(a.momentU, b.momentU) && same(a.momentV, b.momentV) && same(a.momentAlong, b.momentAlong);
}

} // namespace

class GapWindowKernelsTest : public QObject {
    Q_OBJECT

private slots:
    /// What a cut takes, and what it is counted as, does not depend on the machine, to the last bit.
    void cutsTheSameOnEveryProcessor() {
        const bool held = rc::check("rows", [] {
            Scene here = drawScene(), elsewhere = here; // of the same spans
            kernels::Growth growthHere{here.open.data()}, growthElsewhere{elsewhere.open.data()};
            bool done = false;
            while (!done) {
                done = kernels::growGaps(here.rows(), here.sums, growthHere);
                RC_ASSERT(done == kernels::any_processor::grow(elsewhere.rows(), elsewhere.sums, growthElsewhere));
                RC_ASSERT(growthHere.row == growthElsewhere.row && growthHere.group == growthElsewhere.group);
                if (!done) {
                    const std::size_t brick =
                        std::size_t(here.spans[growthHere.row].firstGroup + growthHere.group) % side;
                    here.bricks[brick].ready = elsewhere.bricks[brick].ready = true;
                }
            }
            RC_ASSERT(sameBytes(here.gaps, elsewhere.gaps));
            RC_ASSERT(sameSums(here.sums, elsewhere.sums));
            RC_ASSERT(growthHere.openCount == growthElsewhere.openCount);
            for (std::size_t i = 0; i < growthHere.openCount; ++i)
                RC_ASSERT(here.open[i].row == elsewhere.open[i].row && here.open[i].group == elsewhere.open[i].group &&
                          here.open[i].lanesOf == elsewhere.open[i].lanesOf);
            for (std::size_t i = 0; i < here.bricks.size(); ++i)
                RC_ASSERT(here.bricks[i].owing == elsewhere.bricks[i].owing);
        });
        QVERIFY(held);
    }

    /// Sums are those of the lines one by one.
    void countsWhatEachLineLoses() {
        const bool held = rc::check("rows", [] {
            Scene scene = drawScene();
            for (GapWindow::Brick& brick : scene.bricks) brick.ready = true;
            const std::vector<GapWindow::Gap> before = scene.gaps;
            kernels::Growth growth{scene.open.data()};
            RC_ASSERT(kernels::growGaps(scene.rows(), scene.sums, growth));
            std::array<std::int64_t, 256> lost{}, counted{};
            for (std::size_t i = 0; i < before.size(); ++i)
                for (int lane = 0; lane < 8; ++lane) {
                    const std::int64_t below = before[i].low[lane] - scene.gaps[i].low[lane];
                    const std::int64_t above = scene.gaps[i].high[lane] - before[i].high[lane];
                    RC_ASSERT(below >= 0 && above >= 0);
                    lost[before[i].left[lane] & 255U] += below;
                    lost[before[i].right[lane] & 255U] += above;
                }
            for (std::size_t property = 0; property < counted.size(); ++property)
                for (int lane = 0; lane < 8; ++lane) counted[property] += scene.sums.byProperty[property][lane];
            RC_ASSERT(counted == lost);
        });
        QVERIFY(held);
    }
};

QTEST_APPLESS_MAIN(GapWindowKernelsTest)
#include "tst_gap_window_kernels.moc"
