// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"
#include "tests/core/cutting/scalar_cutter.h"
#include "tests/oracles/allocation_count.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_deferred_limits {

using namespace burin::tests;

namespace {

constexpr std::array stocks{softStock, hardStock};

/// Sum of the amounts that cuts report as removed.
struct Taken {
    RunAmounts amounts;
    void add(const CutResult& cut) {
        for (const PropertyIndex stock : stocks) amounts.units[stock] += unitsOf(cut, stock);
    }
    void add(const RunAmounts& more) {
        for (const PropertyIndex stock : stocks) amounts.units[stock] += more.units[stock];
    }
};

/// A hand that keeps moving in roughly one direction.
struct Walk {
    glm::dvec3 low, size, tip, way;
    double step;
    Walk(const Grid& grid, double voxels)
        : low(grid.box().low)
        , size(grid.box().high - low)
        , tip(low + size * glm::dvec3(real(0.0, 1.0), real(0.0, 1.0), real(0.0, 1.0)))
        , way(real(-1, 1), real(-1, 1), real(-1, 1))
        , step(voxels * grid.edge()) {}
    glm::dvec3 next() {
        way = 0.8 * way + 0.4 * glm::dvec3(real(-1, 1), real(-1, 1), real(-1, 0.8));
        return glm::clamp(tip + way * (step / std::max(glm::length(way), 0.1)), low, low + size);
    }
};

/// Allocates all the memory that a volume has left, until it is released.
class Ballast {
public:
    explicit Ballast(RunVolume& volume) : volume_(&volume) { rooms_.reserve(100000); }
    /// Allocates all but the memory of `left` bricks.
    void take(std::size_t left) {
        const Grid& grid = volume_->grid();
        for (LineIndex line; rooms_.size() < rooms_.capacity();
             line.u = (line.u + 8) % grid.lineCountU(), line.v = (line.v + 8) % grid.lineCountV()) {
            BrickRoom room;
            if (!volume_->setAside(line, room)) break;
            rooms_.push_back(room);
        }
        giveBack(left);
    }
    bool empty() const { return rooms_.empty(); }
    void giveBack(std::size_t count) {
        for (; count > 0 && !rooms_.empty(); --count) {
            volume_->giveBack(rooms_.back());
            rooms_.pop_back();
        }
    }

private:
    RunVolume* volume_;
    std::vector<BrickRoom> rooms_;
};

/// Two stocks on top of each other and a protected block: bricks that need very little memory.
bool fillLayers(RunVolume& volume) {
    const Grid& grid = volume.grid();
    const LineIndex low{0, 0}, high{grid.lineCountU(), grid.lineCountV()};
    const RunPosition end = grid.lineEnd();
    return volume.fillBlock(low, high, 0, end / 2, softStock) && volume.fillBlock(low, high, end / 2, end, hardStock) &&
           volume.fillBlock({8, 8}, {16, 12}, end / 4, end / 3, part);
}

/// Snapshots, and the contents of each when it was taken.
struct Kept {
    std::vector<std::pair<VolumeSnapshot, RunAmounts>> snapshots;
    void take(RunVolume& volume) {
        snapshots.emplace_back(volume.snapshot(), RunAmounts{});
        snapshots.back().second = snapshots.back().first.amounts();
    }
    bool stand() const {
        return std::ranges::all_of(snapshots, [](const auto& kept) { return kept.first.amounts() == kept.second; });
    }
};

/// As CutResult promises: entries with a loss come first, by property.
bool holdsNoEmptyEntryBeforeAnother(const CutResult& cut) {
    PropertyIndex last = airProperty;
    for (const MaterialVolume& material : cut.removed) {
        if (material.property != airProperty && (material.units == 0 || material.property <= last)) return false;
        if (material.property != airProperty && last == 0xff) return false;
        last = material.property == airProperty ? PropertyIndex{0xff} : material.property;
    }
    return true;
}

bool accounts(const RunAmounts& before, const RunVolume& now, const Taken& taken) {
    return std::ranges::all_of(stocks, [&](PropertyIndex stock) {
        return before.units[stock] - now.amounts().units[stock] == taken.amounts.units[stock];
    });
}

} // namespace

