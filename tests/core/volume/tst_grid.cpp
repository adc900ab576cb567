// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/grid.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>

namespace burin::tst_grid {

class TestGrid : public QObject {
    Q_OBJECT

private slots:
    void sizesOutOfRangeAreRefused() {
        QVERIFY(Grid::make(glm::dvec3(0), 0.0, {1, 1, 1}).error().code == ErrorCode::argumentInvalid);
        QVERIFY(Grid::make(glm::dvec3(0), std::nan(""), {1, 1, 1}).error().code == ErrorCode::argumentInvalid);
        QVERIFY(Grid::make({0, HUGE_VAL, 0}, 1.0, {1, 1, 1}).error().code == ErrorCode::argumentInvalid);
        QVERIFY(Grid::make(glm::dvec3(0), 1.0, {1, 0, 1}).error().code == ErrorCode::volumeTooLarge);
        QVERIFY(Grid::make(glm::dvec3(0), 1.0, {1, 1, 32769}).error().code == ErrorCode::volumeTooLarge);
        QVERIFY(Grid::make(glm::dvec3(0), 1.0, {1, 1, 32768}));
    }

    void axesFollowByCyclicExchange_data() {
        QTest::addColumn<int>("axis");
        QTest::addColumn<int>("u");
        QTest::addColumn<int>("v");
        QTest::newRow("along x") << 0 << 1 << 2;
        QTest::newRow("along y") << 1 << 2 << 0;
        QTest::newRow("along z") << 2 << 0 << 1;
    }
    void axesFollowByCyclicExchange() {
        QFETCH(int, axis);
        QFETCH(int, u);
        QFETCH(int, v);
        const Grid grid = *Grid::make({10, 20, 30}, 0.5, {3, 4, 5}, static_cast<RunAxis>(axis));
        QCOMPARE(grid.axisOfU(), u);
        QCOMPARE(grid.axisOfV(), v);
        QCOMPARE(grid.voxelsPerLine(), grid.count()[axis]);
        const VoxelIndex voxel{1, 2, 3};
        const std::array<int, 3> components{voxel.i, voxel.j, voxel.k};
        QVERIFY((grid.lineOf(voxel) ==
                 LineIndex{components[static_cast<std::size_t>(u)], components[static_cast<std::size_t>(v)]}));
        QCOMPARE(grid.alongOf(voxel), components[static_cast<std::size_t>(axis)]);
        QVERIFY(grid.voxel(grid.lineOf(voxel), grid.alongOf(voxel)) == voxel);
        QCOMPARE(grid.lineCentre({1, 2}).x, 10.0 * (u + 1) + 0.75);
        QCOMPARE(grid.lineCentre({1, 2}).y, 10.0 * (v + 1) + 1.25);
    }

    void placesAlongALineRoundToTheNearestUnitWithinTheGrid() {
        const Grid grid = *Grid::make({0, 0, -5}, 0.5, {1, 1, 20});
        QCOMPARE(grid.toRunPosition(-5.0), RunPosition{0});
        QCOMPARE(grid.toRunPosition(0.0), RunPosition{2560});
        QCOMPARE(grid.toRunPosition(-5.0 + 0.5 * 1.49 / 256), RunPosition{1});
        QCOMPARE(grid.toRunPosition(-5.0 + 0.5 * 1.5 / 256), RunPosition{2});
        QCOMPARE(grid.toRunPosition(-1e300), RunPosition{0});
        QCOMPARE(grid.toRunPosition(1e300), grid.lineEnd());
        QCOMPARE(grid.toRunPosition(std::nan("")), RunPosition{0});
        for (RunPosition position = 0; position <= grid.lineEnd(); position += 7)
            QCOMPARE(grid.toRunPosition(grid.toMillimetres(position)), position);
    }
};

BURIN_TEST(TestGrid, NoApplication)

} // namespace burin::tst_grid

#include "tst_grid.moc"
