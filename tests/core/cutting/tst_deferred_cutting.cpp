// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"
#include "core/tool/span_rows.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/oracles/allocation_count.h"

#include <QtTest>
#include <rapidcheck.h>

using namespace burin;
using namespace burin::tests;

namespace {

double real(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

/// Oblique layers of both stocks, a protected block with stock behind it, and caves.
RunVolume motleyWorkpiece(const Grid& grid) {
    RunVolume volume = block(grid, softStock);
    const RunPosition end = grid.lineEnd();
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            const auto at = static_cast<RunPosition>(line.u * 37 + line.v * 23);
            (void)volume.fillSpan(line, end / 3 + at % (end / 4), end / 2 + at % (end / 4), hardStock);
            if (line.u % 17 < 5 && line.v % 13 < 9)
                (void)volume.fillSpan(line, end / 4 + 17, end / 2 - 100 - at % 50, part);
            if ((line.u / 3 + line.v / 5) % 4 == 0) (void)volume.fillSpan(line, 2 * end / 3, 2 * end / 3 + 333, 0);
            if (line.u % 29 == 3) (void)volume.fillSpan(line, 0, end, 0);
        }
    return volume;
}

/// The scalar cutter: the same spans line by line, each taken from the volume at once.
class ScalarCutter {
public:
    ScalarCutter(const Cutter& cutter, const Grid& grid)
        : grid_(grid), spans_(inVoxels(flutes(cutter)), static_cast<std::int32_t>(grid.lineEnd())) {}
    RunAmounts cut(RunVolume& volume, const glm::dvec3& from, const glm::dvec3& to) {
        RunAmounts removed;
        const glm::dvec3 start = inLines(from), end = inLines(to);
        const int parts = std::max(1, int(std::ceil(glm::length(end - start) / spans_.longestWay({0, 0, 1}))));
        glm::dvec3 tip = start;
        for (int i = 1; i <= parts; ++i) {
            const glm::dvec3 next = i == parts ? end : glm::mix(start, end, double(i) / parts);
            spans_.begin({tip, {0, 0, 1}}, next, true);
            tip = next;
            for (LineIndex line; line.v < grid_.lineCountV(); ++line.v)
                for (line.u = 0; line.u < grid_.lineCountU(); line.u += 8) {
                    EightIntegers low, high;
                    spans_.spans(line.v, line.u / 8, 1, &low, &high);
                    for (int lane = 0; lane < 8 && line.u + lane < grid_.lineCountU(); ++lane)
                        if (low[lane] < high[lane])
                            volume.removeSpan({line.u + lane, line.v}, RunPosition(low[lane]), RunPosition(high[lane]),
                                              removed);
                }
        }
        return removed;
    }

private:
    RevolvedPiece inVoxels(const RevolvedPiece& piece) const {
        const double edge = grid_.edge();
        return piece.cornerRadius == 0.0
                   ? RevolvedPiece{piece.bottom / edge, piece.top / edge, piece.bottomRadius / edge,
                                   piece.topRadius / edge}
                   : RevolvedPiece{piece.bottom / edge, piece.top / edge, piece.bottomRadius / edge,
                                   piece.topRadius / edge, piece.cornerRadius / edge};
    }
    glm::dvec3 inLines(const glm::dvec3& tip) const {
        const glm::dvec3 place = (tip - grid_.low()) / grid_.edge();
        return {place.x - 0.5, place.y - 0.5, place.z};
    }
    Grid grid_;
    SpanRows spans_;
};

bool sameLines(const RunVolume& a, const RunVolume& b) {
    const Grid& grid = a.grid();
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            if (!std::ranges::equal(a.line(line), b.line(line))) return false;
    return true;
}

Cutter cutterOf(int kind, double radius) {
    if (kind == 0) return ball(2.0 * radius, 3.0 * radius);
    if (kind == 1) return flat(2.0 * radius, 2.0 * radius);
    return bullNose(2.0 * radius, 0.3 * radius, 2.0 * radius);
}

} // namespace

class DeferredCuttingTest : public QObject {
    Q_OBJECT

private slots:
    /// Every line and every sum, as a cutter gives them that takes each span from the volume at once; whatever the tool,
    /// the moves, the materials; with snapshots, restarts and jumps in between.
    void equalsTheScalarCutter() {
        const bool held = rc::check("random walks", [] {
            const int side = *rc::gen::inRange(40, 130);
            const Grid fine = grid({-1.0, 2.0, -3.0}, 0.5, {side, side - 7, 60});
            const double radius = real(1.0, 0.2 * side) + 0.3, step = *rc::gen::element(0.05, 0.3, 1.0, 5.0, 40.0);
            const Cutter cutter = cutterOf(*rc::gen::inRange(0, 3), 0.5 * radius);
            RunVolume workpiece = motleyWorkpiece(fine), expected = motleyWorkpiece(fine);
            MaterialRemoval removal(cutter, fine, Writing::deferred);
            ScalarCutter scalar(cutter, fine);
            const glm::dvec3 low = fine.box().low, size = fine.box().high - low;
            const auto somewhere = [&] {
                return low + size * glm::dvec3(real(-0.1, 1.1), real(-0.1, 1.1), real(-0.1, 1.0));
            };
            glm::dvec3 tip = somewhere(), way(real(-1, 1), real(-1, 1), real(-1, 1));
            std::vector<VolumeSnapshot> kept;
            for (int tick = 0; tick < 40; ++tick) {
                way = 0.8 * way + 0.4 * glm::dvec3(real(-1, 1), real(-1, 1), real(-1, 0.8));
                if (tick % 7 == 6) way.z = 0.0;
                glm::dvec3 next = tip + way * (step * fine.edge() / std::max(glm::length(way), 0.1));
                if (*rc::gen::inRange(0, 60) == 0) tip = somewhere(), next = tip; // taken elsewhere
                const CutResult cut = removal.cut(workpiece, tip, next);
                const RunAmounts taken = scalar.cut(expected, tip, next);
                RC_ASSERT(!cut.putOff && !cut.outOfMemory);
                for (const PropertyIndex stock : {softStock, hardStock})
                    RC_ASSERT(unitsOf(cut, stock) == taken.units[stock]);
                tip = next;
                if (tick % 11 == 3) kept.push_back(workpiece.snapshot());
                if (tick % 17 == 5) {
                    RC_ASSERT(removal.settle(workpiece).volume == 0.0);
                    RC_ASSERT(removal.settled());
                    RC_ASSERT(sameLines(workpiece, expected));
                }
            }
            RC_ASSERT(removal.settle(workpiece).volume == 0.0);
            RC_ASSERT(sameLines(workpiece, expected));
            RC_ASSERT(workpiece.amounts() == expected.amounts());
            RC_ASSERT(workpiece.snapshot().amounts() == workpiece.amounts());
        });
        QVERIFY(held);
    }
};

QTEST_APPLESS_MAIN(DeferredCuttingTest)
#include "tst_deferred_cutting.moc"