class DeferredLimitsTest : public QObject {
    Q_OBJECT

private slots:
    /// Whenever memory runs out, the counted removal equals the actual one; once there is room the same moves complete
    /// the work.
    void goesOnWhenThereIsRoomAgain() {
        int ranOut = 0, finished = 0;
        const bool held = rc::check("walks without room", [&] {
            const int side = *rc::gen::inRange(40, 150);
            const Grid fine = grid({-1.0, 2.0, -3.0}, 0.5, {side, side - 7, 40});
            const Cutter cutter = cutterOf(*rc::gen::inRange(0, 3), 0.5 * real(2.0, 15.0));
            RunVolume workpiece = RunVolume::make(fine, materials(), 8'000'000).value();
            RC_ASSERT(fillMotley(workpiece));
            RunVolume expected = motleyWorkpiece(fine);
            const RunAmounts before = workpiece.amounts();
            MaterialRemoval removal(cutter, fine, Writing::deferred);
            ScalarCutter scalar(cutter, fine);
            Walk walk(fine, *rc::gen::element(0.3, 2.0, 10.0));
            Ballast ballast(workpiece);
            Kept kept;
            Taken taken, expectedTaken;
            if (*rc::gen::inRange(0, 2) == 0) kept.take(workpiece);
            ballast.take(*rc::gen::inRange<std::size_t>(0, 60));
            for (int tick = 0; tick < 30; ++tick) {
                const glm::dvec3 next = walk.next();
                for (;;) {
                    const CutResult cut = removal.cut(workpiece, walk.tip, next);
                    taken.add(cut);
                    RC_ASSERT(!cut.putOff);
                    if (!cut.outOfMemory) break;
                    ++ranOut;
                    if (*rc::gen::inRange(0, 2) == 0) {
                        const CutResult rest = removal.settle(workpiece);
                        taken.add(rest);
                        // The memory for counted removal was reserved beforehand.
                        RC_ASSERT(!rest.outOfMemory);
                        RC_ASSERT(removal.settled());
                        RC_ASSERT(accounts(before, workpiece, taken));
                        RC_ASSERT(isValid(workpiece));
                    }
                    RC_ASSERT(kept.stand());
                    // All memory is released, but in pieces that are too small: this walk cannot be completed.
                    if (kept.snapshots.empty() && ballast.empty()) {
                        taken.add(removal.settle(workpiece));
                        RC_ASSERT(removal.settled() && accounts(before, workpiece, taken) && isValid(workpiece));
                        return;
                    }
                    if (kept.snapshots.empty())
                        ballast.giveBack(*rc::gen::inRange<std::size_t>(1, 40));
                    else
                        kept.snapshots.clear();
                }
                expectedTaken.add(scalar.cut(expected, walk.tip, next));
                RC_ASSERT(taken.amounts == expectedTaken.amounts);
                walk.tip = next;
                if (*rc::gen::inRange(0, 6) == 0) kept.take(workpiece);
            }
            const CutResult rest = removal.settle(workpiece);
            RC_ASSERT(!rest.outOfMemory && rest.volume == 0.0);
            RC_ASSERT(sameLines(workpiece, expected));
            RC_ASSERT(accounts(before, workpiece, taken));
            RC_ASSERT(isValid(workpiece));
            RC_ASSERT(kept.stand());
            finished += 1;
        });
        QVERIFY(held);
        QVERIFY(ranOut > 100); // otherwise nothing was tested
        QVERIFY(finished > 50);
    }

    /// The same with almost no reserve from the beginning, where even the tables of a snapshot are expensive.
    void losesNothingWithATinyReserve() {
        int ranOut = 0, wentOn = 0;
        const bool held = holds("tiny reserves", 900, [&] {
            const int side = *rc::gen::inRange(20, 140);
            const Grid fine = grid({-1.0, 2.0, -3.0}, 0.5, {side, side - 7, 20});
            RunVolume workpiece =
                RunVolume::make(fine, materials(), *rc::gen::inRange<std::size_t>(8000, 150000)).value();
            RC_PRE(fillLayers(workpiece));
            const RunAmounts before = workpiece.amounts();
            MaterialRemoval removal(cutterOf(*rc::gen::inRange(0, 3), 0.5 * real(2.0, 12.0)), fine, Writing::deferred);
            Walk walk(fine, *rc::gen::element(0.3, 2.0, 10.0));
            Kept kept;
            Taken taken;
            bool full = false;
            for (int tick = 0; tick < 30; ++tick) {
                const glm::dvec3 next = walk.next();
                const CutResult cut = removal.cut(workpiece, walk.tip, next);
                taken.add(cut);
                walk.tip = next;
                ranOut += cut.outOfMemory ? 1 : 0;
                wentOn += full && !cut.outOfMemory && cut.volume > 0.0 ? 1 : 0;
                full = cut.outOfMemory;
                if (*rc::gen::inRange(0, 4) == 0) kept.take(workpiece);
                if (*rc::gen::inRange(0, 4) == 0) {
                    const CutResult rest = removal.settle(workpiece);
                    taken.add(rest);
                    RC_ASSERT(!rest.outOfMemory && removal.settled());
                    RC_ASSERT(accounts(before, workpiece, taken));
                    RC_ASSERT(isValid(workpiece));
                }
                if (full || *rc::gen::inRange(0, 8) == 0) {
                    RC_ASSERT(kept.stand());
                    kept.snapshots.clear();
                }
            }
            taken.add(removal.settle(workpiece));
            RC_ASSERT(removal.settled());
            RC_ASSERT(accounts(before, workpiece, taken));
            RC_ASSERT(isValid(workpiece));
            RC_ASSERT(kept.stand());
        });
        QVERIFY(held);
        QVERIFY(ranOut > 100);
        QVERIFY(wentOn > 10);
    }

