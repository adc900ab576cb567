// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "tests/core/haptics/tip_proxy.h"
#include "tests/core/passes/plan_stage.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_finishing {

using namespace burin::test;

class OperatorFinishingTest final : public QObject {
    Q_OBJECT

private slots:
    void finishingAimsBelowThePartEverywhere();
    void finishingStaysAboveTheFloorAndNearThePart();
    void finishingLeavesLittleOnThePart();
    void crosswisePassesStayOnSteepWalls();
    void crosswisePassesSmoothTheWalls();
    void crosswisePassesNeedASteepPlace();
    void finishingWithoutRoughingGoesNoDeeperThanTheFlutes();
    void theToolFollowsTheHandOverSteps_data();
    void theToolFollowsTheHandOverSteps();
    void aTurnAtARimPullsNoToolOverIt();
    void finishingIsEnteredDownARamp();
    void finishingSinksIntoAFullPocketInRamps();
    void finishingTakesAWallInSteps();
};

void OperatorFinishingTest::finishingAimsBelowThePartEverywhere() {
    WorkpieceHeights heights(mouseStock, shankedBallTool().cutter);
    QVERIFY(planRoughing(mouse, shankedBallTool(), roughingRequest(), heights));
    const auto points = planFinishing(mouse, shankedBallTool(), finishingRequest(mouse.box()), heights);
    QVERIFY(points);
    int over = 0, pressing = 0;
    for (const IntentPoint& point : *points) {
        const double resting = mouse.restingTip(point.tip.x, point.tip.y);
        // Near the wall, at its foot, the hand presses less, otherwise it would leave the tool there.
        if (resting < 14.0 || point.tip.z > mouseStock.high.z) continue;
        ++over;
        pressing += std::abs(resting - 2.0 - point.tip.z) < 5e-3 ? 1 : 0;
    }
    QVERIFY(over > 20000);
    // Once per row it crosses the rim of the wall it climbed.
    QVERIFY2(pressing + over / 50 >= over, qPrintable(QString("%1 of %2").arg(pressing).arg(over)));
}

void OperatorFinishingTest::finishingStaysAboveTheFloorAndNearThePart() {
    WorkpieceHeights heights(mouseStock, shankedBallTool().cutter);
    QVERIFY(planRoughing(mouse, shankedBallTool(), roughingRequest(), heights));
    const auto points = planFinishing(mouse, shankedBallTool(), finishingRequest(mouse.box()), heights);
    QVERIFY(points);
    for (const IntentPoint& point : *points) {
        QVERIFY(point.tip.z >= 0.0);
        const double besideAxis = std::hypot(std::max(0.0, std::abs(point.tip.x) - 27.5), point.tip.y);
        QVERIFY(besideAxis <= 27.5 + 3.0 + 1.5 + 0.5);
    }
    QVERIFY(points->front().tip.z > mouseStock.high.z);
    QVERIFY(points->back().tip.z > mouseStock.high.z);
}

void OperatorFinishingTest::finishingLeavesLittleOnThePart() {
    WorkpieceHeights heights(mouseStock, shankedBallTool().cutter);
    const auto roughing = planRoughing(mouse, shankedBallTool(), roughingRequest(), heights);
    const auto finishing = planFinishing(mouse, shankedBallTool(), finishingRequest(mouse.box()), heights);
    QVERIFY(roughing && finishing);
    StockRaster stock(mouseStock);
    const auto visit = [&](const glm::dvec3& aim) {
        stock.cutBall({aim.x, aim.y, std::max(aim.z, mouse.restingTip(aim.x, aim.y))}, 3.0);
    };
    follow(roughing->points, visit);
    follow(*finishing, visit);
    // Within 20 mm of the axis the part's slope is below 47 degrees: scallops of 0.4 mm passes are hundredths of a mm.
    const double most = stock.highestAbove(
        [](double x, double y) {
            const double square = 27.5 * 27.5 - std::pow(std::max(0.0, std::abs(x) - 27.5), 2) - y * y;
            return square > 27.5 * 27.5 - 400.0 ? 5.0 + std::sqrt(square) : 100.0;
        },
        0.0);
    QVERIFY2(most < 0.05 && most > -0.01, qPrintable(QString::number(most)));
}

