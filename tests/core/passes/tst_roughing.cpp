// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/passes/plan_stage.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_roughing {

using namespace burin::test;

class OperatorRoughingTest final : public QObject {
    Q_OBJECT

private slots:
    void aTipComingDownStopsWhereTheFormulaSays();
    void aTipComingDownStopsAboveAnOverhang();
    void roughingKeepsItsAllowanceAllTheWay();
    void levelsAreNoDeeperThanAskedAndEndAtTheBottom_data();
    void levelsAreNoDeeperThanAskedAndEndAtTheBottom();
    void roughingLeavesNoMoreThanALevelAboveThePart();
    void rowsEnterFromBesideTheStock();
    void aPitIsEnteredDownARamp();
    void shankNeverReachesStandingStock_data();
    void shankNeverReachesStandingStock();
    void rowsPassStandingStockOnlyWithRoomForTheShank();
    void pocketIsRoughedFromAbove();
};

void OperatorRoughingTest::aTipComingDownStopsWhereTheFormulaSays() {
    for (double x = -60.0; x <= 60.0; x += 1.7)
        for (double y = -34.0; y <= 34.0; y += 1.3)
            QVERIFY(std::abs(lowestFeasibleHeight(mouse, x, y, 0.0, 40.0, 0.0) - mouse.restingTip(x, y)) < 2e-3);
    QVERIFY(lowestFeasibleHeight(mouse, 0.0, 0.0, 0.0, 20.0, 0.0) > 1e9); // inside the part from the start
    QCOMPARE(lowestFeasibleHeight(mouse, 90.0, 0.0, 0.0, 40.0, -3.0), -3.0);
}

void OperatorRoughingTest::aTipComingDownStopsAboveAnOverhang() {
    class Plate final : public AnalyticField { // a plate at z = 20 to 21, free below
    public:
        using AnalyticField::AnalyticField;
        double distance(const glm::dvec3& c) const noexcept override { return std::abs(c.z - 20.5) - 0.5; }
    };
    const Plate plate(0.5);
    QVERIFY(std::abs(lowestFeasibleHeight(plate, 0.0, 0.0, 0.25, 40.0, 0.0) - 21.25) < 2e-3);
}

void OperatorRoughingTest::roughingKeepsItsAllowanceAllTheWay() {
    WorkpieceHeights heights(mouseStock, shankedBallTool().cutter);
    const Result<RoughingPlan> plan = planRoughing(mouse, shankedBallTool(), roughingRequest(), heights);
    QVERIFY(plan);
    QVERIFY(plan->points.size() > 100);
    double least = 1e9;
    follow(plan->points, [&](const glm::dvec3& tip) { least = std::min(least, mouse.at(tip).clearance); });
    QVERIFY2(least >= 0.5, qPrintable(QString::number(least)));
    QVERIFY2(least <= 0.7, qPrintable(QString::number(least))); // and gets that close
}

void OperatorRoughingTest::levelsAreNoDeeperThanAskedAndEndAtTheBottom_data() {
    QTest::addColumn<double>("asked");
    QTest::addColumn<double>("toolDepth");
    QTest::addColumn<double>("flutes");
    QTest::newRow("as asked") << 7.0 << 22.0 << 22.0;
    QTest::newRow("what the tool may cut") << 7.0 << 2.0 << 22.0;
    QTest::newRow("short flutes") << 50.0 << 50.0 << 6.0;
    QTest::newRow("left to Burin") << 0.0 << 0.0 << 22.0;
}

void OperatorRoughingTest::levelsAreNoDeeperThanAskedAndEndAtTheBottom() {
    QFETCH(double, asked);
    QFETCH(double, toolDepth);
    QFETCH(double, flutes);
    Tool tool = shankedBallTool(6.0, flutes);
    tool.maximumDepthOfCut = toolDepth;
    RoughingRequest request = roughingRequest(0.25);
    request.levelDepth = asked;
    WorkpieceHeights heights(mouseStock, tool.cutter);
    const Result<RoughingPlan> plan = planRoughing(mouse, tool, request, heights);
    QVERIFY(plan);
    double above = mouseStock.high.z;
    for (const double level : plan->levels) {
        QVERIFY(above - level <= flutes + 1e-9);
        QVERIFY(asked == 0.0 || above - level <= asked + 1e-9);
        QVERIFY(toolDepth == 0.0 || above - level <= toolDepth + 1e-9);
        QVERIFY(above - level > 0.0);
        above = level;
    }
    QCOMPARE(plan->levels.back(), 0.25);
}

