// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/operator_plan.h"
#include "tests/core/haptics/operator_fields.h"

#include <QtTest>

#include <functional>

using namespace burin;
using namespace burin::test;

namespace {

const LyingCapsule mouse(3.0, 27.5, 27.5, 5.0); // 110 x 55 x 32.5 mm, ball of 6 mm
const Box mouseStock = {mouse.box().low - glm::dvec3(5.0), mouse.box().high + glm::dvec3(5.0)};

/// Stock on a raster that shares nothing with the planner's: another width, another origin, plain loops.
class StockRaster {
public:
    static constexpr double width = 0.37;
    explicit StockRaster(const Box& stock) : stock_(stock) {
        columns_ = static_cast<int>(stock.size().x / width);
        rows_ = static_cast<int>(stock.size().y / width);
        heights_.assign(static_cast<std::size_t>(columns_ * rows_), stock.high.z);
    }
    /// Highest stock whose column lies within `radius` of the tip's axis, above the tip.
    double highestAround(const glm::dvec3& tip, double radius) const {
        double highest = stock_.low.z;
        each(tip, radius, [&](double height, double) { highest = std::max(highest, height); });
        return highest - tip.z;
    }
    /// Stock higher than the flutes is undercut; its top stays.
    void cutBall(const glm::dvec3& tip, double radius, double flutes = 1e9) {
        const_cast<StockRaster*>(this)->eachChanging(tip, radius, [&](double& height, double square) {
            if (height <= tip.z + flutes)
                height = std::min(height, tip.z + radius - std::sqrt(radius * radius - square));
        });
    }
    /// Greatest height of what stands above `allowed(x, y)`.
    double highestAbove(const std::function<double(double, double)>& allowed, double inset) const {
        double most = -1e9;
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column) {
                const double x = stock_.low.x + (column + 0.5) * width, y = stock_.low.y + (row + 0.5) * width;
                if (x < stock_.low.x + inset || y < stock_.low.y + inset || x > stock_.high.x - inset ||
                    y > stock_.high.y - inset)
                    continue;
                most = std::max(most, heights_[static_cast<std::size_t>(row * columns_ + column)] - allowed(x, y));
            }
        return most;
    }

private:
    void each(const glm::dvec3& tip, double radius, const std::function<void(double, double)>& visit) const {
        const_cast<StockRaster*>(this)->eachChanging(tip, radius, [&](double& h, double square) { visit(h, square); });
    }
    void eachChanging(const glm::dvec3& tip, double radius, const std::function<void(double&, double)>& visit) {
        const int reach = static_cast<int>(radius / width) + 2;
        const int middleColumn = static_cast<int>(std::floor((tip.x - stock_.low.x) / width));
        const int middleRow = static_cast<int>(std::floor((tip.y - stock_.low.y) / width));
        for (int row = middleRow - reach; row <= middleRow + reach; ++row)
            for (int column = middleColumn - reach; column <= middleColumn + reach; ++column) {
                if (row < 0 || column < 0 || row >= rows_ || column >= columns_) continue;
                const double dx = stock_.low.x + (column + 0.5) * width - tip.x;
                const double dy = stock_.low.y + (row + 0.5) * width - tip.y;
                if (dx * dx + dy * dy < radius * radius)
                    visit(heights_[static_cast<std::size_t>(row * columns_ + column)], dx * dx + dy * dy);
            }
    }
    Box stock_;
    int columns_ = 0, rows_ = 0;
    std::vector<double> heights_;
};

/// Visits the way of the tip, no two places further apart than 0.2 mm; the part holds the tip up at `resting`.
void follow(const std::vector<IntentPoint>& points, const std::function<void(const glm::dvec3&)>& visit) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec3 from = points[i - 1].tip, to = points[i].tip;
        const int steps = static_cast<int>(std::ceil(glm::distance(from, to) / 0.2));
        for (int k = 1; k <= steps; ++k) visit(glm::mix(from, to, static_cast<double>(k) / steps));
    }
}