void OperatorFinishingTest::crosswisePassesStayOnSteepWalls() {
    LyingCapsule part = mouse;
    part.answerGradients();
    WorkpieceHeights heights(mouseStock, shankedBallTool().cutter);
    QVERIFY(planRoughing(part, shankedBallTool(), roughingRequest(), heights));
    QVERIFY(planFinishing(part, shankedBallTool(), finishingRequest(part.box()), heights));
    const auto points = planCrosswiseFinishing(part, shankedBallTool(), finishingRequest(part.box()), heights);
    QVERIFY(points && points->size() > 5000);
    int pressing = 0, cutting = 0, lifts = 0;
    for (std::size_t i = 1; i < points->size(); ++i) {
        const glm::dvec3& aim = (*points)[i].tip;
        QVERIFY(aim.z >= 0.0);
        const bool travels = aim.z > mouseStock.high.z;
        lifts += travels && (*points)[i - 1].tip.z <= mouseStock.high.z ? 1 : 0;
        if (travels || (*points)[i - 1].tip.z > mouseStock.high.z) continue;
        ++cutting;
        pressing += part.at(aim).clearance < -1.5 ? 1 : 0;
        // A ball rests at 45 degrees across the rows where the horizontal distance of its centre from the ridge equals
        // its height above it; a row's width and the press, perpendicular to the surface, add 2 mm.
        const double beside = std::abs(aim.y) * (30.5 / 28.5);
        const double along = std::max(0.0, std::abs(aim.x) - 27.5) * (30.5 / 28.5);
        const double above = std::sqrt(std::max(0.0, 30.5 * 30.5 - beside * beside - along * along));
        QVERIFY2(beside > above - 3.0, qPrintable(QString("%1 %2 %3").arg(aim.x).arg(aim.y).arg(aim.z)));
    }
    QVERIFY2(pressing > cutting * 9 / 10, qPrintable(QString("%1 of %2").arg(pressing).arg(cutting)));
    QVERIFY2(lifts <= 4, qPrintable(QString::number(lifts))); // two walls, not one lift per pass
    QVERIFY(points->front().tip.z > mouseStock.high.z && points->back().tip.z > mouseStock.high.z);
}

void OperatorFinishingTest::crosswisePassesSmoothTheWalls() {
    LyingCapsule part = mouse;
    part.answerGradients();
    WorkpieceHeights heights(mouseStock, shankedBallTool().cutter);
    QVERIFY(planRoughing(part, shankedBallTool(), roughingRequest(), heights));
    const auto rows = planFinishing(part, shankedBallTool(), finishingRequest(part.box()), heights);
    const auto crosswise = planCrosswiseFinishing(part, shankedBallTool(), finishingRequest(part.box()), heights);
    QVERIFY(rows && crosswise);
    // Points on the wall, up to 80 degrees: the distance to the nearest ball that was rolled along it.
    std::vector<glm::dvec3> walls;
    for (double x = -20.0; x <= 20.0; x += 1.3)
        for (double angle = 50.0; angle <= 80.0; angle += 1.1)
            walls.push_back({x, 27.5 * std::sin(glm::radians(angle)), 5.0 + 27.5 * std::cos(glm::radians(angle))});
    const auto leftOver = [&](const std::vector<IntentPoint>& points, std::vector<double>& left) {
        follow(points, [&](const glm::dvec3& aim) {
            glm::dvec3 centre = aim + glm::dvec3(0.0, 0.0, 3.0);
            if (std::abs(centre.x) > 24.0 || centre.z < 4.0) return;
            const glm::dvec2 across(centre.y, centre.z - 5.0); // offset perpendicular to the capsule
            const glm::dvec2 held = across * std::max(1.0, 30.5 / glm::length(across));
            centre = {centre.x, held.x, held.y + 5.0};
            for (std::size_t i = 0; i < walls.size(); ++i) {
                if (std::abs(walls[i].x - centre.x) < 2.0)
                    left[i] = std::min(left[i], glm::distance(walls[i], centre) - 3.0);
            }
        });
    };
    std::vector<double> left(walls.size(), 1e9);
    leftOver(*rows, left);
    const double byRows = *std::max_element(left.begin(), left.end());
    leftOver(*crosswise, left);
    const double byBoth = *std::max_element(left.begin(), left.end());
    qInfo("left on the wall: %.3f mm after the rows, %.3f mm after the crosswise passes", byRows, byBoth);
    QVERIFY(byRows > 0.05);
    QVERIFY(byBoth < 0.03);
}

void OperatorFinishingTest::crosswisePassesNeedASteepPlace() {
    class Slope final : public AnalyticField { // 40 degrees across the rows
    public:
        using AnalyticField::AnalyticField;
        double distance(const glm::dvec3& c) const noexcept override {
            return glm::dot(c, {0.0, std::sin(glm::radians(40.0)), std::cos(glm::radians(40.0))}) - 20.0;
        }
    };
    Slope slope(3.0);
    slope.answerGradients();
    WorkpieceHeights heights({{-10, -10, 0}, {10, 10, 40}}, shankedBallTool().cutter);
    FinishingRequest request = finishingRequest({{-8, -8, 10}, {8, 8, 35}});
    const auto points = planCrosswiseFinishing(slope, shankedBallTool(), request, heights);
    QVERIFY(points && points->empty());
    request.crosswiseStepOver = -1.0;
    QCOMPARE(planCrosswiseFinishing(slope, shankedBallTool(), request, heights).error().subject,
             std::string("crosswise step-over"));
}

