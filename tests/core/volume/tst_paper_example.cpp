// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/boolean.h"
#include "core/volume/operations/boundary.h"
#include "core/volume/operations/dense.h"
#include "core/volume/operations/relation.h"
#include "tests/core/volume/volumes.h"
#include "tests/test_program.h"

#include <QtTest>

#include <string_view>

namespace burin::tst_paper_example {

using namespace burin::test;

// The example slice of Chen & Yang 2004, section 3, and the results of each of the paper's operations on it, written
// out by hand. Voxels and runs count from 1 as in the paper and are parallel to x: R(x', x''; y, z).

namespace {

VoxelIndex voxel(int x, int y, int z) {
    return {x - 1, y - 1, z - 1};
}
Run run(int first, int last, PropertyIndex property = wax) {
    return {first - 1, last - 1, property};
}

constexpr int sliceZ = 3;
const Grid& grid() {
    static const Grid it = cubeGrid({6, 9, 3}, RunAxis::x);
    return it;
}

/// R(first, last; y, z) of an object.
struct PaperRun {
    int first, last, y, z;
};

RunVolume objectOf(std::initializer_list<PaperRun> runs, PropertyIndex property = wax) {
    RunVolume volume = emptyVolume(grid());
    for (const auto& [first, last, y, z] : runs)
        for (int x = first; x <= last; ++x) (void)volume.insert(voxel(x, y, z), property);
    return volume;
}

RunVolume paperExample() {
    return objectOf({{2, 3, 2, sliceZ},
                     {2, 3, 3, sliceZ},
                     {2, 3, 4, sliceZ},
                     {2, 5, 5, sliceZ},
                     {2, 4, 6, sliceZ},
                     {3, 4, 7, sliceZ},
                     {3, 4, 8, sliceZ}});
}

/// The same slice three times, on top of each other.
RunVolume paperExampleAsAPrism() {
    RunVolume volume = emptyVolume(grid());
    const RunVolume slice = paperExample();
    for (std::int32_t z = 0; z < 3; ++z)
        for (std::int32_t y = 0; y < 9; ++y) (void)volume.setLine({y, z}, slice.line({y, sliceZ - 1}));
    return volume;
}

std::vector<Run> runsOf(const RunVolume& volume, int y) {
    return volume.runs({y - 1, sliceZ - 1});
}

using Rows = std::vector<std::vector<Run>>;
/// The rows of the slice, y = 1 … 9.
Rows rowsOf(const RunVolume& volume) {
    Rows rows;
    for (int y = 1; y <= 9; ++y) rows.push_back(runsOf(volume, y));
    return rows;
}

bool isEmptyBelow(const RunVolume& volume) {
    for (std::int32_t z = 0; z < sliceZ - 1; ++z)
        for (std::int32_t y = 0; y < 9; ++y)
            if (!volume.runs({y, z}).empty()) return false;
    return true;
}

using Intervals = std::vector<VoxelInterval>;
VoxelInterval interval(int first, int last) {
    return {first - 1, last - 1};
}
/// Boundary voxels of a slice, y = 1 … 9.
std::vector<Intervals> boundaryRows(const BoundaryList& list, int z) {
    std::vector<Intervals> rows;
    for (int y = 1; y <= 9; ++y) {
        const auto line = list.line({y - 1, z - 1});
        rows.emplace_back(line.begin(), line.end());
    }
    return rows;
}

/// The voxel array of the slice with nothing below it; 'w' wax, x counts fastest.
std::vector<PropertyIndex> pictured(std::string_view slice) {
    std::vector<PropertyIndex> voxels(6 * 9 * 2, airProperty);
    for (const char c : slice) voxels.push_back(c == 'w' ? wax : airProperty);
    return voxels;
}
constexpr std::string_view picture = "......"
                                     ".ww..."
                                     ".ww..."
                                     ".ww..."
                                     ".wwww."
                                     ".www.."
                                     "..ww.."
                                     "..ww.."
                                     "......";

} // namespace

class TestPaperExample : public QObject {
    Q_OBJECT

private slots:
    void hasThePapersRuns() {
        const RunVolume volume = paperExample();
        QVERIFY(
            (rowsOf(volume) ==
             Rows{{}, {run(2, 3)}, {run(2, 3)}, {run(2, 3)}, {run(2, 5)}, {run(2, 4)}, {run(3, 4)}, {run(3, 4)}, {}}));
        QVERIFY(isEmptyBelow(volume));
    }

