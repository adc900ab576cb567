// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/boolean.h"
#include "core/volume/operations/boundary.h"
#include "core/volume/operations/dense.h"
#include "tests/core/volume/dense_voxels.h"
#include "tests/core/volume/volumes.h"
#include "tests/oracles/dense_grid.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_paper_operations {

using namespace burin::test;
using burin::oracles::DenseGrid;

namespace {

/// Connected blobs rather than noise: each voxel copies one before it.
DenseVoxels someVoxels() {
    DenseVoxels voxels({5, 4, 6});
    for (std::size_t i = 0; i < voxels.total(); ++i)
        voxels.properties[i] =
            *rc::gen::inRange(0, 4) > 0 && i > 0 ? voxels.properties[i - 1] : *rc::gen::inRange<PropertyIndex>(0, 4);
    return voxels;
}

VoxelIndex indexOf(glm::ivec3 voxel) {
    return {voxel.x, voxel.y, voxel.z};
}

RunAxis anyAxis() {
    return *rc::gen::element(RunAxis::x, RunAxis::y, RunAxis::z);
}

} // namespace

class TestPaperOperations : public QObject {
    Q_OBJECT

private slots:
    void subVoxelRunsShowAsTheVoxelsWhoseCentresTheyHold() {
        RunVolume volume = emptyVolume(cubeGrid({1, 1, 8}));
        QVERIFY(volume.fillSpan({0, 0}, 128, 3 * 256 + 128, wax)); // from the first centre up to, excluding, the fourth
        QVERIFY((volume.runs({0, 0}) == std::vector{Run{0, 2, wax}}));
        QVERIFY(volume.fillSpan({0, 0}, 256 + 10, 256 + 100, aluminium)); // contains no centre
        QVERIFY((volume.runs({0, 0}) == std::vector{Run{0, 2, wax}}));
        QVERIFY((volume.locate({0, 0, 1}) == Run{0, 2, wax}));
    }

    /// A caller can distinguish the paper's failure flag from an exhausted reserve.
    void usedUpMemoryIsNoFailureFlag_data() {
        QTest::addColumn<bool>("removing");
        QTest::newRow("removing") << true;
        QTest::newRow("inserting") << false;
    }
    void usedUpMemoryIsNoFailureFlag() {
        QFETCH(bool, removing);
        constexpr std::int32_t bricks = 16; // in each direction; a first change gives each a block of its own
        RunVolume volume = emptyVolume(cubeGrid({16, 8 * bricks, 8 * bricks}, RunAxis::x), 4096);
        if (removing) QVERIFY(volume.fillBlock({0, 0}, {8 * bricks, 8 * bricks}, 0, 16 * 256, wax));
        const auto edit = [&](VoxelIndex at) { return removing ? volume.remove(at) : volume.insert(at, wax); };
        int done = 0;
        RunAmounts before = volume.amounts();
        VoxelIndex at{5, 3, 3};
        VoxelEdit last = VoxelEdit::done;
        for (; at.k < 8 * bricks && last == VoxelEdit::done; at.k += 8)
            for (at.j = 3; at.j < 8 * bricks && last == VoxelEdit::done; at.j += 8) {
                before = volume.amounts();
                last = edit(at);
                done += last == VoxelEdit::done ? 1 : 0;
                if (last == VoxelEdit::outOfMemory) QVERIFY(volume.belongs(at) == removing);
            }
        QVERIFY(done > 0 && last == VoxelEdit::outOfMemory);
        QVERIFY(volume.amounts() == before);
        const VoxelIndex first{5, 3, 3};
        QVERIFY(edit(first) == VoxelEdit::nothing); // no change: no memory is needed
        QVERIFY((removing ? volume.insert(first, wax) : volume.remove(first)) == VoxelEdit::done); // its block has room
        QVERIFY(volume.belongs(first) == removing);
    }

    void aDenseArrayComesBackAsItWas() {
        const bool held = rc::check("dense, runs, dense", [] {
            const DenseVoxels voxels = someVoxels();
            const Grid grid = cubeGrid(voxels.count, anyAxis());
            RunVolume volume = *fromDense(grid, someProperties(), voxels.properties);
            RC_ASSERT(toDense(volume.snapshot()) == voxels.properties);
            voxels.each([&](glm::ivec3 voxel) {
                RC_ASSERT(volume.belongs(indexOf(voxel)) == (voxels.at(voxel) != airProperty));
            });
        });
        QVERIFY(held);
    }

    void aDenseArrayOfTheWrongSizeOrPropertyIsRefused() {
        using Voxels = std::vector<PropertyIndex>;
        const Grid grid = cubeGrid({2, 2, 2});
        QVERIFY(fromDense(grid, someProperties(), Voxels(7)).error().code == ErrorCode::argumentInvalid);
        QVERIFY(fromDense(grid, someProperties(), Voxels(8, 4)).error().code == ErrorCode::argumentInvalid);
    }