void OperatorRoughingTest::roughingLeavesNoMoreThanALevelAboveThePart() {
    RoughingRequest request = roughingRequest();
    request.levelDepth = 7.0;
    WorkpieceHeights heights(mouseStock, shankedBallTool().cutter);
    const Result<RoughingPlan> plan = planRoughing(mouse, shankedBallTool(), request, heights);
    QVERIFY(plan);
    StockRaster stock(mouseStock);
    follow(plan->points, [&](const glm::dvec3& tip) { stock.cutBall(tip, 3.0); });
    // Where the part's slope is below 47 degrees: a level of at most 7 mm, scallops of 1.02 mm between rows 4.5 mm
    // apart, the allowance measured vertically, and the remains at the round flank of a row's end.
    const double most = stock.highestAbove(
        [](double x, double y) {
            const double square = std::pow(std::max(0.0, std::abs(x) - 27.5), 2) + y * y;
            return square < 400.0 ? mouse.restingTip(x, y) : 100.0;
        },
        1.0);
    QVERIFY2(most < 7.0 + 1.02 + 0.9 + 1.0, qPrintable(QString::number(most)));
    QVERIFY2(most > 0.5, qPrintable(QString::number(most)));
    const double onFloor = stock.highestAbove(
        [](double x, double y) { return std::hypot(std::max(0.0, std::abs(x) - 27.5), y) > 32.5 ? 0.0 : 100.0; }, 0.0);
    QVERIFY2(onFloor < 1.6, qPrintable(QString::number(onFloor))); // the floor around the part has only scallops
}

void OperatorRoughingTest::rowsEnterFromBesideTheStock() {
    WorkpieceHeights heights(mouseStock, shankedBallTool().cutter);
    const Result<RoughingPlan> plan = planRoughing(mouse, shankedBallTool(), roughingRequest(), heights);
    QVERIFY(plan);
    StockRaster stock(mouseStock);
    double deepestPlunge = 0.0;
    glm::dvec3 before = plan->points.front().tip;
    follow(plan->points, [&](const glm::dvec3& tip) {
        const bool down = tip.z < before.z && std::abs(tip.x - before.x) + std::abs(tip.y - before.y) < 1e-9;
        if (down) deepestPlunge = std::max(deepestPlunge, stock.highestAround(tip, 1.0));
        stock.cutBall(tip, 3.0);
        before = tip;
    });
    QVERIFY2(deepestPlunge < 1.0, qPrintable(QString::number(deepestPlunge)));
}

/// Between walls there is no entry from the side.
void OperatorRoughingTest::aPitIsEnteredDownARamp() {
    const std::vector<Box> walls{{{-40, -30, 0}, {-22, 30, 12}},
                                 {{22, -30, 0}, {40, 30, 12}},
                                 {{-40, -30, 0}, {40, -14, 12}},
                                 {{-40, 14, 0}, {40, 30, 12}}};
    const Blocks part(3.0, walls);
    const Box stockBox{{-40, -30, 0}, {40, 30, 12}};
    WorkpieceHeights heights(stockBox, shankedBallTool().cutter);
    RoughingRequest request = roughingRequest();
    request.levelDepth = 3.0;
    const Result<RoughingPlan> plan = planRoughing(part, shankedBallTool(), request, heights);
    QVERIFY(plan);
    const auto [deepest, lowest] = deepestPlunge(plan->points, stockBox, 0.0);
    QCOMPARE(lowest, 0.0);
    QVERIFY2(deepest < 0.4, qPrintable(QString::number(deepest))); // straight down: 3 mm, a level
}

void OperatorRoughingTest::shankNeverReachesStandingStock_data() {
    QTest::addColumn<double>("flutes");
    QTest::newRow("long flutes") << 22.0;
    QTest::newRow("short flutes") << 9.0;
}