RoughingRequest roughingRequest(double bottom = 0.0) {
    RoughingRequest request;
    request.bottom = bottom;
    return request;
}

FinishingRequest finishingRequest(const Box& part) {
    FinishingRequest request;
    request.part = part;
    request.floor = part.low.z;
    return request;
}

double lengthOverPart(const std::vector<IntentPoint>& points) {
    const Box& box = mouse.box();
    double length = 0.0;
    follow(points, [&](const glm::dvec3& tip) {
        if (tip.z < mouseStock.high.z && tip.x > box.low.x + 3.0 && tip.x < box.high.x - 3.0 &&
            mouse.restingTip(tip.x, tip.y) > 0.0 && std::abs(tip.y) < box.high.y - 3.0)
            length += 0.2;
    });
    return length;
}

} // namespace

class OperatorPlanTest final : public QObject {
    Q_OBJECT
private slots:
    void aTipComingDownStopsWhereTheFormulaSays();
    void aTipComingDownStopsAboveAnOverhang();
    void roughingKeepsItsAllowanceAllTheWay();
    void levelsAreNoDeeperThanAskedAndEndAtTheBottom_data();
    void levelsAreNoDeeperThanAskedAndEndAtTheBottom();
    void roughingLeavesNoMoreThanALevelAboveThePart();
    void rowsEnterFromBesideTheStock();
    void shankNeverReachesStandingStock_data();
    void shankNeverReachesStandingStock();
    void finishingAimsBelowThePartEverywhere();
    void finishingStaysAboveTheFloorAndNearThePart();
    void finishingLeavesLittleOnThePart();
    void crosswisePassesStayOnSteepWalls();
    void crosswisePassesSmoothTheWalls();
    void crosswisePassesNeedASteepPlace();
    void rowsPassStandingStockOnlyWithRoomForTheShank();
    void whatIsRoughedInAShortTimeIsFinished_data();
    void whatIsRoughedInAShortTimeIsFinished();
    void finishingWithoutRoughingGoesNoDeeperThanTheFlutes();
    void pocketIsRoughedFromAbove();
    void roughingIsShortBesideFinishing_data();
    void roughingIsShortBesideFinishing();
    void timeLimitIsKept_data();
    void timeLimitIsKept();
    void sensesWrongRequests();
};

void OperatorPlanTest::aTipComingDownStopsWhereTheFormulaSays() {
    for (double x = -60.0; x <= 60.0; x += 1.7)
        for (double y = -34.0; y <= 34.0; y += 1.3)
            QVERIFY(std::abs(lowestFeasibleHeight(mouse, x, y, 0.0, 40.0, 0.0) - mouse.restingTip(x, y)) < 2e-3);
    QVERIFY(lowestFeasibleHeight(mouse, 0.0, 0.0, 0.0, 20.0, 0.0) > 1e9); // inside the part from the start
    QCOMPARE(lowestFeasibleHeight(mouse, 90.0, 0.0, 0.0, 40.0, -3.0), -3.0);
}

void OperatorPlanTest::aTipComingDownStopsAboveAnOverhang() {
    class Plate final : public AnalyticField { // a plate at z = 20 to 21, free below
    public:
        using AnalyticField::AnalyticField;
        double distance(const glm::dvec3& c) const noexcept override { return std::abs(c.z - 20.5) - 0.5; }
    };
    const Plate plate(0.5);
    QVERIFY(std::abs(lowestFeasibleHeight(plate, 0.0, 0.0, 0.25, 40.0, 0.0) - 21.25) < 2e-3);
}

void OperatorPlanTest::roughingKeepsItsAllowanceAllTheWay() {
    WorkpieceHeights heights(mouseStock, ballTool().cutter);
    const Result<RoughingPlan> plan = planRoughing(mouse, ballTool(), roughingRequest(), heights);
    QVERIFY(plan);
    QVERIFY(plan->points.size() > 100);
    double least = 1e9;
    follow(plan->points, [&](const glm::dvec3& tip) { least = std::min(least, mouse.at(tip).clearance); });
    QVERIFY2(least >= 0.5, qPrintable(QString::number(least)));
    QVERIFY2(least <= 0.7, qPrintable(QString::number(least))); // and comes as near as that
}

