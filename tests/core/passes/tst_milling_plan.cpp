// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/scripted_intents.h"
#include "tests/core/passes/plan_stage.h"
#include "tests/long_run.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_milling_plan {

using namespace burin::test;

class OperatorPlanTest final : public QObject {
    Q_OBJECT

private slots:
    void whatIsRoughedInAShortTimeIsFinished_data();
    void whatIsRoughedInAShortTimeIsFinished();
    void roughingIsShortBesideFinishing_data();
    void roughingIsShortBesideFinishing();
    void timeLimitIsKept_data();
    void timeLimitIsKept();
    void onlyTheRestOfALargerToolIsMilled();
    void sensesWrongRequests();
    void toolsThatNoPassCanLeadAreRefused();
};

void OperatorPlanTest::whatIsRoughedInAShortTimeIsFinished_data() {
    QTest::addColumn<double>("limit");
    if (burin::testing::longRun()) QTest::newRow("80 s") << 80.0;
    QTest::newRow("20 s") << 20.0;
}

void OperatorPlanTest::whatIsRoughedInAShortTimeIsFinished() {
    QFETCH(double, limit);
    MillingRequest request;
    request.stock = mouseStock;
    request.roughing = roughingRequest();
    request.finishing = finishingRequest(mouse.box());
    request.timeLimit = limit;
    const auto plan = planMilling(mouse, shankedBallTool(), request);
    QVERIFY(plan && plan->truncated);
    QVERIFY(plan->bottom > 0.0 && plan->bottom < mouse.box().high.z);
    const double rough = lengthOverPart(plan->roughing), fine = lengthOverPart(plan->finishing);
    qInfo("down to %.1f mm in %.1f s; over the part %.0f mm of roughing, %.0f mm of finishing", plan->bottom,
          plan->roughingSeconds + plan->finishingSeconds, rough, fine);
    QVERIFY(fine > 1000.0 && rough < 0.1 * fine);
    // Above that height everything is cleared.
    StockRaster stock(mouseStock);
    const auto visit = [&](const glm::dvec3& aim) {
        stock.cutBall({aim.x, aim.y, std::max(aim.z, mouse.restingTip(aim.x, aim.y))}, 3.0);
    };
    follow(plan->roughing, visit);
    follow(plan->finishing, visit);
    const double most = stock.highestAbove(
        [&](double x, double y) {
            return mouse.top(x, y) > std::max(plan->bottom + 0.5, 20.0) ? mouse.top(x, y) : 100.0;
        },
        1.0);
    QVERIFY2(most < 0.25, qPrintable(QString::number(most)));
}

void OperatorPlanTest::roughingIsShortBesideFinishing_data() {
    QTest::addColumn<double>("finishingDepth");
    QTest::addColumn<double>("share");
    QTest::newRow("every level cleared up to the part") << 0.0 << 0.09;
    if (burin::testing::longRun()) QTest::newRow("finishing takes 10 mm") << 10.0 << 0.09;
    QTest::newRow("finishing takes 12 mm") << 12.0 << 0.06;
}

void OperatorPlanTest::roughingIsShortBesideFinishing() {
    QFETCH(double, finishingDepth);
    QFETCH(double, share);
    MillingRequest request;
    request.stock = mouseStock;
    request.roughing = roughingRequest();
    request.roughing.finishingDepth = finishingDepth;
    request.finishing = finishingRequest(mouse.box());
    const auto plan = planMilling(mouse, shankedBallTool(), request);
    QVERIFY(plan);
    const double found = lengthOverPart(plan->roughing) / lengthOverPart(plan->finishing);
    qInfo("roughing over the part is %.1f %% of finishing; %.0f s and %.0f s, %zu and %zu points", 100.0 * found,
          plan->roughingSeconds, plan->finishingSeconds, plan->roughing.size(), plan->finishing.size());
    QVERIFY(found < share);
}

void OperatorPlanTest::timeLimitIsKept_data() {
    QTest::addColumn<double>("limit");
    QTest::addColumn<bool>("truncated");
    QTest::newRow("faster hand") << 240.0 << false;
    QTest::newRow("wider passes") << 150.0 << false;
    if (burin::testing::longRun()) QTest::newRow("the upper part") << 60.0 << true;
    if (burin::testing::longRun()) QTest::newRow("too short") << 20.0 << true;
    QTest::newRow("hopeless") << 1.0 << true;
}

void OperatorPlanTest::timeLimitIsKept() {
    QFETCH(double, limit);
    QFETCH(bool, truncated);
    MillingRequest request;
    request.stock = mouseStock;
    request.roughing = roughingRequest();
    request.finishing = finishingRequest(mouse.box());
    request.timeLimit = limit;
    const auto plan = planMilling(mouse, shankedBallTool(), request);
    QVERIFY(plan);
    qInfo("%.1f s + %.1f s, speed x %.2f, step-over %.2f mm", plan->roughingSeconds, plan->finishingSeconds,
          plan->speedFactor, plan->finishingStepOver);
    QVERIFY(plan->roughingSeconds + plan->finishingSeconds <= limit);
    QCOMPARE(plan->truncated, truncated);
    QCOMPARE(plan->finishingStepOver > 0.4 + 1e-9, limit <= 150.0);
    QVERIFY(plan->finishingStepOver <= 0.5 + 1e-9 && plan->speedFactor > 1.0);
    for (const auto& points : {plan->roughing, plan->finishing}) {
        for (const IntentPoint& point : points) QVERIFY(point.speed <= fastestHand.travelling);
        if (!points.empty()) QVERIFY(points.back().tip.z > mouseStock.high.z);
    }
}

