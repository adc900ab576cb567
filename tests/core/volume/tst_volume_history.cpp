// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/volume_history.h"
#include "core/volume/runs/volume_memory.h"
#include "tests/core/volume/random_volumes.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_volume_history {

using namespace burin::test;

namespace {

/// Cuts a groove: an interval of each line in a rectangle.
void cutSomewhere(RunVolume& volume, std::mt19937& random) {
    const Grid& grid = volume.grid();
    const auto any = [&](std::int32_t end) { return std::uniform_int_distribution<std::int32_t>(0, end - 1)(random); };
    const LineIndex low{any(grid.lineCountU()), any(grid.lineCountV())};
    const LineIndex high{std::min(grid.lineCountU(), low.u + 1 + any(24)), std::min(grid.lineCountV(), low.v + 9)};
    const auto from = static_cast<RunPosition>(any(static_cast<std::int32_t>(grid.lineEnd())));
    RunAmounts removed;
    for (LineIndex line = low; line.v < high.v; ++line.v)
        for (line.u = low.u; line.u < high.u; ++line.u)
            (void)volume.removeSpan(line, from + static_cast<RunPosition>(7 * line.u), from + 900, removed);
}

/// A volume with a history, and a copy of every state that it went through.
struct Milled {
    explicit Milled(std::uint32_t seed, Content content, const VolumeHistory::Budget& budget = {},
                    std::size_t reserve = std::size_t{16} << 20)
        : random(seed), volume(emptyVolume(cubeGrid({70, 40, 32}), reserve)), history(budget) {
        RandomContent(seed, content).fill(volume);
        states.emplace_back(volume);
    }
    /// One step; `cuts` grooves.
    void mill(int cuts) {
        VolumeSnapshot before = volume.snapshot();
        for (int i = 0; i < cuts; ++i) cutSomewhere(volume, random);
        history.add(std::move(before));
        states.resize(present + 1);
        states.emplace_back(volume);
        ++present;
    }
    bool isAtPresent() const { return states[present].equals(volume) && volume.amounts() == states[present].amounts(); }

    std::mt19937 random;
    RunVolume volume;
    VolumeHistory history;
    std::vector<LineCopies> states;
    std::size_t present = 0;
};

/// Steps held by snapshots, including those that can be redone.
std::size_t heldSteps(const VolumeHistory& history) {
    std::size_t held = 0;
    for (std::size_t step = 0; step < history.undoSteps() + history.redoSteps(); ++step)
        held += history.cost(step).packedBytes == 0 ? 1U : 0U;
    return held;
}

void packEverything(VolumeHistory& history) {
    while (!history.tidy(1000)) {
    }
}

} // namespace

class TestVolumeHistory : public QObject {
    Q_OBJECT

private slots:
    void aDeltaTakesAVolumeBothWays() {
        QVERIFY(rc::check("between any two moments", [] {
            const auto seed = *rc::gen::arbitrary<std::uint32_t>();
            Milled milled(seed, static_cast<Content>(*rc::gen::inRange(1, contentCount)));
            const VolumeSnapshot before = milled.volume.snapshot();
            for (int i = *rc::gen::inRange(0, 6); i > 0; --i) cutSomewhere(milled.volume, milled.random);
            const LineCopies after(milled.volume);
            const VolumeDelta delta = deltaBetween(before, milled.volume.snapshot());
            RC_ASSERT(delta.applyBackward(milled.volume).hasValue());
            RC_ASSERT(milled.states[0].equals(milled.volume));
            RC_ASSERT(milled.volume.amounts() == milled.states[0].amounts());
            RC_ASSERT(delta.applyForward(milled.volume).hasValue());
            RC_ASSERT(after.equals(milled.volume));
            RC_ASSERT(milled.volume.amounts() == after.amounts());
        }));
    }

    /// Steps, undo, redo, packing and forgetting in any order: the volume is always restored exactly.
    void anyWalkThroughTheHistoryIsExact() {
        QVERIFY(rc::check("walks", [] {
            VolumeHistory::Budget budget;
            budget.heldSteps = *rc::gen::inRange<std::size_t>(0, 4);
            Milled milled(*rc::gen::arbitrary<std::uint32_t>(), Content::creases, budget);
            std::size_t forgotten = 0;
            for (int move = *rc::gen::inRange(5, 60); move > 0; --move) {
                switch (*rc::gen::inRange(0, 9)) {
                case 0:
                case 1:
                case 2:
                    milled.mill(*rc::gen::inRange(0, 4));
                    break;
                case 3:
                case 4:
                    RC_ASSERT(milled.history.canUndo() == (milled.present > forgotten));
                    if (milled.history.undo(milled.volume)) --milled.present;
                    break;
                case 5:
                case 6:
                    RC_ASSERT(milled.history.canRedo() == (milled.present + 1 < milled.states.size()));
                    if (milled.history.redo(milled.volume)) ++milled.present;
                    break;
                case 7:
                    (void)milled.history.tidy(*rc::gen::inRange<std::size_t>(1, 40));
                    break;
                default:
                    if (*rc::gen::inRange(0, 4) == 0) {
                        forgotten += std::min<std::size_t>(1, milled.history.undoSteps());
                        milled.history.forgetOldest(1);
                    } else {
                        (void)milled.history.packAll();
                    }
                }
                RC_ASSERT(milled.isAtPresent());
                RC_ASSERT(milled.history.undoSteps() == milled.present - forgotten);
                RC_ASSERT(milled.history.redoSteps() == milled.states.size() - 1 - milled.present);
            }
        }));
    }