void OperatorFinishingTest::finishingWithoutRoughingGoesNoDeeperThanTheFlutes() {
    const Tool tool = shankedBallTool(6.0, 9.0);
    WorkpieceHeights heights(mouseStock, tool.cutter);
    FinishingRequest request = finishingRequest(mouse.box());
    request.stepOver = 2.0;
    const auto points = planFinishing(mouse, tool, request, heights);
    QVERIFY(points);
    StockRaster stock(mouseStock);
    double most = 0.0, lowest = 1e9;
    follow(*points, [&](const glm::dvec3& aim) {
        const glm::dvec3 tip(aim.x, aim.y, std::max(aim.z, mouse.restingTip(aim.x, aim.y)));
        lowest = std::min(lowest, tip.z);
        most = std::max(most, stock.highestAround(tip, 2.4));
        stock.cutBall(tip, 3.0, 9.0);
    });
    QVERIFY2(most <= 9.0, qPrintable(QString::number(most)));
    QVERIFY2(lowest < mouseStock.high.z - 7.0, qPrintable(QString::number(lowest))); // but that deep it goes
}

void OperatorFinishingTest::theToolFollowsTheHandOverSteps_data() {
    QTest::addColumn<double>("step");
    QTest::newRow("a tenth") << 0.1;
    QTest::newRow("a wall") << 12.0;
}

/// A plateau on a plate: a hand that aims below the plateau while the tool is still to its side would leave the tool
/// there, as the wall is nearer than the top. The loop's own proxy follows the hand.
void OperatorFinishingTest::theToolFollowsTheHandOverSteps() {
    QFETCH(double, step);
    Blocks part(3.0, {{{-30, -20, 0}, {30, 20, 6}}, {{-12, -9, 0}, {15, 11, 6.0 + step}}});
    part.answerGradients();
    const Box box{{-30, -20, 0}, {30, 20, 6.0 + step}};
    WorkpieceHeights heights({box.low - glm::dvec3(4.0, 4.0, 0.0), box.high + glm::dvec3(4.0)},
                             shankedBallTool().cutter);
    QVERIFY(planRoughing(part, shankedBallTool(), roughingRequest(), heights));
    FinishingRequest request = finishingRequest(box);
    request.stepOver = 2.0;
    const auto points = planFinishing(part, shankedBallTool(), request, heights);
    QVERIFY(points && points->size() > 1000);
    TipProxy proxy(part);
    glm::dvec3 tip = points->front().tip;
    double farthest = 0.0;
    glm::dvec3 where(0.0);
    follow(*points, [&](const glm::dvec3& hand) {
        tip = proxy.advance(tip, hand, 0.0, 10.0).tip;
        const double left = glm::distance(tip, hand);
        if (left > farthest) where = hand;
        farthest = std::max(farthest, left);
    });
    // By the press depth, and by a sample's distance where it slides up a wall.
    QVERIFY2(farthest < request.press + 0.5,
             qPrintable(QString("%1 at %2 %3 %4").arg(farthest).arg(where.x).arg(where.y).arg(where.z)));
}

/// Only the upper part of a block, with a flat mill: its tips are those of a point over the block grown by the mill.
/// The hand is fast, rounds its turns, and has a tremor of two tenths of a millimetre. Once the tool is over the rim it
/// would stay at the wall for a whole pass when the hand goes back.
void OperatorFinishingTest::aTurnAtARimPullsNoToolOverIt() {
    constexpr double radius = 5.0, top = 10.0;
    Tool mill = shankedBallTool(2.0 * radius);
    mill.cutter.type = CutterType::flat;
    mill.cutter.cornerRadius = 0.0;
    const Box box{{-15, -8, 0}, {15, 8, top}};
    constexpr double error = 0.02; // of a field: the last position of a pass is still on the block
    const glm::dvec3 further(radius + error, radius + error, 0.0);
    Blocks grown(0.0, {{box.low - further, box.high + further}});
    grown.answerGradients();
    WorkpieceHeights heights({box.low - glm::dvec3(9.0, 9.0, 0.0), box.high + glm::dvec3(9.0, 9.0, 0.5)}, mill.cutter);
    FinishingRequest request = finishingRequest(box);
    request.stepOver = 1.0;
    request.floor = 8.0;
    request.floorMargin = 0.0;
    request.speeds = fastestHand;
    const auto points = planFinishing(grown, mill, request, heights);
    QVERIFY(points && points->size() > 1000);
    const auto motion = IntentMotion::make(*points, MotionLimits{});
    QVERIFY(motion);
    TipProxy proxy(grown);
    glm::dvec3 tip = points->front().tip;
    int ticks = 0, behind = 0;
    double left = 1e9, right = -1e9;
    for (double time = 0.0; time < motion->duration(); time += 0.001) {
        const double tremor = 0.2 * std::sin(2.0 * pi * 10.0 * time), other = 0.2 * std::sin(2.0 * pi * 11.3 * time);
        const glm::dvec3 hand = motion->at(time).position + glm::dvec3(tremor, other, other);
        tip = proxy.advance(tip, hand, 0.0, 10.0).tip;
        ++ticks;
        behind += glm::distance(glm::dvec2(tip), glm::dvec2(hand)) > 1.0 ? 1 : 0;
        if (tip.z > top + 0.5) continue; // moving between cuts
        left = std::min(left, tip.x);
        right = std::max(right, tip.x);
    }
    QVERIFY2(behind < 0.01 * ticks, qPrintable(QString("%1 of %2 ticks").arg(behind).arg(ticks)));
    QVERIFY(left - radius < box.low.x && right + radius > box.high.x); // all of the top is covered
}

