// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/cut_cache_kernels.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <glm/glm.hpp>

#include <cmath>
#include <cstring>
#include <numeric>
#include <vector>

namespace burin::tst_cut_cache_kernels {

namespace {

constexpr std::int32_t side = 8; // bricks, of the window

/// A row of bricks with random spans to be removed: known and unknown gaps, neighbours of three materials or none,
/// bricks that are ready and some that are not, rows of lines that are requested in various places.
struct Scene {
    std::vector<CutCache::Gaps> gaps = std::vector<CutCache::Gaps>(side);
    std::vector<CutCache::Brick> bricks = std::vector<CutCache::Brick>(side);
    std::vector<BrickOfSpans> spans = std::vector<BrickOfSpans>(side);
    CutCache::BrickRow asked;
    CutCache::Sums sums;
    std::vector<CutCache::Open> open = std::vector<CutCache::Open>(side * 8);

    CutCache::BrickRow row() {
        CutCache::BrickRow row = asked;
        row.gaps = gaps.data();
        row.bricks = bricks.data();
        row.spans = spans.data();
        return row;
    }
};

int drawn(int low, int high) {
    return *rc::gen::inRange(low, high);
}

CutCache::LineGap drawGap() {
    const bool known = drawn(0, 10) != 0;
    const int low = drawn(1000, 2000), high = low + drawn(0, 800);
    if (!known) return {1 << 29, -(1 << 29), 0, 0};
    const auto neighbour = [](int end) {
        return drawn(0, 6) != 0 ? std::uint32_t(end) << 8 | std::uint32_t(drawn(1, 4)) : 0;
    };
    return {low, high, neighbour(low - drawn(1, 900)), neighbour(high + drawn(1, 900))};
}

Scene drawScene() {
    Scene scene;
    for (CutCache::Gaps& gaps : scene.gaps)
        for (std::size_t line = 0; line < 64; ++line) gaps.set(line, drawGap());
    for (CutCache::Brick& brick : scene.bricks) brick.ready = drawn(0, 12) != 0;
    for (BrickOfSpans& spans : scene.spans)
        for (std::size_t line = 0; line < 64; ++line) {
            const int low = drawn(700, 2100);
            spans.low[line / 8][int(line % 8)] = low;
            spans.high[line / 8][int(line % 8)] = low + drawn(-100, 1500);
        }
    scene.asked.mask = side - 1;
    scene.asked.firstLine = 8 * drawn(0, 100);
    scene.asked.first = drawn(0, 100);
    scene.asked.end = scene.asked.first + drawn(1, side + 1);
    for (int line = 0; line < 8; ++line) {
        scene.asked.begins[line] = drawn(scene.asked.first, scene.asked.end);
        scene.asked.ends[line] = drawn(scene.asked.begins[line], scene.asked.end + 1);
    }
    scene.sums.originU = 40;
    scene.sums.originV = scene.asked.firstLine + drawn(-20, 20);
    scene.sums.alongOrigin = 3000;
    return scene;
}

template <class Value>
bool sameBytes(const std::vector<Value>& a, const std::vector<Value>& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

bool sameSums(const CutCache::Sums& a, const CutCache::Sums& b) {
    const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
    return same(a.byProperty, b.byProperty) && a.used == b.used && same(a.units, b.units) &&
           same(a.momentU, b.momentU) && same(a.momentV, b.momentV) && same(a.momentAlong, b.momentAlong);
}

struct Moments {
    double units = 0.0, momentU = 0.0, momentV = 0.0, momentAlong = 0.0; ///< momentAlong doubled
};

/// Specification of the kernel for one line. @return whether its gap grew
bool takeSpan(CutCache::LineGap& gap, int low, int high, const glm::dvec2& uv, int alongOrigin,
              std::array<std::int64_t, 256>& lost, Moments& moments) {
    const bool below = low<gap.low, above = high> gap.high;
    if (low >= high || (!below && !above)) return false;
    // Separate from the gap, or extending beyond its neighbours.
    if (low > gap.high || high < gap.low) return false;
    if (below && low < std::min(gap.low, int(gap.left >> 8))) return false;
    if (above && high > std::max(gap.high, int(gap.right >> 8))) return false;
    const auto take = [&](int from, int to, std::uint32_t neighbour) {
        lost[neighbour & 255U] += to - from;
        moments.units += to - from;
        moments.momentU += uv.x * (to - from);
        moments.momentV += uv.y * (to - from);
        moments.momentAlong += (double(to) + from - alongOrigin) * (to - from);
    };
    if (below) take(low, gap.low, gap.left);
    if (above) take(gap.high, high, gap.right);
    gap.low = std::min(gap.low, low);
    gap.high = std::max(gap.high, high);
    return true;
}

} // namespace

class CutCacheKernelsTest : public QObject {
    Q_OBJECT

private slots:
    /// The removal of a cut and its counts are bitwise identical on every machine.
    void cutsTheSameOnEveryProcessor() {
        const bool held = rc::check("rows", [] {
            Scene here = drawScene(), elsewhere = here;
            const std::int32_t first = here.asked.first;
            kernels::Growth growthHere{here.open.data(), 0, first}, growthElsewhere{elsewhere.open.data(), 0, first};
            bool done = false;
            while (!done) {
                done = kernels::growGaps(here.row(), here.sums, growthHere);
                RC_ASSERT(done == kernels::any_processor::grow(elsewhere.row(), elsewhere.sums, growthElsewhere));
                RC_ASSERT(growthHere.brick == growthElsewhere.brick);
                if (!done) {
                    const auto brick = std::size_t(growthHere.brick % side);
                    here.bricks[brick].ready = elsewhere.bricks[brick].ready = true;
                }
            }
            RC_ASSERT(sameBytes(here.gaps, elsewhere.gaps));
            RC_ASSERT(sameSums(here.sums, elsewhere.sums));
            RC_ASSERT(growthHere.openCount == growthElsewhere.openCount);
            for (std::size_t i = 0; i < growthHere.openCount; ++i)
                RC_ASSERT(here.open[i].brick == elsewhere.open[i].brick && here.open[i].row == elsewhere.open[i].row &&
                          here.open[i].lanesOf == elsewhere.open[i].lanesOf);
            for (std::size_t i = 0; i < here.bricks.size(); ++i)
                RC_ASSERT(here.bricks[i].owing == elsewhere.bricks[i].owing);
        });
        QVERIFY(held);
    }