    void packedStepsHoldNothingOfTheReserve() {
        Milled milled(3, Content::sheets);
        for (int i = 0; i < 12; ++i) milled.mill(3);
        const std::size_t used = milled.volume.usedBytes();
        QVERIFY(milled.history.cost(0).heldBytes > 0 && milled.history.cost(0).packedBytes == 0);
        QVERIFY(milled.history.packAll());
        QVERIFY(milled.history.cost(0).heldBytes == 0 && milled.history.cost(0).packedBytes > 0);
        for (int i = 0; i < 2; ++i) (void)milled.volume.snapshot(); // frees memory kept for the next snapshot
        QVERIFY(milled.volume.usedBytes() < used);
        // 11 packed steps take less memory than their snapshots held back.
        QVERIFY(milled.history.totalCost().packedBytes < used - milled.volume.usedBytes());
        while (milled.history.undo(milled.volume)) {
            --milled.present;
            QVERIFY(milled.isAtPresent());
        }
        QCOMPARE(milled.present, std::size_t{0});
        while (milled.history.redo(milled.volume)) {
            ++milled.present;
            QVERIFY(milled.isAtPresent());
        }
        QCOMPARE(milled.present, std::size_t{12});
    }

    void memoryStaysInTheBudget() {
        VolumeHistory::Budget budget;
        budget.packedBytes = 40'000;
        budget.heldSteps = 2;
        Milled milled(5, Content::sheets, budget);
        std::size_t most = 0, mostUsed = 0, usedEarly = 0;
        for (int i = 0; i < 200; ++i) {
            milled.mill(2);
            packEverything(milled.history);
            most = std::max(most, milled.history.totalCost().packedBytes);
            (i < 40 ? usedEarly : mostUsed) = std::max(i < 40 ? usedEarly : mostUsed, milled.volume.usedBytes());
        }
        QVERIFY(most <= budget.packedBytes);
        QVERIFY2(mostUsed < 2 * usedEarly, qPrintable(QString("%1, %2").arg(usedEarly).arg(mostUsed)));
        const std::size_t steps = milled.history.undoSteps();
        QVERIFY(steps > 10 && steps < 200); // the oldest were removed, the newest are exact
        while (milled.history.undo(milled.volume)) {
            --milled.present;
            QVERIFY(milled.isAtPresent());
        }
        QCOMPARE(milled.present, 200 - steps);
    }

