// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/dense.h"
#include "core/volume/operations/relation.h"
#include "core/volume/voxelisation/voxelisation.h"
#include "tests/core/volume/dense_voxels.h"
#include "tests/core/volume/shapes.h"
#include "tests/core/volume/volumes.h"
#include "tests/oracles/dense_grid.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <map>

namespace burin::tst_relation {

using namespace burin::test;
using burin::oracles::DenseGrid;

namespace {

constexpr std::size_t reserve = std::size_t{1} << 20;

SpatialRelation relationOf(bool intersecting, bool adjacent) {
    return intersecting ? SpatialRelation::intersecting
           : adjacent   ? SpatialRelation::adjacent
                        : SpatialRelation::separate;
}

/// By examining the 26 neighbours of each voxel, and the voxel itself.
SpatialRelation denseRelation(const DenseVoxels& a, const DenseVoxels& b) {
    bool intersecting = false, adjacent = false;
    a.each([&](glm::ivec3 voxel) {
        if (a.at(voxel) == airProperty) return;
        intersecting |= b.at(voxel) != airProperty;
        DenseVoxels::around(voxel, [&](glm::ivec3 near) { adjacent |= b.at(near) != airProperty; });
    });
    return relationOf(intersecting, adjacent);
}

/// The same for pieces of 1/256 voxel: they touch in a face, an edge or a corner.
SpatialRelation denseRelation(const Grid& grid, const DenseGrid& a, const DenseGrid& b) {
    bool intersecting = false, adjacent = false;
    const auto look = [&](LineIndex line, RunPosition unit) {
        intersecting |= b.at(line, unit) != airProperty;
        for (int dv = -1; dv <= 1; ++dv)
            for (int du = -1; du <= 1; ++du) {
                const LineIndex near{line.u + du, line.v + dv};
                if (!grid.contains(near)) continue;
                for (RunPosition k = unit == 0 ? 0 : unit - 1; k <= unit + 1 && k < grid.lineEnd(); ++k)
                    adjacent |= b.at(near, k) != airProperty;
            }
    };
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            for (RunPosition unit = 0; unit < grid.lineEnd(); ++unit)
                if (a.at(line, unit) != airProperty) look(line, unit);
    return relationOf(intersecting, adjacent);
}

RunAxis anyAxis() {
    return *rc::gen::element(RunAxis::x, RunAxis::y, RunAxis::z);
}

/// Scanlines of two voxels along any axis, 18 … 40 of them in each direction.
Grid anyGridOfShortLines() {
    const RunAxis axis = anyAxis();
    const int along = static_cast<int>(axis);
    glm::ivec3 count(2);
    count[(along + 1) % 3] = *rc::gen::inRange(18, 41);
    count[(along + 2) % 3] = *rc::gen::inRange(18, 41);
    return cubeGrid(count, axis);
}

/// Mostly on one side or the other of a border between bricks of 8 × 8 scanlines.
int anyPlace(int count) {
    const int border = 8 * *rc::gen::inRange(1, std::max(2, (count + 7) / 8));
    const int near = border + *rc::gen::inRange(-1, 1);
    return near<count&& * rc::gen::inRange(0, 4)> 0 ? near : *rc::gen::inRange(0, count);
}

/// A few voxels in a row along a random axis; those outside the grid are left out.
void fillRow(DenseVoxels& voxels, glm::ivec3 from) {
    const int axis = *rc::gen::inRange(0, 3), length = *rc::gen::inRange(1, 5);
    for (int i = 0; i < length; ++i, ++from[axis])
        if (voxels.contains(from)) voxels.at(from) = wax;
}

/// Two sparse objects, a piece of one near a piece of the other.
struct Objects {
    explicit Objects(glm::ivec3 count) : a(count), b(count) {
        const auto anywhere = [&] { return glm::ivec3(anyPlace(count.x), anyPlace(count.y), anyPlace(count.z)); };
        const glm::ivec3 meeting = anywhere();
        const auto off = [] { return *rc::gen::element(-2, -1, -1, 0, 0, 1, 1, 2); };
        fillRow(a, meeting);
        fillRow(b, meeting + glm::ivec3(off(), off(), off()));
        for (int i = *rc::gen::inRange(0, 4); i > 0; --i) fillRow(*rc::gen::arbitrary<bool>() ? a : b, anywhere());
    }
    DenseVoxels a, b;
};

/// Four draws per case, so that each relation occurs whatever the seed: a hundred draws may lack one.
template <class Property>
bool holdsForMany(const char* name, const Property& property) {
    return rc::check(name, [&] {
        for (int draw = 0; draw < 4; ++draw) property();
    });
}

/// Checks at the end whether all cases occurred; a test that saw only one proves little.
class Seen {
public:
    void add(SpatialRelation relation) { ++counts_[relation]; }
    bool all() const { return counts_.size() == 3; }

private:
    std::map<SpatialRelation, int> counts_;
};

RunVolume volumeOf(const Grid& grid, const DenseVoxels& voxels) {
    return *fromDense(grid, someProperties(), voxels.properties);
}

} // namespace

class TestRelation : public QObject {
    Q_OBJECT

private slots:
    void relationsAreThoseOfTheVoxels() {
        Seen seen;
        QVERIFY(holdsForMany("relation over several bricks against pairs of voxels", [&] {
            const auto size = [] { return *rc::gen::inRange(18, 41); };
            const Objects objects({size(), size(), size()});
            const Grid grid = cubeGrid(objects.a.count, anyAxis());
            const SpatialRelation expected = denseRelation(objects.a, objects.b);
            RunVolume a = volumeOf(grid, objects.a), b = volumeOf(grid, objects.b);
            RC_ASSERT(*relation(a.snapshot(), b.snapshot()) == expected);
            RC_ASSERT(*relation(b.snapshot(), a.snapshot()) == expected);
            seen.add(expected);
        }));
        QVERIFY(seen.all());
    }

