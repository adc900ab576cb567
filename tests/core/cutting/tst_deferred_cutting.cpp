// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"
#include "tests/core/cutting/scalar_cutter.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_deferred_cutting {

using namespace burin::tests;

class DeferredCuttingTest : public QObject {
    Q_OBJECT

private slots:
    /// Every line and every sum equals that of a cutter which removes each span directly from the volume; for any tool,
    /// moves and materials; with snapshots, restarts and jumps in between.
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
                if (*rc::gen::inRange(0, 60) == 0) tip = somewhere(), next = tip; // a jump to another position
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

    /// The same for large tools, whose first contact may exceed the work of one tick.
    void equalsTheScalarCutterForLargeTools() {
        const bool held = holds("short walks", 25, [] {
            const Grid fine = grid({-1.0, 2.0, -3.0}, 0.5, {150, 137, 90});
            const double radius = real(26.0, 60.0), step = *rc::gen::element(0.05, 0.3, 1.0, 5.0, 40.0);
            const Cutter cutter = cutterOf(*rc::gen::inRange(0, 3), 0.5 * radius);
            RunVolume workpiece = motleyWorkpiece(fine), expected = motleyWorkpiece(fine);
            MaterialRemoval removal(cutter, fine, Writing::deferred);
            ScalarCutter scalar(cutter, fine);
            const glm::dvec3 low = fine.box().low, size = fine.box().high - low;
            glm::dvec3 tip = low + size * glm::dvec3(real(-0.2, 1.2), real(-0.2, 1.2), real(0.2, 1.0));
            glm::dvec3 way(real(-1, 1), real(-1, 1), real(-1, 1));
            RunAmounts taken, expectedTaken;
            const auto count = [&](const CutResult& cut) {
                RC_ASSERT(!cut.outOfMemory);
                for (const PropertyIndex stock : {softStock, hardStock}) taken.units[stock] += unitsOf(cut, stock);
            };
            for (int tick = 0; tick < 8; ++tick) {
                way = 0.8 * way + 0.4 * glm::dvec3(real(-1, 1), real(-1, 1), real(-1, 0.8));
                const glm::dvec3 next = tip + way * (step * fine.edge() / std::max(glm::length(way), 0.1));
                const CutResult cut = removal.cut(workpiece, tip, next);
                count(cut);
                const RunAmounts expectedNow = scalar.cut(expected, tip, next);
                for (const PropertyIndex stock : {softStock, hardStock})
                    expectedTaken.units[stock] += expectedNow.units[stock];
                if (!cut.putOff) RC_ASSERT(taken == expectedTaken);
                tip = next;
            }
            count(removal.settle(workpiece));
            RC_ASSERT(removal.settled());
            RC_ASSERT(taken == expectedTaken);
            RC_ASSERT(sameLines(workpiece, expected));
            RC_ASSERT(workpiece.amounts() == expected.amounts());
        });
        QVERIFY(held);
    }
};

BURIN_TEST(DeferredCuttingTest, NoApplication)

} // namespace burin::tst_deferred_cutting

#include "tst_deferred_cutting.moc"
