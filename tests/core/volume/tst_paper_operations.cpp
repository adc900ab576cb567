// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/boolean.h"
#include "core/volume/boundary.h"
#include "core/volume/dense.h"
#include "core/volume/relation.h"
#include "core/volume/voxelisation.h"
#include "tests/core/volume/shapes.h"
#include "tests/core/volume/volumes.h"
#include "tests/oracles/dense_grid.h"

#include <QtTest>
#include <rapidcheck.h>

using namespace burin;
using namespace burin::test;
using burin::oracles::DenseGrid;

namespace {

/// The paper's voxels and runs count from 1 and lie along x: R(x', x''; y, z).
VoxelIndex voxel(int x, int y, int z) {
    return {x - 1, y - 1, z - 1};
}
Run run(int first, int last, PropertyIndex property = wax) {
    return {first - 1, last - 1, property};
}

constexpr int sliceZ = 3;

/// The top slice of the paper's example: y and its run.
const std::vector<std::array<int, 3>> exampleSlice{{2, 2, 3}, {3, 2, 3}, {4, 2, 3}, {5, 2, 5},
                                                   {6, 2, 4}, {7, 3, 4}, {8, 3, 4}};

RunVolume paperExample() {
    RunVolume volume = emptyVolume(cubeGrid({6, 9, 3}, RunAxis::x));
    for (const auto& [y, first, last] : exampleSlice)
        for (int x = first; x <= last; ++x) volume.insert(voxel(x, y, sliceZ), wax);
    return volume;
}

std::vector<Run> runsOf(const RunVolume& volume, int y) {
    return volume.runs({y - 1, sliceZ - 1});
}

using Voxels = std::vector<PropertyIndex>;

/// Blobs rather than noise: each voxel takes after one before it.
rc::Gen<Voxels> someVoxels(std::size_t count) {
    return rc::gen::exec([=] {
        Voxels voxels(count);
        for (std::size_t i = 0; i < count; ++i)
            voxels[i] = *rc::gen::inRange(0, 4) > 0 && i > 0 ? voxels[i - 1] : *rc::gen::inRange<PropertyIndex>(0, 4);
        return voxels;
    });
}

struct Small {
    glm::ivec3 count{5, 4, 6};
    std::size_t total() const { return static_cast<std::size_t>(count.x * count.y * count.z); }
    PropertyIndex at(const Voxels& voxels, int i, int j, int k) const {
        if (i < 0 || j < 0 || k < 0 || i >= count.x || j >= count.y || k >= count.z) return airProperty;
        return voxels[static_cast<std::size_t>((k * count.y + j) * count.x + i)];
    }
    /// Calls visit(i, j, k) for each voxel within one step, itself included.
    template <class Visit>
    static void around(int i, int j, int k, Visit visit) {
        for (int dk = -1; dk <= 1; ++dk)
            for (int dj = -1; dj <= 1; ++dj)
                for (int di = -1; di <= 1; ++di) visit(i + di, j + dj, k + dk);
    }
    template <class Visit>
    void each(Visit visit) const {
        for (int k = 0; k < count.z; ++k)
            for (int j = 0; j < count.y; ++j)
                for (int i = 0; i < count.x; ++i) visit(i, j, k);
    }
};

RunAxis anyAxis() {
    return *rc::gen::element(RunAxis::x, RunAxis::y, RunAxis::z);
}

} // namespace

class TestPaperOperations : public QObject {
    Q_OBJECT

private slots:
    void theExampleSliceHasThePapersRuns() {
        const RunVolume volume = paperExample();
        for (const auto& [y, first, last] : exampleSlice) QVERIFY((runsOf(volume, y) == std::vector{run(first, last)}));
        QVERIFY(runsOf(volume, 1).empty());
        QVERIFY(runsOf(volume, 9).empty());
    }

    void belongingAndLocating() {
        const RunVolume volume = paperExample();
        QVERIFY(volume.belongs(voxel(4, 5, 3)));
        QVERIFY(!volume.belongs(voxel(4, 4, 3)));
        QVERIFY(!volume.belongs(voxel(4, 5, 2)));
        QVERIFY(!volume.belongs(voxel(0, 5, 3))); // outside the grid
        QVERIFY(volume.locate(voxel(4, 5, 3)) == run(2, 5));
        QVERIFY(!volume.locate(voxel(4, 4, 3)));
        QVERIFY(!volume.locate(voxel(7, 5, 3)));
    }