    void relationsInASingleBrick() {
        Seen seen;
        QVERIFY(holdsForMany("relation within a brick against pairs of voxels", [&] {
            const Objects objects({5, 4, 6});
            const Grid grid = cubeGrid(objects.a.count, anyAxis());
            const SpatialRelation expected = denseRelation(objects.a, objects.b);
            RunVolume a = volumeOf(grid, objects.a), b = volumeOf(grid, objects.b);
            RC_ASSERT(*relation(a.snapshot(), b.snapshot()) == expected);
            seen.add(expected);
        }));
        QVERIFY(seen.all());
    }

    /// Voxels on all four lines around the corner where four bricks meet, the other one up to two steps away.
    void everyOffsetAcrossTheCornerOfFourBricks() {
        for (const RunAxis axis : {RunAxis::x, RunAxis::y, RunAxis::z}) {
            const Grid grid = cubeGrid({18, 19, 20}, axis);
            for (const LineIndex line : {LineIndex{7, 7}, {8, 7}, {7, 8}, {8, 8}}) {
                RunVolume a = emptyVolume(grid, reserve);
                QVERIFY(a.insert(grid.voxel(line, 9), wax) == VoxelEdit::done);
                for (int offset = 0; offset < 125; ++offset) {
                    const int du = offset % 5 - 2, dv = offset / 5 % 5 - 2, along = offset / 25 - 2;
                    RunVolume b = emptyVolume(grid, reserve);
                    QVERIFY(b.insert(grid.voxel({line.u + du, line.v + dv}, 9 + along), part) == VoxelEdit::done);
                    const int steps = std::max({std::abs(du), std::abs(dv), std::abs(along)});
                    QVERIFY2(*relation(a.snapshot(), b.snapshot()) == relationOf(steps == 0, steps <= 1),
                             qPrintable(QString("line %1 %2, offset %3 %4 %5, axis %6")
                                            .arg(line.u)
                                            .arg(line.v)
                                            .arg(du)
                                            .arg(dv)
                                            .arg(along)
                                            .arg(static_cast<int>(axis))));
                }
            }
        }
    }