    void isConstructedFromItsVoxelsAndGivesThemBack() {
        QVERIFY(toDense(paperExample().snapshot()) == pictured(picture));
        RunVolume constructed = *fromDense(grid(), someProperties(), pictured(picture));
        QVERIFY(rowsOf(constructed) == rowsOf(paperExample()));
        QVERIFY(isEmptyBelow(constructed));
        QVERIFY(toDense(constructed.snapshot()) == pictured(picture));
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
        QVERIFY(volume.insert(voxel(5, 2, 3), wax) == VoxelEdit::done);
        QVERIFY((runsOf(volume, 2) == std::vector{run(2, 3), run(5, 5)}));
    }
    void insertingAnAdjacentVoxelExtendsTheRun() { // B
        RunVolume volume = paperExample();
        QVERIFY(volume.insert(voxel(4, 4, 3), wax) == VoxelEdit::done);
        QVERIFY((runsOf(volume, 4) == std::vector{run(2, 4)}));
    }
    void insertingAVoxelInsideChangesNothing() { // C
        RunVolume volume = paperExample();
        const RunAmounts before = volume.amounts();
        QVERIFY(volume.insert(voxel(3, 5, 3), aluminium) == VoxelEdit::nothing);
        QVERIFY((runsOf(volume, 5) == std::vector{run(2, 5)}));
        QVERIFY(volume.amounts() == before);
    }
    void insertingAirOrOutsideTheGridChangesNothing() {
        RunVolume volume = paperExample();
        QVERIFY(volume.insert(voxel(4, 4, 3), airProperty) == VoxelEdit::nothing);
        QVERIFY(volume.insert(voxel(7, 4, 3), wax) == VoxelEdit::nothing);
        QVERIFY(rowsOf(volume) == rowsOf(paperExample()));
    }
    void removingAVoxelOutsideFails() { // A
        RunVolume volume = paperExample();
        const RunAmounts before = volume.amounts();
        QVERIFY(volume.remove(voxel(5, 2, 3)) == VoxelEdit::nothing);
        QVERIFY(volume.remove(voxel(9, 9, 9)) == VoxelEdit::nothing);
        QVERIFY(volume.amounts() == before);
    }
    void removingAnEndVoxelShortensTheRun() { // B
        RunVolume volume = paperExample();
        QVERIFY(volume.remove(voxel(2, 2, 3)) == VoxelEdit::done);
        QVERIFY((runsOf(volume, 2) == std::vector{run(3, 3)}));
    }
    void removingAnInnerVoxelSplitsTheRun() { // C
        RunVolume volume = paperExample();
        QVERIFY(volume.remove(voxel(3, 5, 3)) == VoxelEdit::done);
        QVERIFY((runsOf(volume, 5) == std::vector{run(2, 2), run(4, 5)}));
    }

    void anInsertedVoxelOfAnotherPropertyIsARunOfItsOwn() {
        RunVolume volume = paperExample();
        QVERIFY(volume.insert(voxel(4, 4, 3), aluminium) == VoxelEdit::done);
        QVERIFY((runsOf(volume, 4) == std::vector{run(2, 3), run(4, 4, aluminium)}));
    }

    void boundaryIsTheWholeSlice() { // below and above each voxel is an empty one
        RunVolume volume = paperExample();
        const std::vector<Intervals> expected{{},
                                              {interval(2, 3)},
                                              {interval(2, 3)},
                                              {interval(2, 3)},
                                              {interval(2, 5)},
                                              {interval(2, 4)},
                                              {interval(3, 4)},
                                              {interval(3, 4)},
                                              {}};
        const BoundaryList list(volume.snapshot());
        QVERIFY(boundaryRows(list, 3) == expected);
        QCOMPARE(list.voxelCount(), std::uint64_t{17});
        QVERIFY(
            (list.voxels() ==
             std::vector{voxel(2, 2, 3), voxel(3, 2, 3), voxel(2, 3, 3), voxel(3, 3, 3), voxel(2, 4, 3), voxel(3, 4, 3),
                         voxel(2, 5, 3), voxel(3, 5, 3), voxel(4, 5, 3), voxel(5, 5, 3), voxel(2, 6, 3), voxel(3, 6, 3),
                         voxel(4, 6, 3), voxel(3, 7, 3), voxel(4, 7, 3), voxel(3, 8, 3), voxel(4, 8, 3)}));
    }