    void insertingASeparateVoxelMakesARun() { // A
        RunVolume volume = paperExample();
        QVERIFY(volume.insert(voxel(5, 2, 3), wax));
        QVERIFY((runsOf(volume, 2) == std::vector{run(2, 3), run(5, 5)}));
    }
    void insertingAnAdjacentVoxelExtendsTheRun() { // B
        RunVolume volume = paperExample();
        QVERIFY(volume.insert(voxel(4, 4, 3), wax));
        QVERIFY((runsOf(volume, 4) == std::vector{run(2, 4)}));
    }
    void insertingAVoxelInsideChangesNothing() { // C
        RunVolume volume = paperExample();
        const RunAmounts before = volume.amounts();
        QVERIFY(!volume.insert(voxel(3, 5, 3), aluminium));
        QVERIFY((runsOf(volume, 5) == std::vector{run(2, 5)}));
        QVERIFY(volume.amounts() == before);
    }
    void removingAVoxelOutsideFails() { // A
        RunVolume volume = paperExample();
        const RunAmounts before = volume.amounts();
        QVERIFY(!volume.remove(voxel(5, 2, 3)));
        QVERIFY(!volume.remove(voxel(9, 9, 9)));
        QVERIFY(volume.amounts() == before);
    }
    void removingAnEndVoxelShortensTheRun() { // B
        RunVolume volume = paperExample();
        QVERIFY(volume.remove(voxel(2, 2, 3)));
        QVERIFY((runsOf(volume, 2) == std::vector{run(3, 3)}));
    }
    void removingAnInnerVoxelSplitsTheRun() { // C
        RunVolume volume = paperExample();
        QVERIFY(volume.remove(voxel(3, 5, 3)));
        QVERIFY((runsOf(volume, 5) == std::vector{run(2, 2), run(4, 5)}));
    }

    void anInsertedVoxelOfAnotherPropertyIsARunOfItsOwn() {
        RunVolume volume = paperExample();
        QVERIFY(volume.insert(voxel(4, 4, 3), aluminium));
        QVERIFY((runsOf(volume, 4) == std::vector{run(2, 3), run(4, 4, aluminium)}));
    }

    void subVoxelRunsShowAsTheVoxelsWhoseCentresTheyHold() {
        RunVolume volume = emptyVolume(cubeGrid({1, 1, 8}));
        QVERIFY(volume.fillSpan({0, 0}, 128, 3 * 256 + 128, wax)); // from the first centre to the fourth, without it
        QVERIFY((volume.runs({0, 0}) == std::vector{Run{0, 2, wax}}));
        QVERIFY(volume.fillSpan({0, 0}, 256 + 10, 256 + 100, aluminium)); // holds no centre
        QVERIFY((volume.runs({0, 0}) == std::vector{Run{0, 2, wax}}));
        QVERIFY((volume.locate({0, 0, 1}) == Run{0, 2, wax}));
    }

    void aDenseArrayComesBackAsItWas() {
        const Small small;
        const bool held = rc::check("dense, runs, dense", [&] {
            const Voxels voxels = *someVoxels(small.total());
            const Grid grid = cubeGrid(small.count, anyAxis());
            RunVolume volume = *fromDense(grid, someProperties(), voxels);
            RC_ASSERT(toDense(volume.snapshot()) == voxels);
            small.each([&](int i, int j, int k) {
                RC_ASSERT(volume.belongs({i, j, k}) == (small.at(voxels, i, j, k) != airProperty));
            });
        });
        QVERIFY(held);
    }

    void aDenseArrayOfTheWrongSizeOrPropertyIsRefused() {
        const Grid grid = cubeGrid({2, 2, 2});
        QVERIFY(fromDense(grid, someProperties(), Voxels(7)).error().code == ErrorCode::argumentInvalid);
        QVERIFY(fromDense(grid, someProperties(), Voxels(8, 4)).error().code == ErrorCode::argumentInvalid);
    }

    void boundaryVoxelsHaveAnEmptyNeighbour() {
        const Small small;
        const bool held = rc::check("boundary against 27 look-ups a voxel", [&] {
            Voxels voxels = *someVoxels(small.total());
            for (PropertyIndex& property : voxels) // mostly full, or nothing would be inside
                if (property == airProperty && *rc::gen::inRange(0, 8) > 0) property = wax;
            const Grid grid = cubeGrid(small.count, anyAxis());
            const auto found = boundaryVoxels(fromDense(grid, someProperties(), voxels)->snapshot());
            std::size_t expected = 0;
            small.each([&](int i, int j, int k) {
                bool empty = false;
                Small::around(i, j, k, [&](int x, int y, int z) { empty |= small.at(voxels, x, y, z) == airProperty; });
                const bool boundary = empty && small.at(voxels, i, j, k) != airProperty;
                expected += boundary ? 1 : 0;
                RC_ASSERT(boundary == (std::ranges::find(found, VoxelIndex{i, j, k}) != found.end()));
            });
            RC_ASSERT(found.size() == expected);
        });
        QVERIFY(held);
    }