/// A plate with stock on it: no pass enters the stock straight from above.
void OperatorFinishingTest::finishingIsEnteredDownARamp() {
    const Blocks part(3.0, {{{-30, -20, 0}, {30, 20, 6}}});
    const Box stockBox{{-40, -30, 0}, {40, 30, 7}};
    WorkpieceHeights heights(stockBox, shankedBallTool().cutter);
    FinishingRequest request = finishingRequest({{-30, -20, 0}, {30, 20, 6}});
    request.stepOver = 2.0;
    request.floor = 6.0;
    const auto points = planFinishing(part, shankedBallTool(), request, heights);
    QVERIFY(points && points->size() > 500);
    const auto [deepest, lowest] = deepestPlunge(*points, stockBox, 6.0);
    QCOMPARE(lowest, 6.0);
    QVERIFY2(deepest < 0.2, qPrintable(QString::number(deepest))); // straight down: 1 mm
}

/// A pocket of 16 mm that roughing has left filled: rows lead over its rim into it.
void OperatorFinishingTest::finishingSinksIntoAFullPocketInRamps() {
    const Blocks part(3.0, {{{-30, -20, 0}, {-8, 20, 8}},
                            {{8, -20, 0}, {30, 20, 8}},
                            {{-8, -20, 0}, {8, -8, 8}},
                            {{-8, 8, 0}, {8, 20, 8}}});
    const Box stockBox{{-30, -20, 0}, {30, 20, 8.5}};
    FinishingRequest request = finishingRequest({{-30, -20, 0}, {30, 20, 8}});
    request.stepOver = 1.0;
    request.press = 0.0;
    request.deepestBelow = 1.0;
    WorkpieceHeights heights(stockBox, shankedBallTool().cutter);
    const auto points = planFinishing(part, shankedBallTool(), request, heights);
    QVERIFY(points);
    const double deepest = deepestPlunge(*points, stockBox, -1e9).deepest;
    QVERIFY2(deepest < 1.3, qPrintable(QString::number(deepest))); // straight down: 8 mm
    const bool cleared = std::ranges::any_of(*points, [](const IntentPoint& point) {
        return point.tip.z < 0.01 && std::abs(point.tip.x) < 4.0 && std::abs(point.tip.y) < 4.0;
    });
    QVERIFY(cleared);
}

/// Walls with a millimetre of stock on them, higher than a pass may cut.
void OperatorFinishingTest::finishingTakesAWallInSteps() {
    const Box block{{-10, -10, 0}, {10, 10, 12}}, stockBox{{-11, -11, 0}, {11, 11, 12.5}};
    const Blocks part(3.0, {block});
    FinishingRequest request = finishingRequest(block);
    request.stepOver = 1.0;
    request.press = 0.0;
    request.deepest = 3.0;
    WorkpieceHeights heights(stockBox, shankedBallTool().cutter);
    const auto points = planFinishing(part, shankedBallTool(), request, heights);
    QVERIFY(points);
    StockRaster stock(stockBox);
    double tallest = 0.0, lowest = 1e9;
    const double rim = 2.4, rise = 3.0 - std::sqrt(9.0 - rim * rim); // of the ball
    follow(*points, [&](const glm::dvec3& tip) {
        tallest = std::max(tallest, stock.highestAround(tip, rim) - rise);
        stock.cutBall(tip, 3.0);
        lowest = std::min(lowest, tip.z);
    });
    QVERIFY2(tallest < 3.0 + 0.5, qPrintable(QString::number(tallest))); // in one pass: 12 mm
    QVERIFY(std::abs(lowest) < 0.01);
}

BURIN_TEST(OperatorFinishingTest, NoApplication)

} // namespace burin::tst_finishing

#include "tst_finishing.moc"