    /// The paper's insertions and removals, with the boundary updated after each.
    void boundaryFollowsThePapersEdits() {
        RunVolume volume = paperExample();
        BoundaryList list(volume.snapshot());
        const auto updated = [&](int y) {
            list.update(volume.snapshot());
            return boundaryRows(list, 3)[static_cast<std::size_t>(y - 1)];
        };
        QVERIFY(volume.insert(voxel(5, 2, 3), wax) == VoxelEdit::done); // insertion A
        QVERIFY((updated(2) == Intervals{interval(2, 3), interval(5, 5)}));
        QVERIFY(volume.insert(voxel(4, 4, 3), wax) == VoxelEdit::done); // insertion B
        QVERIFY((updated(4) == Intervals{interval(2, 4)}));
        QVERIFY(volume.remove(voxel(2, 2, 3)) == VoxelEdit::done); // removal B
        QVERIFY((updated(2) == Intervals{interval(3, 3), interval(5, 5)}));
        QVERIFY(volume.remove(voxel(3, 5, 3)) == VoxelEdit::done); // removal C
        QVERIFY((updated(5) == Intervals{interval(2, 2), interval(4, 5)}));
        QCOMPARE(list.voxelCount(), std::uint64_t{17});
    }

    /// Three such slices, widened to R(2, 4; 4, z) and R(2, 4; 7, z): in the middle one (3; 5) and (3; 6) are inner
    /// voxels, until their neighbours are removed.
    void boundaryOfAPrismHasAnInside() {
        RunVolume volume = paperExampleAsAPrism();
        BoundaryList list(volume.snapshot());
        QCOMPARE(list.voxelCount(), std::uint64_t{3 * 17}); // too narrow for inner voxels as it is
        for (int z = 1; z <= 3; ++z) {
            QVERIFY(volume.insert(voxel(4, 4, z), wax) == VoxelEdit::done);
            QVERIFY(volume.insert(voxel(2, 7, z), wax) == VoxelEdit::done);
        }
        const std::vector<Intervals> outer{{},
                                           {interval(2, 3)},
                                           {interval(2, 3)},
                                           {interval(2, 4)},
                                           {interval(2, 5)},
                                           {interval(2, 4)},
                                           {interval(2, 4)},
                                           {interval(3, 4)},
                                           {}};
        std::vector<Intervals> middle = outer;
        middle[5 - 1] = {interval(2, 2), interval(4, 5)};
        middle[6 - 1] = {interval(2, 2), interval(4, 4)};
        list.update(volume.snapshot());
        QVERIFY(boundaryRows(list, 1) == outer);
        QVERIFY(boundaryRows(list, 2) == middle);
        QVERIFY(boundaryRows(list, 3) == outer);
        QVERIFY(BoundaryList(volume.snapshot()).voxels() == list.voxels());
        QCOMPARE(list.voxelCount(), std::uint64_t{3 * 19 - 2});

        QVERIFY(volume.remove(voxel(4, 7, 3)) == VoxelEdit::done); // only a corner of (3; 6)
        list.update(volume.snapshot());
        middle[6 - 1] = {interval(2, 4)};
        QVERIFY(boundaryRows(list, 2) == middle);
        QVERIFY((boundaryOfLine(volume.snapshot(), {5 - 1, 2 - 1}) == middle[5 - 1]));
    }