    /// Memory that a cut reserves is returned, whether there was material to cut or not: after hours of work and undo,
    /// with one tool after another, as much is free as after a minute.
    void settlingGivesBackAllThatWasSetAside() {
        const Grid fine = grid({0.0, 0.0, 0.0}, 0.5, {96, 96, 40});
        RunVolume workpiece = block(fine);
        QVERIFY(workpiece.fillBlock({0, 0}, {48, 96}, 0, fine.lineEnd(), airProperty));
        std::size_t used = 0;
        for (int round = 0; round < 20; ++round) {
            const VolumeSnapshot before = workpiece.snapshot();
            MaterialRemoval removal(cutterOf(round % 3, 5.0), fine, Writing::deferred);
            for (int tick = 0; tick < 5; ++tick)
                QVERIFY(!removal.cut(workpiece, {8.0 + tick, 24.0, 10.0}, {9.0 + tick, 24.0, 10.0}).outOfMemory);
            if (round % 2 == 0) QVERIFY(removal.cut(workpiece, {13.0, 24.0, 10.0}, {26.0, 24.0, 10.0}).volume > 0.0);
            removal.settle(workpiece);
            QVERIFY(removal.settled());
            workpiece.restore(before);
            removal.reset();
            if (round < 6) used = std::max(used, workpiece.usedBytes());
            QVERIFY2(workpiece.usedBytes() <= used, qPrintable(QString::number(round)));
        }
    }