void OperatorPlanTest::levelsAreNoDeeperThanAskedAndEndAtTheBottom_data() {
    QTest::addColumn<double>("asked");
    QTest::addColumn<double>("toolDepth");
    QTest::addColumn<double>("flutes");
    QTest::newRow("as asked") << 7.0 << 22.0 << 22.0;
    QTest::newRow("what the tool may cut") << 7.0 << 2.0 << 22.0;
    QTest::newRow("short flutes") << 50.0 << 50.0 << 6.0;
    QTest::newRow("left to Burin") << 0.0 << 0.0 << 22.0;
}

void OperatorPlanTest::levelsAreNoDeeperThanAskedAndEndAtTheBottom() {
    QFETCH(double, asked);
    QFETCH(double, toolDepth);
    QFETCH(double, flutes);
    Tool tool = ballTool(6.0, flutes);
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

void OperatorPlanTest::roughingLeavesNoMoreThanALevelAboveThePart() {
    RoughingRequest request = roughingRequest();
    request.levelDepth = 7.0;
    WorkpieceHeights heights(mouseStock, ballTool().cutter);
    const Result<RoughingPlan> plan = planRoughing(mouse, ballTool(), request, heights);
    QVERIFY(plan);
    StockRaster stock(mouseStock);
    follow(plan->points, [&](const glm::dvec3& tip) { stock.cutBall(tip, 3.0); });
    // Where the part's slope is below 47 degrees: a level of at most 7 mm, ridges of 1.02 mm between rows 4.5 mm apart,
    // the allowance measured upright, and what the round flank of a row's end leaves.
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
    QVERIFY2(onFloor < 1.6, qPrintable(QString::number(onFloor))); // beside the part the floor is bare but for ridges
}

void OperatorPlanTest::rowsEnterFromBesideTheStock() {
    WorkpieceHeights heights(mouseStock, ballTool().cutter);
    const Result<RoughingPlan> plan = planRoughing(mouse, ballTool(), roughingRequest(), heights);
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

void OperatorPlanTest::shankNeverReachesStandingStock_data() {
    QTest::addColumn<double>("flutes");
    QTest::newRow("long flutes") << 22.0;
    QTest::newRow("short flutes") << 9.0;
}

void OperatorPlanTest::shankNeverReachesStandingStock() {
    QFETCH(double, flutes);
    const Tool tool = ballTool(6.0, flutes);
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
        // Columns under the rim of the shank may lie on either side of it in the two rasters.
        most = std::max(most, stock.highestAround(tip, 2.9 - 0.5));
        stock.cutBall(tip, 3.0, flutes);
    };
    follow(plan->roughing, visit);
    QVERIFY2(most <= flutes, qPrintable(QString::number(most)));
    follow(plan->finishing, visit);
    QVERIFY2(most <= flutes, qPrintable(QString::number(most)));
    QVERIFY2(beside > 5.0, qPrintable(QString::number(beside))); // it did work beside tall stock
}

void OperatorPlanTest::finishingAimsBelowThePartEverywhere() {
    WorkpieceHeights heights(mouseStock, ballTool().cutter);
    QVERIFY(planRoughing(mouse, ballTool(), roughingRequest(), heights));
    const auto points = planFinishing(mouse, ballTool(), finishingRequest(mouse.box()), heights);
    QVERIFY(points);
    int over = 0, pressing = 0;
    for (const IntentPoint& point : *points) {
        const double resting = mouse.restingTip(point.tip.x, point.tip.y);
        if (resting < 2.0 || point.tip.z > mouseStock.high.z) continue;
        ++over;
        pressing += std::abs(resting - 2.0 - point.tip.z) < 5e-3 ? 1 : 0;
    }
    QVERIFY(over > 20000);
    QVERIFY2(pressing + over / 500 >= over, qPrintable(QString("%1 of %2").arg(pressing).arg(over)));
}

void OperatorPlanTest::finishingStaysAboveTheFloorAndNearThePart() {
    WorkpieceHeights heights(mouseStock, ballTool().cutter);
    QVERIFY(planRoughing(mouse, ballTool(), roughingRequest(), heights));
    const auto points = planFinishing(mouse, ballTool(), finishingRequest(mouse.box()), heights);
    QVERIFY(points);
    for (const IntentPoint& point : *points) {
        QVERIFY(point.tip.z >= 0.0);
        const double besideAxis = std::hypot(std::max(0.0, std::abs(point.tip.x) - 27.5), point.tip.y);
        QVERIFY(besideAxis <= 27.5 + 3.0 + 1.5 + 0.5);
    }
    QVERIFY(points->front().tip.z > mouseStock.high.z);
    QVERIFY(points->back().tip.z > mouseStock.high.z);
}

void OperatorPlanTest::finishingLeavesLittleOnThePart() {
    WorkpieceHeights heights(mouseStock, ballTool().cutter);
    const auto roughing = planRoughing(mouse, ballTool(), roughingRequest(), heights);
    const auto finishing = planFinishing(mouse, ballTool(), finishingRequest(mouse.box()), heights);
    QVERIFY(roughing && finishing);
    StockRaster stock(mouseStock);
    const auto visit = [&](const glm::dvec3& aim) {
        stock.cutBall({aim.x, aim.y, std::max(aim.z, mouse.restingTip(aim.x, aim.y))}, 3.0);
    };
    follow(roughing->points, visit);
    follow(*finishing, visit);
    // Within 20 mm of the axis the part's slope is below 47 degrees: ridges of 0.4 mm passes are hundredths of a mm.
    const double most = stock.highestAbove(
        [](double x, double y) {
            const double square = 27.5 * 27.5 - std::pow(std::max(0.0, std::abs(x) - 27.5), 2) - y * y;
            return square > 27.5 * 27.5 - 400.0 ? 5.0 + std::sqrt(square) : 100.0;
        },
        0.0);
    QVERIFY2(most < 0.05 && most > -0.01, qPrintable(QString::number(most)));
}

void OperatorPlanTest::crosswisePassesStayOnSteepWalls() {
    LyingCapsule part = mouse;
    part.answerGradients();
    WorkpieceHeights heights(mouseStock, ballTool().cutter);
    QVERIFY(planRoughing(part, ballTool(), roughingRequest(), heights));
    QVERIFY(planFinishing(part, ballTool(), finishingRequest(part.box()), heights));
    const auto points = planCrosswiseFinishing(part, ballTool(), finishingRequest(part.box()), heights);
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
        // A ball rests at 45 degrees across the rows where its centre is as far beside the ridge as above it; a row's
        // width and the press, square to the surface, come to 2 mm more.
        const double beside = std::abs(aim.y) * (30.5 / 28.5);
        const double along = std::max(0.0, std::abs(aim.x) - 27.5) * (30.5 / 28.5);
        const double above = std::sqrt(std::max(0.0, 30.5 * 30.5 - beside * beside - along * along));
        QVERIFY2(beside > above - 3.0, qPrintable(QString("%1 %2 %3").arg(aim.x).arg(aim.y).arg(aim.z)));
    }
    QVERIFY2(pressing > cutting * 9 / 10, qPrintable(QString("%1 of %2").arg(pressing).arg(cutting)));
    QVERIFY2(lifts <= 4, qPrintable(QString::number(lifts))); // two walls, not one lift a pass
    QVERIFY(points->front().tip.z > mouseStock.high.z && points->back().tip.z > mouseStock.high.z);
}