/// A pit that a larger tool has cleared except for one of its corners.
void OperatorPlanTest::onlyTheRestOfALargerToolIsMilled() {
    const Box stockBox{{-40, -30, 0}, {40, 30, 12}};
    const Blocks part(1.5, {{{-40, -30, 0}, {-22, 30, 12}},
                            {{22, -30, 0}, {40, 30, 12}},
                            {{-40, -30, 0}, {40, -14, 12}},
                            {{-40, 14, 0}, {40, 30, 12}}});
    constexpr double left = 16.0, behind = 8.0; // mm, the corner that is left: x and y from here on
    MillingRequest request;
    request.stock = stockBox;
    request.roughing = roughingRequest();
    request.finishing = finishingRequest(stockBox);
    request.motion.maximumSpeed = 1e9;
    const auto lengthBelow = [&](const MillingPlan& plan, const auto& visit) {
        double length = 0.0;
        for (const auto& points : {plan.roughing, plan.finishing})
            follow(points, [&](const glm::dvec3& tip) {
                if (tip.z >= stockBox.high.z - 0.5) return;
                length += 0.2;
                visit(tip);
            });
        return length;
    };
    const auto whole = planMilling(part, shankedBallTool(3.0, 14.0), request);
    QVERIFY(whole);
    request.standing = {{-40, -30}, 0.5, 160, 120, {}};
    for (int row = 0; row < 120; ++row)
        for (int column = 0; column < 160; ++column) {
            const glm::dvec2 at(-40 + 0.5 * (column + 0.5), -30 + 0.5 * (row + 0.5));
            const bool pit = std::abs(at.x) < 22 && std::abs(at.y) < 14;
            request.standing.heights.push_back(!pit                           ? WorkpieceHeights::nothing
                                               : at.x > left && at.y > behind ? 12.0
                                                                              : 0.0);
        }
    const auto rest = planMilling(part, shankedBallTool(3.0, 14.0), request);
    QVERIFY(rest);
    double farthest = 0.0;
    StockRaster stock(stockBox);
    const double length = lengthBelow(*rest, [&](const glm::dvec3& tip) {
        farthest = std::max({farthest, left - tip.x, behind - tip.y});
        stock.cutBall({tip.x, tip.y, std::max(0.0, tip.z)}, 1.5);
    });
    const double all = lengthBelow(*whole, [](const glm::dvec3&) {});
    // Its edge reaches the remaining stock, and it starts from a distance of its radius plus a margin.
    QVERIFY2(farthest < 1.5 + 1.5 + 1.0 + 0.25, qPrintable(QString::number(farthest)));
    QVERIFY2(length > 10.0 && length < 0.25 * all, qPrintable(QString("%1 of %2").arg(length).arg(all)));
    // Of the corner nothing is left, except near the walls.
    const double stands = stock.highestAbove(
        [&](double x, double y) { return x > left && x < 20.0 && y > behind && y < 12.0 ? 0.0 : 100.0; }, 0.0);
    QVERIFY2(stands < 1.0, qPrintable(QString::number(stands)));
    request.standing.heights.assign(request.standing.heights.size(), WorkpieceHeights::nothing);
    const auto nothing = planMilling(part, shankedBallTool(3.0, 14.0), request);
    QVERIFY(nothing && nothing->roughing.empty() && nothing->finishing.empty());
}

void OperatorPlanTest::sensesWrongRequests() {
    WorkpieceHeights heights(mouseStock, shankedBallTool().cutter);
    RoughingRequest roughing = roughingRequest();
    roughing.stepOver = std::nan("");
    QCOMPARE(planRoughing(mouse, shankedBallTool(), roughing, heights).error().subject, std::string("step-over"));
    roughing = roughingRequest();
    roughing.speeds.plunging = 0.0;
    QCOMPARE(planRoughing(mouse, shankedBallTool(), roughing, heights).error().code, ErrorCode::argumentInvalid);
    QVERIFY(!planFinishing(mouse, shankedBallTool(), FinishingRequest{}, heights)); // an empty part
    MillingRequest milling;
    QVERIFY(!planMilling(mouse, shankedBallTool(), milling)); // an empty stock
}

/// A drill only cuts downwards; a ball on a neck and a T-slot's disc would descend through remaining stock.
void OperatorPlanTest::toolsThatNoPassCanLeadAreRefused() {
    MillingRequest request;
    request.stock = mouseStock;
    request.roughing = roughingRequest();
    request.finishing = finishingRequest(mouse.box());
    request.timeLimit = 20.0;
    Tool tool = shankedBallTool();
    const auto refused = [&] {
        const auto plan = planMilling(mouse, tool, request);
        ContourRequest contour;
        contour.stock = mouseStock;
        const auto contours = planContours(mouse, tool, contour);
        return !plan && plan.error().code == ErrorCode::notSupported && !contours &&
               contours.error().code == ErrorCode::notSupported;
    };
    for (const CutterType type : {CutterType::drill, CutterType::lollipop}) {
        tool.cutter.type = type;
        QVERIFY(refused());
    }
    tool.cutter.type = CutterType::profile;
    tool.cutter.profile = {{6.0, 0.0}, {6.0, 3.0}, {2.0, 3.0}, {2.0, 12.0}};
    QVERIFY(refused());
    tool.cutter.profile = {{2.0, 0.0}, {3.0, 3.0}, {3.0, 12.0}}; // wider above than below
    if (!testing::longRun()) return; // planning takes seconds, and other functions plan with a tool that isn't refused
    QVERIFY(!refused());
    tool = shankedBallTool();
    QVERIFY(!refused());
}

BURIN_TEST(OperatorPlanTest, NoApplication)

} // namespace burin::tst_milling_plan

#include "tst_milling_plan.moc"