    void aSolidBlocksBoundaryIsItsSkin() {
        RunVolume volume = emptyVolume(cubeGrid({12, 12, 12}));
        QVERIFY(volume.fillBlock({1, 1}, {11, 11}, 256, 11 * 256, wax));
        QCOMPARE(boundaryVoxels(volume.snapshot()).size(), std::size_t{1000 - 512});
        QVERIFY((boundaryOfLine(volume.snapshot(), {5, 5}) == std::vector<VoxelStretch>{{1, 1}, {10, 10}}));
        QVERIFY((boundaryOfLine(volume.snapshot(), {1, 5}) == std::vector<VoxelStretch>{{1, 10}}));
        QVERIFY(boundaryOfLine(volume.snapshot(), {0, 5}).empty());
    }

    void relationsAreThoseOfTheVoxels() {
        const Small small;
        const bool held = rc::check("relation against pairs of voxels", [&] {
            const auto sparse = [&] {
                Voxels voxels(small.total());
                const int count = *rc::gen::inRange(0, 4);
                for (int i = 0; i < count; ++i) voxels[*rc::gen::inRange(std::size_t{0}, small.total())] = wax;
                return voxels;
            };
            const Voxels a = sparse(), b = sparse();
            bool intersecting = false, adjacent = false;
            small.each([&](int i, int j, int k) {
                if (small.at(a, i, j, k) == airProperty) return;
                intersecting |= small.at(b, i, j, k) != airProperty;
                Small::around(i, j, k, [&](int x, int y, int z) { adjacent |= small.at(b, x, y, z) != airProperty; });
            });
            const auto expected = intersecting ? SpatialRelation::intersecting
                                  : adjacent   ? SpatialRelation::adjacent
                                               : SpatialRelation::separate;
            const Grid grid = cubeGrid(small.count, anyAxis());
            RunVolume volumeA = *fromDense(grid, someProperties(), a), volumeB = *fromDense(grid, someProperties(), b);
            RC_ASSERT(*relation(volumeA.snapshot(), volumeB.snapshot()) == expected);
        });
        QVERIFY(held);
    }

    void closedBodiesThatShareAFaceAreAdjacent_data() {
        QTest::addColumn<glm::dvec3>("low");
        QTest::addColumn<int>("expected");
        const auto row = [](const char* name, glm::dvec3 low, SpatialRelation expected) {
            QTest::newRow(name) << low << static_cast<int>(expected);
        };
        row("face across the runs, between two voxel faces", {2, 2, 6.3}, SpatialRelation::adjacent);
        row("face along the runs", {6, 2, 2}, SpatialRelation::adjacent);
        row("a gap of a twentieth of a voxel", {2, 2, 6.35}, SpatialRelation::separate);
        row("a tenth of a voxel into each other", {2, 2, 6.2}, SpatialRelation::intersecting);
    }
    void closedBodiesThatShareAFaceAreAdjacent() {
        QFETCH(glm::dvec3, low);
        QFETCH(int, expected);
        const Grid grid = cubeGrid({16, 16, 16});
        RunVolume lower = emptyVolume(grid), upper = emptyVolume(grid);
        Progress progress;
        QVERIFY(voxelise(boxMesh({2, 2, 2}, {6, 6, 6.3}), wax, lower, progress));
        QVERIFY(voxelise(boxMesh(low, low + glm::dvec3(4)), wax, upper, progress));
        QCOMPARE(static_cast<int>(*relation(lower.snapshot(), upper.snapshot())), expected);
    }

    void propertiesOfOneVolumeAreAdjacentOrSeparate() {
        RunVolume volume = emptyVolume(cubeGrid({4, 4, 8}));
        QVERIFY(volume.fillSpan({0, 0}, 0, 700, wax));
        QVERIFY(volume.fillSpan({1, 1}, 700, 900, aluminium));
        QVERIFY(volume.fillSpan({3, 1}, 0, 900, part));
        const VolumeSnapshot snapshot = volume.snapshot();
        QVERIFY(relation(snapshot, wax, aluminium) == SpatialRelation::adjacent);
        QVERIFY(relation(snapshot, wax, part) == SpatialRelation::separate);
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
        QVERIFY(relation(a.snapshot(), b.snapshot()).error().code == ErrorCode::argumentInvalid);
        QVERIFY(unionOf(a.snapshot(), b.snapshot()).error().code == ErrorCode::argumentInvalid);
        QVERIFY(intersectionOf(a.snapshot(), b.snapshot()).error().code == ErrorCode::argumentInvalid);
        QVERIFY(differenceOf(a.snapshot(), b.snapshot()).error().code == ErrorCode::argumentInvalid);
    }
};

QTEST_APPLESS_MAIN(TestPaperOperations)
#include "tst_paper_operations.moc"