    void relations_data() {
        QTest::addColumn<std::array<int, 4>>("other"); // R(x', x''; y, z)
        QTest::addColumn<int>("expected");
        const auto row = [](const char* name, std::array<int, 4> other, SpatialRelation expected) {
            QTest::newRow(name) << other << static_cast<int>(expected);
        };
        row("a common voxel at a run's end", {5, 6, 5, 3}, SpatialRelation::intersecting);
        row("around a run", {1, 6, 7, 3}, SpatialRelation::intersecting);
        row("insertion B: beside a run's end", {4, 4, 4, 3}, SpatialRelation::adjacent);
        row("beyond a corner in the slice", {5, 6, 9, 3}, SpatialRelation::adjacent);
        row("beyond a corner of a voxel", {5, 5, 9, 2}, SpatialRelation::adjacent);
        row("below", {3, 3, 6, 2}, SpatialRelation::adjacent);
        row("insertion A: a voxel between", {5, 5, 2, 3}, SpatialRelation::separate);
        row("beside, on the line of a longer run's neighbour", {6, 6, 7, 3}, SpatialRelation::separate);
        row("a slice between", {2, 5, 5, 1}, SpatialRelation::separate);
    }
    void relations() {
        using FourNumbers = std::array<int, 4>;
        QFETCH(FourNumbers, other);
        QFETCH(int, expected);
        RunVolume slice = paperExample(), object = objectOf({{other[0], other[1], other[2], other[3]}}, part);
        QCOMPARE(static_cast<int>(*relation(slice.snapshot(), object.snapshot())), expected);
        QCOMPARE(static_cast<int>(*relation(object.snapshot(), slice.snapshot())), expected);
    }

    /// A second object in the slice: R(5, 6; 2), R(3, 5; 4), R(4, 6; 5), R(5, 6; 6), R(1, 6; 9).
    void unionIntersectionAndDifference() {
        const auto other = [](PropertyIndex property) {
            return objectOf(
                {{5, 6, 2, sliceZ}, {3, 5, 4, sliceZ}, {4, 6, 5, sliceZ}, {5, 6, 6, sliceZ}, {1, 6, 9, sliceZ}},
                property);
        };
        RunVolume slice = paperExample(), alike = other(wax), harder = other(aluminium);
        const RunVolume both = *unionOf(slice.snapshot(), alike.snapshot());
        QVERIFY((rowsOf(both) == Rows{{},
                                      {run(2, 3), run(5, 6)}, // separate: added
                                      {run(2, 3)},
                                      {run(2, 5)}, // intersecting: merged
                                      {run(2, 6)},
                                      {run(2, 6)}, // adjacent: merged
                                      {run(3, 4)},
                                      {run(3, 4)},
                                      {run(1, 6)}}));
        const RunVolume ofTwo = *unionOf(slice.snapshot(), harder.snapshot()); // homogeneous runs: not merged
        QVERIFY((rowsOf(ofTwo) == Rows{{},
                                       {run(2, 3), run(5, 6, aluminium)},
                                       {run(2, 3)},
                                       {run(2, 3), run(4, 5, aluminium)},
                                       {run(2, 5), run(6, 6, aluminium)},
                                       {run(2, 4), run(5, 6, aluminium)},
                                       {run(3, 4)},
                                       {run(3, 4)},
                                       {run(1, 6, aluminium)}}));
        const RunVolume common = *intersectionOf(slice.snapshot(), harder.snapshot());
        QVERIFY((rowsOf(common) == Rows{{}, {}, {}, {run(3, 3)}, {run(4, 5)}, {}, {}, {}, {}}));
        const RunVolume rest = *differenceOf(slice.snapshot(), harder.snapshot());
        QVERIFY(
            (rowsOf(rest) ==
             Rows{{}, {run(2, 3)}, {run(2, 3)}, {run(2, 2)}, {run(2, 3)}, {run(2, 4)}, {run(3, 4)}, {run(3, 4)}, {}}));
        for (const RunVolume* result : {&both, &ofTwo, &common, &rest}) QVERIFY(isEmptyBelow(*result));
        QVERIFY(rowsOf(slice) == rowsOf(paperExample())); // the operands are unchanged
    }
};

BURIN_TEST(TestPaperExample, NoApplication)

} // namespace burin::tst_paper_example

#include "tst_paper_example.moc"