    /// Ticks do not allocate, whatever the tool and however it tilts or rotates, while snapshots are taken.
    void noTickAllocates_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("lean");
        QTest::addColumn<bool>("turns");
        const std::array names{"ball", "flat", "bull nose"};
        for (int kind = 0; kind < 3; ++kind) {
            const auto* name = names[static_cast<std::size_t>(kind)];
            QTest::addRow("%s, upright", name) << kind << 0.0 << false;
            QTest::addRow("%s, leaning", name) << kind << 0.7 << false;
            QTest::addRow("%s, turning", name) << kind << 0.3 << true;
        }
    }
    void noTickAllocates() {
        QFETCH(const int, kind);
        QFETCH(const double, lean);
        QFETCH(const bool, turns);
        const std::size_t first = allocationCount;
        const Grid fine = grid({0.0, 0.0, 0.0}, 0.5, {140, 140, 60});
        RunVolume workpiece = RunVolume::make(fine, materials()).value();
        QVERIFY(fillMotley(workpiece));
        QVERIFY(allocationCount > first); // the counter works
        MaterialRemoval removal(cutterOf(kind, 6.0), fine, Writing::deferred);
        std::vector<VolumeSnapshot> kept(8);
        const auto poseAt = [&](int tick) {
            const double angle = 0.01 * tick, leans = turns ? lean + 0.2 * std::sin(0.3 * tick) : lean;
            return ToolPose{{35.0 + 25.0 * std::cos(angle), 35.0 + 25.0 * std::sin(2.0 * angle), 20.0 - 0.02 * tick},
                            glm::normalize(glm::dvec3(std::sin(leans), 0.1 * std::sin(leans), std::cos(leans)))};
        };
        std::size_t allocations = 0;
        std::uint64_t taken = 0;
        for (int tick = 0; tick < 600; ++tick) {
            const ToolPose from = poseAt(tick), to = poseAt(tick + 1);
            const std::size_t before = allocationCount;
            if (tick % 50 > 44) {
                removal.approach(workpiece, to);
            } else {
                const CutResult cut = removal.cut(workpiece, from, to);
                for (const PropertyIndex stock : stocks) taken += unitsOf(cut, stock);
                if (cut.outOfMemory) QFAIL("out of memory");
            }
            if (tick % 97 == 96) removal.settle(workpiece);
            allocations += allocationCount - before;
            if (tick % 9 == 0) kept[static_cast<std::size_t>(tick / 9) % kept.size()] = workpiece.snapshot();
        }
        QCOMPARE(allocations, std::size_t{0});
        QVERIFY(taken > 1000000);
    }

    /// A large tool in the middle of the stock exceeds the work of one tick; the next ticks, or settling, remove the
    /// rest.
    void putsOffWhatATickCanNotTake() {
        int firsts = 0, putOffs = 0; // first contacts, and those that exceeded one tick
        const bool held = holds("first contacts", 15, [&firsts, &putOffs] {
            const Grid fine = grid({-1.0, 2.0, -3.0}, 0.5, {580, 573, 60});
            const double radius = real(60.0, 100.0);
            const Cutter cutter = cutterOf(*rc::gen::inRange(0, 3), 0.5 * radius);
            RunVolume workpiece = motleyWorkpiece(fine), expected = motleyWorkpiece(fine);
            MaterialRemoval removal(cutter, fine, Writing::deferred);
            ScalarCutter scalar(cutter, fine);
            const glm::dvec3 low = fine.box().low, size = fine.box().high - low;
            glm::dvec3 tip = low + size * glm::dvec3(real(0.4, 0.6), real(0.4, 0.6), real(0.1, 0.4));
            Taken taken, expectedTaken;
            bool putOff = false;
            const int ticks = *rc::gen::inRange(1, 8);
            for (int tick = 0; tick < ticks; ++tick) {
                const glm::dvec3 next =
                    tip + fine.edge() * glm::dvec3(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 0.5));
                const CutResult cut = removal.cut(workpiece, tip, next);
                taken.add(cut);
                expectedTaken.add(scalar.cut(expected, tip, next));
                firsts += tick == 0 ? 1 : 0;
                putOffs += tick == 0 && cut.putOff ? 1 : 0;
                putOff = putOff || cut.putOff;
                // The deferred part may contain nothing to remove, for example rows where a flat end rises.
                RC_ASSERT(cut.putOff || taken.amounts == expectedTaken.amounts);
                RC_ASSERT(!putOff || !removal.settled());
                tip = next;
                if (*rc::gen::inRange(0, 4) == 0) (void)workpiece.snapshot();
            }
            const CutResult rest = removal.settle(workpiece);
            taken.add(rest);
            RC_ASSERT(holdsNoEmptyEntryBeforeAnother(rest));
            RC_ASSERT(removal.settled());
            RC_ASSERT(taken.amounts == expectedTaken.amounts);
            RC_ASSERT(sameLines(workpiece, expected));
            RC_ASSERT(isValid(workpiece));
        });
        QVERIFY(held);
        // The smallest of these tools, high in the stock, may be completed in one tick, but rarely.
        QVERIFY2(10 * putOffs >= 8 * firsts, qPrintable(QStringLiteral("%1 of %2").arg(putOffs).arg(firsts)));
    }

    /// Approaching cuts nothing, and prepares the first cut: in stock of one material nothing is deferred any more.
    void approachingSparesTheFirstCut_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("radius");
        for (int kind = 0; kind < 3; ++kind)
            for (const double radius : {200.0, 240.0, 280.0}) QTest::addRow("%d, %g", kind, radius) << kind << radius;
    }
    void approachingSparesTheFirstCut() {
        QFETCH(const int, kind);
        QFETCH(const double, radius);
        const Grid fine = grid({-1.0, 2.0, -3.0}, 0.5, {580, 573, 60});
        const Cutter cutter = cutterOf(kind, 0.5 * radius);
        const glm::dvec3 tip(144.0, 145.0, 1.0), next = tip + glm::dvec3(0.3, 0.1, -0.1);
        RunVolume workpiece = block(fine), unready = block(fine), expected = block(fine);
        const RunAmounts before = workpiece.amounts();

        MaterialRemoval unprepared(cutter, fine, Writing::deferred);
        QVERIFY(unprepared.cut(unready, tip, next).putOff);

        MaterialRemoval removal(cutter, fine, Writing::deferred);
        const int ticks = static_cast<int>(std::ceil(3.2 * radius * radius / 40000.0)) + 2;
        for (int tick = 0; tick < ticks; ++tick) removal.approach(workpiece, {tip, {0.0, 0.0, 1.0}});
        QVERIFY(removal.settled());
        QVERIFY(workpiece.amounts() == before);
        const CutResult cut = removal.cut(workpiece, tip, next);
        QVERIFY(!cut.putOff);
        Taken taken, expectedTaken;
        taken.add(cut);
        ScalarCutter scalar(cutter, fine);
        expectedTaken.add(scalar.cut(expected, tip, next));
        QVERIFY(taken.amounts == expectedTaken.amounts);
        QCOMPARE(removal.settle(workpiece).volume, 0.0);
        QVERIFY(sameLines(workpiece, expected));
    }
};

BURIN_TEST(DeferredLimitsTest, NoApplication)

} // namespace burin::tst_deferred_limits

#include "tst_deferred_limits.moc"