    void boundaryVoxelsHaveAnEmptyNeighbour() {
        const bool held = rc::check("boundary against 27 look-ups a voxel", [] {
            DenseVoxels some = someVoxels();
            for (PropertyIndex& property : some.properties) // mostly full, otherwise there would be no inner voxels
                if (property == airProperty && *rc::gen::inRange(0, 8) > 0) property = wax;
            const DenseVoxels& voxels = some;
            const Grid grid = cubeGrid(voxels.count, anyAxis());
            const auto found = boundaryVoxels(fromDense(grid, someProperties(), voxels.properties)->snapshot());
            std::size_t expected = 0;
            voxels.each([&](glm::ivec3 voxel) {
                bool empty = false;
                DenseVoxels::around(voxel, [&](glm::ivec3 near) { empty |= voxels.at(near) == airProperty; });
                const bool boundary = empty && voxels.at(voxel) != airProperty;
                expected += boundary ? 1 : 0;
                RC_ASSERT(boundary == (std::ranges::find(found, indexOf(voxel)) != found.end()));
            });
            RC_ASSERT(found.size() == expected);
        });
        QVERIFY(held);
    }

    void aSolidBlocksBoundaryIsItsSkin() {
        RunVolume volume = emptyVolume(cubeGrid({12, 12, 12}));
        QVERIFY(volume.fillBlock({1, 1}, {11, 11}, 256, 11 * 256, wax));
        QCOMPARE(boundaryVoxels(volume.snapshot()).size(), std::size_t{1000 - 512});
        QVERIFY((boundaryOfLine(volume.snapshot(), {5, 5}) == std::vector<VoxelInterval>{{1, 1}, {10, 10}}));
        QVERIFY((boundaryOfLine(volume.snapshot(), {1, 5}) == std::vector<VoxelInterval>{{1, 10}}));
        QVERIFY(boundaryOfLine(volume.snapshot(), {0, 5}).empty());
    }

    void booleansAreThoseOfTheirUnits() {
        const Grid grid = cubeGrid({9, 3, 2});
        const bool held = rc::check("union, intersection, difference against a dense grid", [&] {
            RunVolume a = emptyVolume(grid), b = emptyVolume(grid);
            DenseGrid denseA(grid), denseB(grid);
            const auto scatter = [&](RunVolume& volume, DenseGrid& dense) {
                for (int i = 0; i < 40; ++i) {
                    const LineIndex line{*rc::gen::inRange(0, 9), *rc::gen::inRange(0, 3)};
                    const auto from = *rc::gen::inRange<RunPosition>(0, 512),
                               to = *rc::gen::inRange<RunPosition>(0, 513);
                    const auto property = *rc::gen::inRange<PropertyIndex>(0, 4);
                    RC_ASSERT(volume.fillSpan(line, from, to, property));
                    dense.fillSpan(line, from, to, property);
                }
            };
            scatter(a, denseA);
            scatter(b, denseB);
            DenseGrid both(grid), common(grid), rest(grid);
            for (LineIndex line; line.v < 3; ++line.v)
                for (line.u = 0; line.u < 9; ++line.u)
                    for (RunPosition unit = 0; unit < grid.lineEnd(); ++unit) {
                        const PropertyIndex inA = denseA.at(line, unit), inB = denseB.at(line, unit);
                        both.at(line, unit) = inA != airProperty ? inA : inB;
                        common.at(line, unit) = inB != airProperty ? inA : airProperty;
                        rest.at(line, unit) = inB == airProperty ? inA : airProperty;
                    }
            RC_ASSERT(both.equals(*unionOf(a.snapshot(), b.snapshot())));
            RC_ASSERT(common.equals(*intersectionOf(a.snapshot(), b.snapshot())));
            RC_ASSERT(rest.equals(*differenceOf(a.snapshot(), b.snapshot())));
            RC_ASSERT(denseA.equals(a) && denseB.equals(b));
        });
        QVERIFY(held);
    }

    void unionBringsTheSecondVolumesPropertiesAlong() {
        const Grid grid = cubeGrid({2, 2, 2});
        PropertyList other;
        for (const char* id : {"brass", "wax"}) {
            Property property;
            property.id = id;
            QVERIFY(other.add(property));
        }
        RunVolume a = emptyVolume(grid), b = *RunVolume::make(grid, other);
        QVERIFY(b.fillSpan({0, 0}, 0, 256, 1)); // brass
        QVERIFY(b.fillSpan({1, 1}, 0, 256, 2)); // wax
        const auto both = unionOf(a.snapshot(), b.snapshot());
        QCOMPARE(both->properties()[both->line({0, 0})[0].property()].id, std::string("brass"));
        QVERIFY(both->line({1, 1})[0].property() == wax);
    }

    void volumesOnDifferentGridsAreRefused() {
        RunVolume a = emptyVolume(cubeGrid({2, 2, 2})), b = emptyVolume(cubeGrid({2, 2, 3}));
        QVERIFY(unionOf(a.snapshot(), b.snapshot()).error().code == ErrorCode::argumentInvalid);
        QVERIFY(intersectionOf(a.snapshot(), b.snapshot()).error().code == ErrorCode::argumentInvalid);
        QVERIFY(differenceOf(a.snapshot(), b.snapshot()).error().code == ErrorCode::argumentInvalid);
    }
};

BURIN_TEST(TestPaperOperations, NoApplication)

} // namespace burin::tst_paper_operations

#include "tst_paper_operations.moc"
