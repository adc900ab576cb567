// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/run_volume.h"
#include "tests/core/volume/volumes.h"
#include "tests/oracles/allocation_count.h"
#include "tests/oracles/dense_grid.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <new>
#include <thread>

namespace burin::tst_run_volume {

using namespace burin::test;
using burin::oracles::DenseGrid;

namespace {

struct Edit {
    int kind =
        0; // 0–3 remove, 4–6 fill, 7 set a line, 8 fill a block, 9 take a snapshot, 10–11 drop one, 12 restore one
    LineIndex line, high;
    RunPosition from = 0, to = 0;
    PropertyIndex property = 0;
    std::size_t which = 0;
};

rc::Gen<Edit> anyEdit(glm::ivec3 count) {
    const auto end = static_cast<RunPosition>(count.z) * unitsPerVoxel;
    return rc::gen::exec([=] {
        Edit edit;
        edit.kind = *rc::gen::inRange(0, 13);
        edit.line = {*rc::gen::inRange(0, count.x), *rc::gen::inRange(0, count.y)};
        edit.high = {*rc::gen::inRange(0, count.x + 1), *rc::gen::inRange(0, count.y + 1)};
        const auto a = *rc::gen::inRange<RunPosition>(0, end + 1), b = *rc::gen::inRange<RunPosition>(0, end + 1);
        edit.from = std::min(a, b);
        edit.to = std::max(a, b);
        edit.property = *rc::gen::inRange<PropertyIndex>(0, 4);
        edit.which = *rc::gen::inRange<std::size_t>(0, 8);
        return edit;
    });
}

bool isPart(PropertyIndex property) {
    return property == part;
}

std::vector<Segment> pattern(RunPosition end, RunPosition step) {
    std::vector<Segment> segments;
    PropertyIndex property = 0;
    for (RunPosition at = step; at < end; at += step)
        segments.emplace_back(at, property = static_cast<PropertyIndex>((property + 1) % 4));
    segments.emplace_back(end, PropertyIndex((property + 1) % 4));
    return segments;
}

void setLine(DenseGrid& dense, LineIndex line, const std::vector<Segment>& segments) {
    RunPosition start = 0;
    for (const Segment segment : segments) {
        dense.fillSpan(line, start, segment.end(), segment.property());
        start = segment.end();
    }
}

/// The contents of a snapshot, counted line by line on the caller's thread.
RunAmounts recount(const VolumeSnapshot& snapshot) {
    RunAmounts sum;
    for (LineIndex line; line.v < snapshot.grid().lineCountV(); ++line.v)
        for (line.u = 0; line.u < snapshot.grid().lineCountU(); ++line.u) {
            RunPosition start = 0;
            for (const Segment segment : snapshot.line(line)) {
                sum.units[segment.property()] += segment.end() - start;
                start = segment.end();
            }
        }
    return sum;
}

} // namespace

class TestRunVolume : public QObject {
    Q_OBJECT

private slots:
    void randomEditsEqualADenseGrid() {
        const glm::ivec3 count(11, 9, 2);
        const Grid grid = cubeGrid(count);
        const bool held = rc::check("edits, snapshots and their return", [&] {
            const auto edits =
                *rc::gen::scale(6.0, rc::gen::container<std::vector<Edit>>(rc::gen::scale(1.0 / 6.0, anyEdit(count))));
            RunVolume volume = emptyVolume(grid, std::size_t{2} << 20); // many snapshots
            DenseGrid dense(grid);
            std::vector<std::pair<VolumeSnapshot, DenseGrid>> snapshots;
            for (const Edit& edit : edits) {
                if (edit.kind < 4) {
                    RunAmounts removed, expected;
                    const Removal result = volume.removeSpan(edit.line, edit.from, edit.to, removed);
                    dense.removeSpan(edit.line, edit.from, edit.to, isPart, expected);
                    RC_ASSERT(removed == expected);
                    RC_ASSERT((result == Removal::removed) == (expected != RunAmounts{}));
                } else if (edit.kind < 7) {
                    RC_ASSERT(volume.fillSpan(edit.line, edit.from, edit.to, edit.property));
                    dense.fillSpan(edit.line, edit.from, edit.to, edit.property);
                } else if (edit.kind == 7) {
                    const auto segments = pattern(grid.lineEnd(), 7 + edit.from);
                    RC_ASSERT(volume.setLine(edit.line, segments));
                    setLine(dense, edit.line, segments);
                } else if (edit.kind == 8) {
                    RC_ASSERT(volume.fillBlock(edit.line, edit.high, edit.from, edit.to, edit.property));
                    for (LineIndex l = edit.line; l.v < edit.high.v; ++l.v)
                        for (l.u = edit.line.u; l.u < edit.high.u; ++l.u)
                            dense.fillSpan(l, edit.from, edit.to, edit.property);
                } else if (edit.kind == 9) {
                    snapshots.emplace_back(volume.snapshot(), dense);
                } else if (!snapshots.empty()) {
                    const std::size_t which = edit.which % snapshots.size();
                    if (edit.kind == 12) {
                        volume.restore(snapshots[which].first);
                        dense = snapshots[which].second;
                    } else {
                        snapshots.erase(snapshots.begin() + static_cast<std::ptrdiff_t>(which));
                    }
                }
            }
            RC_ASSERT(dense.equals(volume));
            RC_ASSERT(volume.amounts() == dense.amounts());
            RC_ASSERT(volume.snapshot().amounts() == dense.amounts());
            // They are released one after the other; memory used by the others and the volume must not be taken for new
            // blocks.
            for (;; snapshots.erase(snapshots.begin())) {
                for (const auto& [snapshot, then] : snapshots) RC_ASSERT(then.equals(snapshot));
                if (snapshots.empty()) break;
                RC_ASSERT(volume.fillSpan({10, 8}, 0, 100, wax));
                dense.fillSpan({10, 8}, 0, 100, wax);
                (void)volume.snapshot();
            }
            RC_ASSERT(dense.equals(volume));
        });
        QVERIFY(held);
    }