    /// The memory that snapshots hold back from the reserve stays below its limit, and no more is packed than
    /// necessary. Also measured at the reserve itself: the memory used in addition to the current state.
    void heldMemoryStaysInTheBudget_data() {
        QTest::addColumn<qulonglong>("limit");
        QTest::newRow("as it is given") << qulonglong{100'000};
        QTest::newRow("an eighth of the reserve, when it is not") << qulonglong{0};
    }
    void heldMemoryStaysInTheBudget() {
        QFETCH(qulonglong, limit);
        VolumeHistory::Budget budget;
        budget.heldBytes = limit;
        budget.heldSteps = budget.mostHeldSteps = 1000; // only memory decides
        constexpr std::size_t reserve = 1'000'000;
        Milled milled(8, Content::sheets, budget, reserve);
        const std::size_t most = limit != 0 ? limit : milled.volume.reservedBytes() / 8;
        std::size_t mostHeld = 0, mostHeldSteps = 0;
        for (int i = 0; i < 60; ++i) {
            VolumeSnapshot before = milled.volume.snapshot();
            milled.mill(2);
            // The memory replaced by the newest step is not known to the history yet and is added.
            const std::size_t newest = bytesHeldBack(before, milled.volume.snapshot());
            before = {};
            packEverything(milled.history);
            const std::size_t held = milled.history.totalCost().heldBytes;
            QVERIFY2(held <= most, qPrintable(QString("%1 of %2").arg(held).arg(most)));
            mostHeld = std::max(mostHeld, held);
            mostHeldSteps = std::max(mostHeldSteps, heldSteps(milled.history));
            for (int k = 0; k < 2; ++k) (void)milled.volume.snapshot(); // frees memory kept for the next snapshot
            const std::size_t used = milled.volume.usedBytes(), present = memoryOf(milled.volume.snapshot()).bytes();
            QVERIFY2(used <= present + most + newest, qPrintable(QString("%1 beyond %2").arg(used).arg(present)));
        }
        QVERIFY(mostHeldSteps > 2 && mostHeld > most / 2); // as many as fit are held
        while (milled.history.undo(milled.volume)) {
            --milled.present;
            QVERIFY(milled.isAtPresent());
        }
    }

    /// Without any call of the tidying function: adding packs the excess.
    void heldStepsAreBoundedWithoutTidying() {
        VolumeHistory::Budget budget;
        budget.mostHeldSteps = 5;
        Milled milled(10, Content::sheets, budget);
        std::size_t most = 0;
        for (std::size_t i = 1; i <= 40; ++i) {
            milled.mill(1);
            QCOMPARE(milled.history.undoSteps(), i);
            most = std::max(most, heldSteps(milled.history));
            QVERIFY(heldSteps(milled.history) <= 5);
        }
        QCOMPARE(most, std::size_t{5});
        packEverything(milled.history);
        QCOMPARE(heldSteps(milled.history), VolumeHistory::Budget{}.heldSteps);
        while (milled.history.undo(milled.volume)) {
            --milled.present;
            QVERIFY(milled.isAtPresent());
        }
        QCOMPARE(milled.present, std::size_t{0});
    }

    /// Steps that were all undone count, too: those that would be redone last are removed.
    void stepsTakenBackStayInTheBudget() {
        VolumeHistory::Budget budget;
        budget.packedBytes = 8'000;
        budget.heldSteps = 30;
        Milled milled(6, Content::sheets, budget);
        for (int i = 0; i < 30; ++i) milled.mill(2);
        for (int i = 0; i < 30; ++i) {
            QVERIFY(milled.history.undo(milled.volume));
            --milled.present;
        }
        milled.history.packAll();
        QVERIFY(milled.history.totalCost().packedBytes <= budget.packedBytes);
        const std::size_t steps = milled.history.redoSteps();
        QVERIFY(steps > 0 && steps < 30);
        while (milled.history.redo(milled.volume)) {
            ++milled.present;
            QVERIFY(milled.isAtPresent());
        }
        QCOMPARE(milled.present, steps);
    }

    /// With a reserve that others hold: unpacking the step is refused, nothing is changed; once the memory is free the
    /// step can be undone.
    void withoutMemoryTheVolumeStaysAsItIs() {
        const Grid grid = cubeGrid({64, 64, 64});
        RunVolume volume = emptyVolume(grid, 400'000);
        RandomContent(9, Content::sheets).fill(volume);
        const LineCopies before(volume);
        VolumeHistory history;
        VolumeSnapshot first = volume.snapshot();
        QVERIFY(volume.fillBlock({0, 0}, {64, 64}, 0, grid.lineEnd(), airProperty));
        history.add(std::move(first));
        first = volume.snapshot();
        history.add(first);
        QVERIFY(history.packAll());
        // Something else fills the volume, and a reader holds it.
        QVERIFY(history.undo(volume)); // the empty step
        const LineCopies empty(volume);
        std::vector<VolumeSnapshot> readers;
        RandomContent other(4, Content::creases);
        for (std::int32_t i = 0; i < 64 * 64; ++i) {
            readers.push_back(volume.snapshot());
            const LineIndex line{i % 64, i / 64};
            if (!volume.setLine(line, other.segments(line, grid.lineEnd()))) break;
        }
        volume.restore(readers.front());
        const Result<void> refused = history.undo(volume);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::volumeOutOfMemory);
        QVERIFY(empty.equals(volume));
        QVERIFY(volume.amounts() == empty.amounts());
        readers.clear();
        first = {};
        for (int i = 0; i < 2; ++i) (void)volume.snapshot();
        QVERIFY(history.undo(volume));
        QVERIFY(before.equals(volume));
    }

    void anotherVolumeStartsANewHistory() {
        Milled one(1, Content::sheets), other(2, Content::sheets);
        one.mill(1);
        one.mill(1);
        QVERIFY(one.history.packAll());
        QCOMPARE(one.history.undo(other.volume).error().code, ErrorCode::argumentInvalid);
        QVERIFY(other.isAtPresent());
        one.history.add(other.volume.snapshot());
        QCOMPARE(one.history.undoSteps(), std::size_t{1});
        QCOMPARE(one.history.undo(one.volume).error().code, ErrorCode::argumentInvalid);
        QVERIFY(one.isAtPresent());
        QVERIFY(one.history.undo(other.volume));
    }
};

BURIN_TEST(TestVolumeHistory, NoApplication)

} // namespace burin::tst_volume_history

#include "tst_volume_history.moc"
