// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/boundary.h"
#include "tests/core/volume/volumes.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_boundary {

using namespace burin::test;

namespace {

/// Voxels of the object with an empty one among their 26 neighbours, by 27 look-ups each.
std::vector<VoxelIndex> denseBoundary(const RunVolume& volume) {
    const Grid& grid = volume.grid();
    std::vector<VoxelIndex> found;
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            for (std::int32_t along = 0; along < grid.voxelsPerLine(); ++along) {
                const VoxelIndex voxel = grid.voxel(line, along);
                if (!volume.belongs(voxel)) continue;
                bool boundary = false;
                for (int i = -1; i <= 1; ++i)
                    for (int j = -1; j <= 1; ++j)
                        for (int k = -1; k <= 1; ++k)
                            boundary |= !volume.belongs({voxel.i + i, voxel.j + j, voxel.k + k});
                if (boundary) found.push_back(voxel);
            }
    return found;
}

/// Gives one property to a block of lines over an interval along them.
void fillSomewhere(RunVolume& volume, std::int32_t largest, PropertyIndex property) {
    const Grid& grid = volume.grid();
    const LineIndex low{*rc::gen::inRange(0, grid.lineCountU()), *rc::gen::inRange(0, grid.lineCountV())};
    const LineIndex high{low.u + *rc::gen::inRange(1, largest), low.v + *rc::gen::inRange(1, largest)};
    const auto from = *rc::gen::inRange<RunPosition>(0, grid.lineEnd());
    const auto to = from + *rc::gen::inRange<RunPosition>(0, grid.lineEnd() / 2); // sub-voxel ends
    RC_ASSERT(volume.fillBlock(low, high, from, to, property));
}

/// Bricks complete and cut off at the grid's end, mostly full, so that there are inner voxels.
RunVolume someVolume() {
    const glm::ivec3 count(*rc::gen::inRange(1, 28), *rc::gen::inRange(1, 28), *rc::gen::inRange(1, 28));
    const auto axis = static_cast<RunAxis>(*rc::gen::inRange(0, 3));
    RunVolume volume = emptyVolume(cubeGrid(count, axis), std::size_t{4} << 20);
    const Grid& grid = volume.grid();
    RC_ASSERT(volume.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()}, *rc::gen::inRange<RunPosition>(0, 600),
                               grid.lineEnd(), wax));
    const int changes = *rc::gen::inRange(0, 12);
    for (int i = 0; i < changes; ++i)
        fillSomewhere(volume, 12, *rc::gen::element(airProperty, airProperty, aluminium, part));
    return volume;
}

} // namespace

class TestBoundary : public QObject {
    Q_OBJECT

private slots:
    void wholeBoundaryIsThatOfTheVoxels() {
        QVERIFY(rc::check("boundary of several bricks against 27 look-ups a voxel", [] {
            RunVolume volume = someVolume();
            const std::vector<VoxelIndex> expected = denseBoundary(volume);
            const BoundaryList list(volume.snapshot());
            RC_ASSERT(list.voxels() == expected);
            RC_ASSERT(list.voxelCount() == expected.size());
        }));
    }

    void followsChanges() {
        QVERIFY(rc::check("boundary kept up to date against 27 look-ups a voxel", [] {
            RunVolume volume = someVolume();
            BoundaryList list(volume.snapshot());
            const VolumeSnapshot first = volume.snapshot();
            const std::vector<VoxelIndex> expectedFirst = denseBoundary(volume);
            const int steps = *rc::gen::inRange(1, 4);
            for (int step = 0; step < steps; ++step) {
                fillSomewhere(volume, 5, *rc::gen::element(airProperty, airProperty, wax));
                list.update(volume.snapshot());
                RC_ASSERT(list.voxels() == denseBoundary(volume));
            }
            list.update(first); // undone
            RC_ASSERT(list.voxels() == expectedFirst);
        }));
    }

    void looksOnlyWhereSomethingChanged() {
        RunVolume volume = emptyVolume(cubeGrid({80, 80, 20}));
        QVERIFY(volume.fillBlock({0, 0}, {80, 80}, 0, 15 * 256, wax));
        BoundaryList list(volume.snapshot());
        QCOMPARE(list.update(volume.snapshot()), std::size_t{0});
        RunAmounts removed;
        QCOMPARE(volume.removeSpan({42, 43}, 10 * 256, 15 * 256, removed), Removal::removed);
        QCOMPARE(list.update(volume.snapshot()), std::size_t{9});
        QVERIFY(list.voxels() == denseBoundary(volume));
        QVERIFY(list.line({42, 43}).size() == 2); // floor and bottom
        QVERIFY((list.line({42, 43})[1] == VoxelInterval{9, 9}));
        QVERIFY((list.line({41, 43})[1] == VoxelInterval{9, 14})); // the pocket's wall
    }

    void anotherVolumeIsTakenUpWhole() {
        RunVolume one = emptyVolume(cubeGrid({20, 20, 20})), other = emptyVolume(cubeGrid({9, 30, 10}, RunAxis::x));
        QVERIFY(other.fillBlock({2, 3}, {9, 9}, 300, 2000, wax));
        BoundaryList list(one.snapshot());
        QCOMPARE(list.voxelCount(), std::uint64_t{0});
        list.update(other.snapshot());
        QVERIFY(list.voxels() == denseBoundary(other));
    }
};

BURIN_TEST(TestBoundary, NoApplication)

} // namespace burin::tst_boundary

#include "tst_boundary.moc"