    void removingNeverAllocates() {
        const Grid grid = cubeGrid({64, 64, 64});
        RunVolume volume = emptyVolume(grid);
        QVERIFY(volume.fillBlock({0, 0}, {64, 64}, 0, grid.lineEnd(), wax));
        RunAmounts removed;
        std::vector<VolumeSnapshot> held;
        held.reserve(16);
        std::size_t during = 0;
        for (RunPosition pass = 0; pass < 12; ++pass) {
            held.push_back(volume.snapshot());
            const std::size_t before = allocationCount.load();
            for (LineIndex line; line.v < 64; ++line.v)
                for (line.u = 0; line.u < 64; ++line.u)
                    QVERIFY(volume.removeSpan(line, pass * 1000 + 100, pass * 1000 + 300, removed) == Removal::removed);
            during += allocationCount.load() - before;
        }
        QCOMPARE(during, std::size_t{0});
        QCOMPARE(removed.units[wax], std::uint64_t{12 * 200 * 64 * 64});
    }

    void usedUpMemoryLeavesTheLineAsItWas() {
        const Grid grid = cubeGrid({16, 16, 64});
        RunVolume volume = emptyVolume(grid, 8192);
        QVERIFY(volume.fillBlock({0, 0}, {16, 16}, 0, grid.lineEnd(), wax));
        RunAmounts removed;
        int refused = 0;
        for (RunPosition at = 256; at + 256 < grid.lineEnd(); at += 512)
            for (LineIndex line; line.v < 16; ++line.v)
                for (line.u = 0; line.u < 16; ++line.u) {
                    const auto span = volume.line(line);
                    const std::vector<Segment> before(span.begin(), span.end());
                    const RunAmounts amountsBefore = volume.amounts(), removedBefore = removed;
                    const Removal result = volume.removeSpan(line, at, at + 256, removed);
                    if (result != Removal::outOfMemory) continue;
                    ++refused;
                    QVERIFY(std::ranges::equal(before, volume.line(line)));
                    QVERIFY(volume.amounts() == amountsBefore && removed == removedBefore);
                    QVERIFY(!volume.fillSpan(line, at, at + 256, part));
                    QVERIFY(!volume.setLine(line, pattern(grid.lineEnd(), 64)));
                    QVERIFY(std::ranges::equal(before, volume.line(line)));
                }
        QVERIFY(refused > 0);
        QVERIFY(volume.usedBytes() <= volume.reservedBytes());
        QVERIFY(volume.snapshot().amounts() == volume.amounts());
    }