    /// Ends to 1/256 voxel, many of them exactly where the other's begin.
    void subVoxelRunsRelateByTheirEnds() {
        Seen seen;
        QVERIFY(holdsForMany("relation of runs with sub-voxel ends against pairs of their units", [&] {
            const Grid grid = anyGridOfShortLines();
            RunVolume a = emptyVolume(grid, reserve), b = emptyVolume(grid, reserve);
            DenseGrid denseA(grid), denseB(grid);
            const auto fill = [&](RunVolume& volume, DenseGrid& dense, LineIndex line, int from, int to) {
                if (!grid.contains(line)) return;
                const auto at = [](int unit) { return static_cast<RunPosition>(std::clamp(unit, 0, 512)); };
                RC_ASSERT(volume.fillSpan(line, at(from), at(to), aluminium));
                dense.fillSpan(line, at(from), at(to), aluminium);
            };
            const auto anyLine = [&] { return LineIndex{anyPlace(grid.lineCountU()), anyPlace(grid.lineCountV())}; };
            const auto length = [] { return *rc::gen::element(1, 30, 256); };
            const LineIndex meeting = anyLine();
            const auto off = [] { return *rc::gen::element(-2, -1, 0, 0, 1, 2); };
            const int from = *rc::gen::inRange(0, 500), to = from + length();
            fill(a, denseA, meeting, from, to);
            const LineIndex other{meeting.u + off(), meeting.v + off()};
            const int apart = *rc::gen::element(-20, -1, 0, 0, 0, 1, 20);
            if (*rc::gen::arbitrary<bool>())
                fill(b, denseB, other, to + apart, to + apart + length());
            else
                fill(b, denseB, other, from - apart - length(), from - apart);
            for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
                const int begin = *rc::gen::inRange(0, 500), end = begin + length();
                if (*rc::gen::arbitrary<bool>())
                    fill(a, denseA, anyLine(), begin, end);
                else
                    fill(b, denseB, anyLine(), begin, end);
            }
            const SpatialRelation expected = denseRelation(grid, denseA, denseB);
            RC_ASSERT(*relation(a.snapshot(), b.snapshot()) == expected);
            RC_ASSERT(*relation(b.snapshot(), a.snapshot()) == expected);
            seen.add(expected);
        }));
        QVERIFY(seen.all());
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

    /// Where both objects are, the first one's property is set; a third property is elsewhere.
    void propertiesOfOneVolumeRelateByTheirVoxels() {
        int adjacent = 0, separate = 0;
        QVERIFY(rc::check("relation of two properties over several bricks against pairs of voxels", [&] {
            const auto size = [] { return *rc::gen::inRange(18, 41); };
            Objects objects({size(), size(), size()});
            DenseVoxels all = objects.a;
            all.each([&](glm::ivec3 voxel) {
                PropertyIndex& second = objects.b.at(voxel);
                if (all.at(voxel) != airProperty)
                    second = airProperty;
                else if (second != airProperty)
                    all.at(voxel) = aluminium;
            });
            for (int i = 0; i < 3; ++i) {
                PropertyIndex& here = all.properties[*rc::gen::inRange(std::size_t{0}, all.total())];
                if (here == airProperty) here = part;
            }
            RunVolume volume = volumeOf(cubeGrid(all.count, anyAxis()), all);
            const VolumeSnapshot snapshot = volume.snapshot();
            const SpatialRelation expected = denseRelation(objects.a, objects.b);
            RC_ASSERT(relation(snapshot, wax, aluminium) == expected);
            RC_ASSERT(relation(snapshot, aluminium, wax) == expected);
            ++(expected == SpatialRelation::adjacent ? adjacent : separate);
        }));
        QVERIFY(adjacent > 0 && separate > 0);
    }

    void volumesOnDifferentGridsAreRefused() {
        RunVolume a = emptyVolume(cubeGrid({2, 2, 2})), b = emptyVolume(cubeGrid({2, 2, 3}));
        QVERIFY(relation(a.snapshot(), b.snapshot()).error().code == ErrorCode::argumentInvalid);
    }
};

BURIN_TEST(TestRelation, NoApplication)

} // namespace burin::tst_relation

#include "tst_relation.moc"
