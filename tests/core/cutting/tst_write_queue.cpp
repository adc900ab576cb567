// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"
#include "core/cutting/write_queue.h"
#include "tests/core/cutting/scalar_cutter.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <deque>
#include <map>

namespace burin::tst_write_queue {

using namespace burin::tests;

namespace {

std::uint64_t solidUnits(const RunAmounts& amounts) {
    std::uint64_t units = 0;
    for (std::size_t i = 1; i < amounts.units.size(); ++i) units += amounts.units[i];
    return units;
}

std::uint64_t takenBy(const CutResult& cut) {
    return unitsOf(cut, softStock) + unitsOf(cut, hardStock);
}

} // namespace

/// The removal of a cut appears in the workpiece within 16 ticks: for the queue alone, and with cuts as in the haptic
/// loop.
class WriteQueueTest : public QObject {
    Q_OBJECT

private slots:
    /// Bricks arrive, leave out of order and are written: none waits for more than 16 ticks, and the oldest is written
    /// first.
    void noneWaitsLonger() {
        const bool held = rc::check("none waits longer", [] {
            constexpr std::uint32_t bricks = 40;
            WriteQueue queue(bricks);
            std::deque<std::uint32_t> order;      // first in, first out
            std::map<std::uint32_t, int> arrived; // tick
            const auto leave = [&](std::uint32_t brick) {
                queue.remove(brick);
                arrived.erase(brick);
                std::erase(order, brick);
            };
            for (int tick = 0; tick < 120; ++tick) {
                for (int i = *rc::gen::inRange(0, tick < 90 ? 12 : 1); i > 0; --i) {
                    const std::uint32_t brick = *rc::gen::inRange(0U, bricks);
                    if (arrived.contains(brick)) {
                        if (*rc::gen::inRange(0, 3) == 0) leave(brick);
                        continue;
                    }
                    queue.add(brick);
                    order.push_back(brick);
                    arrived.emplace(brick, tick);
                }
                for (std::uint32_t pace = queue.pace(); pace > 0 && !queue.empty(); --pace) {
                    RC_ASSERT(queue.first() == order.front());
                    leave(order.front());
                }
                queue.nextTick();
                for (const auto& [brick, since] : arrived) RC_ASSERT(tick - since < 15);
                RC_ASSERT(queue.empty() == arrived.empty());
                for (std::uint32_t brick = 0; brick < bricks; ++brick)
                    RC_ASSERT(queue.holds(brick) == arrived.contains(brick));
            }
            RC_ASSERT(queue.empty());
        });
        QVERIFY(held);
    }

    /// A first contact's bricks are written evenly: no tick writes more than a 16th of them, rounded up.
    void aBurstIsSpreadEvenly() {
        for (const std::uint32_t bricks : {1U, 15U, 16U, 17U, 1000U}) {
            WriteQueue queue(bricks);
            for (std::uint32_t brick = 0; brick < bricks; ++brick) queue.add(brick);
            for (int tick = 0; tick < 16; ++tick) {
                const std::uint32_t pace = queue.pace();
                QVERIFY2(pace <= (bricks + 15) / 16, qPrintable(QString("%1 of %2").arg(pace).arg(bricks)));
                for (std::uint32_t i = 0; i < pace && !queue.empty(); ++i) queue.remove(*queue.first());
                queue.nextTick();
            }
            QVERIFY(queue.empty());
        }
    }

    /// A hand that jumps about, so that bricks leave the cache before they are written, and then rests: in material (it
    /// continues to cut) or with the spindle off (it only approaches).
    void whatWasCutShowsWithinSixteenTicks() {
        const bool held = holds("shows within sixteen ticks", 20, [] {
            const Grid fine = grid({0.0, 0.0, 0.0}, 0.5, {200, 90, 40});
            RunVolume workpiece = motleyWorkpiece(fine);
            const std::uint64_t before = solidUnits(workpiece.amounts());
            MaterialRemoval removal(cutterOf(*rc::gen::inRange(0, 3), real(3.0, 8.0)), fine, Writing::deferred);
            glm::dvec3 tip(real(0.0, 100.0), real(0.0, 45.0), 8.0);
            std::deque<std::uint64_t> counted{0}; // after each tick
            for (int burst = 0; burst < 4; ++burst) {
                const double voxels = real(2.0, 12.0);
                const glm::dvec3 way = glm::normalize(glm::dvec3(real(-1.0, 1.0), real(-1.0, 1.0), 0.0) + 1e-3);
                const int moving = *rc::gen::inRange(3, 40);
                const bool cutsAtRest = *rc::gen::inRange(0, 2) == 0;
                for (int tick = 0; tick < moving + 16; ++tick) {
                    const glm::dvec3 next =
                        tick < moving ? glm::clamp(tip + way * (voxels * 0.5), {0.0, 0.0, 4.0}, {100.0, 45.0, 12.0})
                                      : tip;
                    CutResult cut;
                    if (tick < moving || cutsAtRest)
                        cut = removal.cut(workpiece, tip, next);
                    else
                        removal.approach(workpiece, {next, {0.0, 0.0, 1.0}});
                    RC_ASSERT(!cut.outOfMemory && !cut.putOff);
                    counted.push_back(counted.back() + takenBy(cut));
                    tip = next;
                    const std::uint64_t shown = before - solidUnits(workpiece.amounts());
                    RC_ASSERT(shown <= counted.back());
                    if (counted.size() > 16) RC_ASSERT(shown >= counted[counted.size() - 17]);
                }
                RC_ASSERT(removal.settled());
                RC_ASSERT(before - solidUnits(workpiece.amounts()) == counted.back());
            }
        });
        QVERIFY(held);
    }

    /// A very long jump costs no more than one over the stock, and removes the same.
    void aJumpOverMilesTakesWhatOneOverTheStockDoes() {
        const Grid fine = grid({0.0, 0.0, 0.0}, 0.5, {100, 90, 40});
        for (const double lean : {0.0, 0.3}) {
            const glm::dvec3 axis(std::sin(lean), 0.0, std::cos(lean)), middle(25.0, 20.3, 8.0);
            const auto takes = [&](const glm::dvec3& way) {
                RunVolume workpiece = block(fine);
                MaterialRemoval removal(bullNose(8.0, 1.0, 8.0), fine, Writing::deferred);
                const CutResult cut = removal.cut(workpiece, {middle - way, axis}, {middle + way, axis});
                return cut.volume + removal.settle(workpiece).volume;
            };
            const double near = takes({100.0, 0.0, 0.0}), far = takes({1e13, 0.0, 0.0});
            QVERIFY2(near > 2000.0, qPrintable(QString::number(near)));
            QVERIFY2(std::abs(far - near) < 0.01 * near, qPrintable(QString("%1, %2").arg(near).arg(far)));
            QCOMPARE(takes({0.0, 0.0, 1e300}), takes({0.0, 0.0, 1e200}));
            RunVolume workpiece = block(fine);
            MaterialRemoval removal(ball(8.0, 8.0), fine, Writing::deferred);
            QCOMPARE(removal.cut(workpiece, glm::dvec3(-1e9, 1e9, 0.0), glm::dvec3(1e9, 1e9 + 5.0, 0.0)).volume, 0.0);
        }
    }
};

BURIN_TEST(WriteQueueTest, NoApplication)

} // namespace burin::tst_write_queue

#include "tst_write_queue.moc"