void OperatorRoughingTest::shankNeverReachesStandingStock() {
    QFETCH(double, flutes);
    const Tool tool = shankedBallTool(6.0, flutes);
    MillingRequest request;
    request.stock = mouseStock;
    request.roughing = roughingRequest();
    request.finishing = finishingRequest(mouse.box());
    request.finishing.stepOver = 1.0;
    const Result<MillingPlan> plan = planMilling(mouse, tool, request);
    QVERIFY(plan);
    StockRaster stock(mouseStock);
    double most = 0.0, beside = 0.0;
    const auto visit = [&](const glm::dvec3& aim) {
        const glm::dvec3 tip(aim.x, aim.y, std::max(aim.z, mouse.restingTip(aim.x, aim.y)));
        beside = std::max(beside, stock.highestAround(tip, 3.7));
        // Columns under the rim of the shank may be on different sides of it in the two rasters.
        most = std::max(most, stock.highestAround(tip, 2.9 - 0.5));
        stock.cutBall(tip, 3.0, flutes);
    };
    follow(plan->roughing, visit);
    QVERIFY2(most <= flutes, qPrintable(QString::number(most)));
    follow(plan->finishing, visit);
    QVERIFY2(most <= flutes, qPrintable(QString::number(most)));
    QVERIFY2(beside > 5.0, qPrintable(QString::number(beside))); // it did work next to tall stock
}

void OperatorRoughingTest::rowsPassStandingStockOnlyWithRoomForTheShank() {
    // A tall wall along x at positions where rows at every level pass it with no clearance to spare.
    for (double face = -2.0; face <= 2.0; face += 0.25) {
        const Blocks wall(3.0, {{{-40, -40, 0}, {40, face, 33}}});
        const Box stock{{-40, -40, -5}, {40, 25, 38}};
        WorkpieceHeights heights(stock, shankedBallTool().cutter);
        const auto plan = planRoughing(wall, shankedBallTool(), roughingRequest(), heights);
        QVERIFY(plan);
        StockRaster raster(stock);
        double most = 0.0, least = 1e9;
        follow(plan->points, [&](const glm::dvec3& tip) {
            least = std::min(least, wall.at(tip).clearance);
            most = std::max(most, raster.highestAround(tip, 2.9)); // even with the hand a quarter of a millimetre off
            raster.cutBall(tip, 3.0, 22.0);
        });
        QVERIFY2(most <= 22.0, qPrintable(QString("%1 at %2").arg(most).arg(face)));
        QVERIFY2(least >= 0.5, qPrintable(QString("%1 at %2").arg(least).arg(face)));
    }
}

void OperatorRoughingTest::pocketIsRoughedFromAbove() {
    // A frame of four walls around a pocket of 30 x 30 mm, 12 mm deep.
    const std::vector<Box> walls = {{{-25, -25, 0}, {-15, 25, 12}},
                                    {{15, -25, 0}, {25, 25, 12}},
                                    {{-15, -25, 0}, {15, -15, 12}},
                                    {{-15, 15, 0}, {15, 25, 12}}};
    const Blocks frame(3.0, walls);
    const Box stock{{-30, -30, -5}, {30, 30, 15}};
    WorkpieceHeights heights(stock, shankedBallTool().cutter);
    const auto plan = planRoughing(frame, shankedBallTool(), roughingRequest(), heights);
    QVERIFY(plan);
    StockRaster raster(stock);
    double least = 1e9;
    follow(plan->points, [&](const glm::dvec3& tip) {
        least = std::min(least, frame.at(tip).clearance);
        raster.cutBall(tip, 3.0);
    });
    QVERIFY2(least >= 0.5, qPrintable(QString::number(least)));
    const double inPocket = raster.highestAbove(
        [](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 10.0 ? 0.0 : 100.0; }, 0.0);
    QVERIFY2(inPocket < 1.5, qPrintable(QString::number(inPocket)));
}

BURIN_TEST(OperatorRoughingTest, NoApplication)

} // namespace burin::tst_roughing

#include "tst_roughing.moc"