    /// Each line loses the part of its gap's neighbours that its span covers, or is left unchanged for the volume to
    /// cut; the sums are those of the lines one by one.
    void takesAndCountsLineByLine() {
        const bool held = rc::check("lines", [] {
            Scene scene = drawScene();
            for (CutCache::Brick& brick : scene.bricks) brick.ready = true;
            const std::vector<CutCache::Gaps> before = scene.gaps;
            const CutCache::BrickRow row = scene.row();
            kernels::Growth growth{scene.open.data(), 0, row.first};
            RC_ASSERT(kernels::growGaps(row, scene.sums, growth));
            std::array<std::int64_t, 256> lost{}, counted{};
            Moments exact;
            for (std::int32_t brick = row.first; brick < row.first + side; ++brick) {
                const auto place = std::size_t(brick % side);
                std::uint64_t owing = 0;
                for (int line = 0; line < 64; ++line) {
                    const auto at = std::size_t(line);
                    CutCache::LineGap gap = before[place].at(at);
                    if (row.begins[line / 8] <= brick && brick < row.ends[line / 8]) {
                        const BrickOfSpans& spans = scene.spans[std::size_t(brick - row.first)];
                        const glm::dvec2 uv(8 * brick + line % 8 - scene.sums.originU,
                                            row.firstLine + line / 8 - scene.sums.originV);
                        if (takeSpan(gap, spans.low[line / 8][line % 8], spans.high[line / 8][line % 8], uv,
                                     scene.sums.alongOrigin, lost, exact))
                            owing |= std::uint64_t{1} << at;
                    }
                    const CutCache::LineGap now = scene.gaps[place].at(at);
                    RC_ASSERT(now.low == gap.low && now.high == gap.high);
                }
                RC_ASSERT(scene.bricks[place].owing == owing);
            }
            for (std::size_t property = 0; property < counted.size(); ++property)
                for (const std::int32_t units : scene.sums.byProperty[property]) counted[property] += units;
            RC_ASSERT(counted == lost);
            const auto near = [](const CutCache::Sums::Lanes<float>& found, double sum, double size) {
                return std::abs(std::accumulate(found.begin(), found.end(), 0.0) - sum) <= 1e-5 * size;
            };
            RC_ASSERT(near(scene.sums.units, exact.units, exact.units));
            RC_ASSERT(near(scene.sums.momentU, exact.momentU, 1000.0 * exact.units));
            RC_ASSERT(near(scene.sums.momentV, exact.momentV, 1000.0 * exact.units));
            RC_ASSERT(near(scene.sums.momentAlong, exact.momentAlong, 10000.0 * exact.units));
        });
        QVERIFY(held);
    }
};

BURIN_TEST(CutCacheKernelsTest, NoApplication)

} // namespace burin::tst_cut_cache_kernels

#include "tst_cut_cache_kernels.moc"