    void releasedSnapshotsGiveAllTheirMemoryBack() {
        const Grid grid = cubeGrid({64, 64, 16});
        RunVolume volume = emptyVolume(grid);
        QVERIFY(volume.fillBlock({0, 0}, {64, 64}, 0, grid.lineEnd(), wax));
        RunAmounts removed;
        const auto touchAll = [&](RunPosition at) {
            for (LineIndex line; line.v < 64; ++line.v)
                for (line.u = 0; line.u < 64; ++line.u) {
                    (void)volume.removeSpan(line, at, at + 16, removed);
                    (void)volume.fillSpan(line, at, at + 16, wax);
                }
        };
        touchAll(0);
        const std::size_t alone = volume.usedBytes();
        VolumeSnapshot undo = volume.snapshot();
        VolumeSnapshot scene;
        std::size_t most = 0;
        for (int i = 0; i < 50; ++i) {
            scene = volume.snapshot(); // the previous one is released
            touchAll(32);
            most = std::max(most, volume.usedBytes());
        }
        // The current state, the one held for undo, the one held by the scene, and the one waiting for the next
        // snapshot.
        QVERIFY2(most < 4 * alone, qPrintable(QString("%1 of %2 bytes").arg(most).arg(alone)));
        scene = undo = VolumeSnapshot();
        for (int i = 0; i < 2; ++i) (void)volume.snapshot(); // memory that waited for the next snapshot is free now
        QCOMPARE(volume.usedBytes(), alone);
    }

    void aReturnedStateOutlivesTheSnapshotItCameFrom() {
        const Grid grid = cubeGrid({64, 64, 16});
        RunVolume volume = emptyVolume(grid, std::size_t{1} << 20);
        const auto mark = [&](PropertyIndex property) {
            for (LineIndex line; line.v < 64; ++line.v)
                for (line.u = 0; line.u < 64; ++line.u) QVERIFY(volume.fillSpan(line, 100, 900, property));
        };
        mark(wax);
        VolumeSnapshot before = volume.snapshot();
        mark(aluminium); // the tiles of wax are released
        VolumeSnapshot after = volume.snapshot();
        volume.restore(before); // and used again
        before = after = VolumeSnapshot();
        for (int i = 0; i < 3; ++i) (void)volume.snapshot();
        for (LineIndex line; line.v < 64; line.v += 2 * 8)
            for (line.u = 0; line.u < 64; ++line.u)
                QVERIFY(volume.fillSpan(line, 2000, 3000, part)); // takes free blocks
        QCOMPARE(volume.amounts().units[wax], std::uint64_t{64 * 64 * 800});
        QVERIFY(recount(volume.snapshot()) == volume.amounts());
    }

    void aSnapshotKeepsWhatALaterOneShowedToo() {
        const Grid grid = cubeGrid({64, 64, 16});
        RunVolume volume = emptyVolume(grid, std::size_t{1} << 20);
        const auto mark = [&](PropertyIndex property) {
            for (LineIndex line; line.v < 64; ++line.v)
                for (line.u = 0; line.u < 64; ++line.u) QVERIFY(volume.fillSpan(line, 100, 900, property));
        };
        mark(wax);
        const RunAmounts then = volume.amounts();
        const VolumeSnapshot first = volume.snapshot();
        VolumeSnapshot second = volume.snapshot();
        mark(aluminium); // tiles in both are released after the second
        const VolumeSnapshot third = volume.snapshot();
        second = VolumeSnapshot();
        mark(part); // takes free blocks
        QVERIFY(recount(first) == then);
        QCOMPARE(recount(third).units[aluminium], std::uint64_t{64 * 64 * 800});
    }

