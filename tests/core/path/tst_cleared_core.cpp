// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/height_map.h"
#include "tests/core/tool/fixed_tools.h"
#include "tests/test_program.h"

#include <QTest>

#include <cmath>

namespace burin::tst_cleared_core {

namespace {

const Box stock{{0.0, 0.0, 0.0}, {40.0, 30.0, 10.0}};

HeightMap heightsFor(const Cutter& cutter) {
    return {stock, pieces(cutter), flutePieces(cutter).size(), cutter.hollow()};
}

} // namespace

/// The height map of links knows that a core stands in a hollow tool.
class ClearedCoreTest : public QObject {
    Q_OBJECT
private slots:
    /// After a plunge of 3 mm a rapid may not go down over the core; once the ring has passed, it may.
    void theCoreCountsAsStanding() {
        const Cutter cutter = cutters::annular();
        HeightMap map = heightsFor(cutter);
        const glm::dvec3 tip(12.0, 15.0, 7.0);
        map.cut(tip + glm::dvec3(0.0, 0.0, 5.0), tip);
        QCOMPARE(map.heightAt(tip), 10.0);
        QVERIFY(map.heightAt(tip + glm::dvec3(5.0, 0.0, 0.0)) < 7.01);
        QCOMPARE(map.freeHeight(12.0, 15.0), 10.0);
        map.cut(tip, tip + glm::dvec3(16.0, 0.0, 0.0));
        QVERIFY(map.heightAt(tip) < 7.01 && map.heightAt(tip + glm::dvec3(8.0, 0.0, 0.0)) < 7.01);
        Cutter full = cutter;
        full.solid = nullptr;
        HeightMap filled = heightsFor(full);
        filled.cut(tip, tip);
        QVERIFY(filled.heightAt(tip) < 7.01);
    }

    /// A tip that is hollow for 2 mm leaves a core of that height at most.
    void aShallowHollowLeavesAShallowCore() {
        Cutter cutter = cutters::annular(20.0);
        ToolSolid solid = *cutter.solid;
        solid.hollowDepth = 2.0;
        cutter.solid = std::make_shared<const ToolSolid>(std::move(solid));
        HeightMap map = heightsFor(cutter);
        map.cut({12.0, 15.0, 12.0}, {12.0, 15.0, 3.0});
        QVERIFY2(std::abs(map.heightAt({12.0, 15.0, 0.0}) - 5.0) < 1e-9,
                 qPrintable(QString::number(map.heightAt({12.0, 15.0, 0.0}))));
        QVERIFY(std::abs(map.heightAt({17.0, 15.0, 0.0}) - 3.0) < 1e-9);
    }
};

BURIN_TEST(ClearedCoreTest, NoApplication)

} // namespace burin::tst_cleared_core

#include "tst_cleared_core.moc"