void OperatorPlanTest::crosswisePassesSmoothTheWalls() {
    LyingCapsule part = mouse;
    part.answerGradients();
    WorkpieceHeights heights(mouseStock, ballTool().cutter);
    QVERIFY(planRoughing(part, ballTool(), roughingRequest(), heights));
    const auto rows = planFinishing(part, ballTool(), finishingRequest(part.box()), heights);
    const auto crosswise = planCrosswiseFinishing(part, ballTool(), finishingRequest(part.box()), heights);
    QVERIFY(rows && crosswise);
    // Places on the wall, up to 80 degrees: how far is the nearest ball that was rolled along it?
    std::vector<glm::dvec3> walls;
    for (double x = -20.0; x <= 20.0; x += 1.3)
        for (double angle = 50.0; angle <= 80.0; angle += 1.1)
            walls.push_back({x, 27.5 * std::sin(glm::radians(angle)), 5.0 + 27.5 * std::cos(glm::radians(angle))});
    const auto leftOver = [&](const std::vector<IntentPoint>& points, std::vector<double>& left) {
        follow(points, [&](const glm::dvec3& aim) {
            glm::dvec3 centre = aim + glm::dvec3(0.0, 0.0, 3.0);
            if (std::abs(centre.x) > 24.0 || centre.z < 4.0) return;
            const glm::dvec2 across(centre.y, centre.z - 5.0); // pushed out square to the capsule
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

void OperatorPlanTest::crosswisePassesNeedASteepPlace() {
    class Slope final : public AnalyticField { // 40 degrees across the rows
    public:
        using AnalyticField::AnalyticField;
        double distance(const glm::dvec3& c) const noexcept override {
            return glm::dot(c, {0.0, std::sin(glm::radians(40.0)), std::cos(glm::radians(40.0))}) - 20.0;
        }
    };
    Slope slope(3.0);
    slope.answerGradients();
    WorkpieceHeights heights({{-10, -10, 0}, {10, 10, 40}}, ballTool().cutter);
    FinishingRequest request = finishingRequest({{-8, -8, 10}, {8, 8, 35}});
    const auto points = planCrosswiseFinishing(slope, ballTool(), request, heights);
    QVERIFY(points && points->empty());
    request.crosswiseStepOver = -1.0;
    QCOMPARE(planCrosswiseFinishing(slope, ballTool(), request, heights).error().subject,
             std::string("crosswise step-over"));
}

void OperatorPlanTest::rowsPassStandingStockOnlyWithRoomForTheShank() {
    // A tall wall along x whose face lies so that rows at every level pass it with nothing to spare.
    for (double face = -2.0; face <= 2.0; face += 0.25) {
        const Blocks wall(3.0, {{{-40, -40, 0}, {40, face, 33}}});
        const Box stock{{-40, -40, -5}, {40, 25, 38}};
        WorkpieceHeights heights(stock, ballTool().cutter);
        const auto plan = planRoughing(wall, ballTool(), roughingRequest(), heights);
        QVERIFY(plan);
        StockRaster raster(stock);
        double most = 0.0, least = 1e9;
        follow(plan->points, [&](const glm::dvec3& tip) {
            least = std::min(least, wall.at(tip).clearance);
            most = std::max(most, raster.highestAround(tip, 2.9)); // even where the hand is a quarter millimetre off
            raster.cutBall(tip, 3.0, 22.0);
        });
        QVERIFY2(most <= 22.0, qPrintable(QString("%1 at %2").arg(most).arg(face)));
        QVERIFY2(least >= 0.5, qPrintable(QString("%1 at %2").arg(least).arg(face)));
    }
}

void OperatorPlanTest::whatIsRoughedInAShortTimeIsFinished_data() {
    QTest::addColumn<double>("limit");
    QTest::newRow("80 s") << 80.0;
    QTest::newRow("20 s") << 20.0;
}

void OperatorPlanTest::whatIsRoughedInAShortTimeIsFinished() {
    QFETCH(double, limit);
    MillingRequest request;
    request.stock = mouseStock;
    request.roughing = roughingRequest();
    request.finishing = finishingRequest(mouse.box());
    request.timeLimit = limit;
    const auto plan = planMilling(mouse, ballTool(), request);
    QVERIFY(plan && plan->truncated);
    QVERIFY(plan->bottom > 0.0 && plan->bottom < mouse.box().high.z);
    const double rough = lengthOverPart(plan->roughing), fine = lengthOverPart(plan->finishing);
    qInfo("down to %.1f mm in %.1f s; over the part %.0f mm of roughing, %.0f mm of finishing", plan->bottom,
          plan->roughingSeconds + plan->finishingSeconds, rough, fine);
    QVERIFY(fine > 1000.0 && rough < 0.1 * fine);
    // Everything above that height is bare.
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

void OperatorPlanTest::finishingWithoutRoughingGoesNoDeeperThanTheFlutes() {
    const Tool tool = ballTool(6.0, 9.0);
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
    QVERIFY2(lowest < mouseStock.high.z - 7.0, qPrintable(QString::number(lowest))); // but as deep as that
}

void OperatorPlanTest::pocketIsRoughedFromAbove() {
    // A frame of four walls around a pocket of 30 x 30 mm, 12 mm deep.
    const std::vector<Box> walls = {{{-25, -25, 0}, {-15, 25, 12}},
                                    {{15, -25, 0}, {25, 25, 12}},
                                    {{-15, -25, 0}, {15, -15, 12}},
                                    {{-15, 15, 0}, {15, 25, 12}}};
    const Blocks frame(3.0, walls);
    const Box stock{{-30, -30, -5}, {30, 30, 15}};
    WorkpieceHeights heights(stock, ballTool().cutter);
    const auto plan = planRoughing(frame, ballTool(), roughingRequest(), heights);
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

void OperatorPlanTest::roughingIsShortBesideFinishing_data() {
    QTest::addColumn<double>("finishingDepth");
    QTest::addColumn<double>("share");
    QTest::newRow("every level cleared up to the part") << 0.0 << 0.09;
    QTest::newRow("finishing takes 10 mm") << 10.0 << 0.09;
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
    const auto plan = planMilling(mouse, ballTool(), request);
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
    QTest::newRow("wider passes") << 130.0 << false;
    QTest::newRow("the upper part") << 60.0 << true;
    QTest::newRow("too short") << 20.0 << true;
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
    const auto plan = planMilling(mouse, ballTool(), request);
    QVERIFY(plan);
    qInfo("%.1f s + %.1f s, speed x %.2f, step-over %.2f mm", plan->roughingSeconds, plan->finishingSeconds,
          plan->speedFactor, plan->finishingStepOver);
    QVERIFY(plan->roughingSeconds + plan->finishingSeconds <= limit);
    QCOMPARE(plan->truncated, truncated);
    QCOMPARE(plan->finishingStepOver > 0.4 + 1e-9, limit <= 130.0);
    QVERIFY(plan->finishingStepOver <= 0.5 + 1e-9 && plan->speedFactor > 1.0);
    for (const auto& points : {plan->roughing, plan->finishing}) {
        for (const IntentPoint& point : points) QVERIFY(point.speed <= fastestHand.travelling);
        if (!points.empty()) QVERIFY(points.back().tip.z > mouseStock.high.z);
    }
}

void OperatorPlanTest::sensesWrongRequests() {
    WorkpieceHeights heights(mouseStock, ballTool().cutter);
    RoughingRequest roughing = roughingRequest();
    roughing.stepOver = std::nan("");
    QCOMPARE(planRoughing(mouse, ballTool(), roughing, heights).error().subject, std::string("step-over"));
    roughing = roughingRequest();
    roughing.speeds.plunging = 0.0;
    QCOMPARE(planRoughing(mouse, ballTool(), roughing, heights).error().code, ErrorCode::argumentInvalid);
    QVERIFY(!planFinishing(mouse, ballTool(), FinishingRequest{}, heights)); // an empty part
    MillingRequest milling;
    QVERIFY(!planMilling(mouse, ballTool(), milling)); // an empty stock
}

QTEST_APPLESS_MAIN(OperatorPlanTest)
#include "tst_operator_plan.moc"