    void aSnapshotOutlivesItsVolume() {
        const Grid grid = cubeGrid({8, 8, 4});
        VolumeSnapshot snapshot;
        {
            RunVolume volume = emptyVolume(grid);
            QVERIFY(volume.fillSpan({3, 5}, 100, 300, aluminium));
            snapshot = volume.snapshot();
        }
        QCOMPARE(snapshot.amounts().units[aluminium], std::uint64_t{200});
        QCOMPARE(snapshot.properties()[aluminium].id, std::string("aluminium"));
    }

    void readersOnOtherThreadsSeeOneMoment() {
        const Grid grid = cubeGrid({40, 40, 32});
        RunVolume volume = emptyVolume(grid);
        QVERIFY(volume.fillBlock({0, 0}, {40, 40}, 0, grid.lineEnd(), wax));
        struct Shown {
            VolumeSnapshot snapshot;
            RunAmounts amounts;
        };
        std::mutex mutex;
        Shown shown{volume.snapshot(), volume.amounts()};
        std::atomic<bool> stop{false};
        std::atomic<int> wrong{0}, seen{0};
        std::vector<std::jthread> readers;
        for (int i = 0; i < 2; ++i)
            readers.emplace_back([&] {
                while (!stop) {
                    Shown mine;
                    {
                        const std::lock_guard lock(mutex);
                        mine = shown;
                    }
                    if (recount(mine.snapshot) != mine.amounts) ++wrong;
                    ++seen;
                }
            });
        RunAmounts removed;
        std::uint32_t random = 12345;
        for (int tick = 0; tick < 400 || seen < 20; ++tick) {
            for (int i = 0; i < 200; ++i) {
                random = random * 1664525 + 1013904223;
                const LineIndex line{static_cast<int>(random >> 8) % 40, static_cast<int>(random >> 16) % 40};
                const RunPosition at = (random >> 4) % grid.lineEnd();
                if ((i & 1) != 0)
                    (void)volume.removeSpan(line, at, at + 400, removed);
                else
                    (void)volume.fillSpan(line, at, at + 300, aluminium);
            }
            Shown next{volume.snapshot(), volume.amounts()};
            const std::lock_guard lock(mutex);
            std::swap(shown, next);
        }
        stop = true;
        readers.clear();
        QCOMPARE(wrong.load(), 0);
    }

    void moreSegmentsThan16BitOffsetsReach() {
        const Grid grid = cubeGrid({8, 8, 1024});
        RunVolume volume = emptyVolume(grid, std::size_t{4} << 20);
        DenseGrid dense(grid);
        const auto segments = pattern(grid.lineEnd(), 200);
        for (LineIndex line; line.v < 8; ++line.v)
            for (line.u = 0; line.u < 8; ++line.u) {
                QVERIFY(volume.setLine(line, segments));
                setLine(dense, line, segments);
            }
        QVERIFY(segments.size() * 64 > 65535);
        RunAmounts removed, expected;
        QVERIFY(volume.removeSpan({4, 4}, 1000, 200000, removed) == Removal::removed);
        dense.removeSpan({4, 4}, 1000, 200000, isPart, expected);
        QVERIFY(removed == expected);
        QVERIFY(dense.equals(volume));
        QVERIFY(dense.amounts() == volume.amounts());
    }

    void untouchedStockTakesNextToNoMemory() {
        const Grid grid = cubeGrid({512, 512, 512});
        RunVolume volume = emptyVolume(grid, std::size_t{1} << 20);
        QVERIFY(volume.fillBlock({3, 3}, {509, 509}, 128, grid.lineEnd() - 77, wax));
        QCOMPARE(volume.amounts().units[wax], std::uint64_t{506} * 506 * (grid.lineEnd() - 77 - 128));
        QVERIFY(volume.snapshot().amounts() == volume.amounts());
        // Only the tiles of the rim differ from each other: 4 × 64 of 4096.
        QVERIFY2(volume.usedBytes() < 512 * 512, qPrintable(QString::number(volume.usedBytes())));
    }
};

BURIN_TEST(TestRunVolume, NoApplication)

} // namespace burin::tst_run_volume

#include "tst_run_volume.moc"
