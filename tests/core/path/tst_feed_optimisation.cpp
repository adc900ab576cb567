// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "path_fixture.h"
#include "tests/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>

namespace burin::tst_feed_optimisation {

using namespace burin::test;

namespace {

constexpr double band = 5.0, depth = 2.0, radius = 3.0, exponent = 0.25, spindle = 10000.0;
constexpr double edgeSpeed = pi * 2.0 * radius * spindle / 60.0;                               // mm/s
constexpr std::array hardness{1000.0, 1300.0, 1800.0, 2400.0, 3000.0, 2200.0, 1500.0, 1100.0}; // kc1.1, N/mm²

/// A bar along X, 40 mm long, that becomes harder and softer again band by band.
Result<RunVolume> gradedBar(Progress&) {
    PropertyList list;
    for (std::size_t i = 0; i < hardness.size(); ++i) {
        Property property;
        property.id = "band " + std::to_string(i);
        property.values[std::string(kienzleForce)] = {hardness[i], "N/mm^2", "test", false};
        property.values[std::string(kienzleExponent)] = {exponent, "1", "test", false};
        if (!list.add(property)) return Error{ErrorCode::internalFault, "bar", "", ""};
    }
    constexpr double edge = 0.2;
    Result<RunVolume> volume = RunVolume::make(*Grid::make({0, -10, -4}, edge, {200, 100, 20}), list);
    if (!volume) return volume;
    for (int i = 0; i < 8; ++i)
        volume->fillBlock({i * 25, 0}, {(i + 1) * 25, 100}, 0, volume->grid().lineEnd(),
                          static_cast<PropertyIndex>(i + 1));
    return volume;
}

Result<void> lendBar(const StockUse& use, Progress& progress) {
    Result<RunVolume> bar = gradedBar(progress);
    return bar ? use(*bar) : Result<void>(bar.error());
}

/// Tangential force of a flat mill in a slot, in closed form: the front half of the tool meets each strip at its own
/// position. N. @param feed mm/min
double forceAt(double x, double feed) {
    const double chip = std::clamp(2.0 / pi * feed / (2.0 * spindle), 0.005, 1.0);
    constexpr int strips = 400;
    double energy = 0.0; // J/mm³ times mm
    for (int i = 0; i < strips; ++i) {
        const double y = radius * (2.0 * (i + 0.5) / strips - 1.0), front = x + std::sqrt(radius * radius - y * y);
        const auto place = static_cast<std::size_t>(std::clamp(front / band, 0.0, 7.0));
        energy += hardness[place] * std::pow(chip, -exponent) / 1000.0 * 2.0 * radius / strips;
    }
    return 1000.0 * energy * depth * (feed / 60.0) / edgeSpeed;
}

struct Variation {
    double mean = 0.0, coefficient = 0.0;
};

/// Over the time in which the tool's whole front is in the bar and its back has not left it.
Variation variationOf(const std::vector<PathPoint>& points, const std::function<double(double, double)>& load) {
    double time = 0.0, sum = 0.0, square = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].kind != MoveKind::cut) continue;
        const double from = points[i - 1].pose.tip.x, length = points[i].pose.tip.x - from;
        const int steps = std::max(1, static_cast<int>(length / 0.05));
        for (int k = 0; k < steps; ++k) {
            const double x = from + length * (k + 0.5) / steps;
            if (x < radius || x > 40.0 - radius) continue;
            const double value = load(x, points[i].feed), taken = length / steps / points[i].feed;
            time += taken;
            sum += taken * value;
            square += taken * value * value;
        }
    }
    const double mean = sum / time;
    return {mean, std::sqrt(std::max(0.0, square / time - mean * mean)) / mean};
}

PathContext barContext() {
    static const MeshDistance nothing{TriangleMesh{}};
    PathContext context = contextOf(nothing, flatTool(), {{0, -10, -4}, {40, 10, 0}});
    context.conditions.surfaceSpeed = edgeSpeed;
    context.machine.maximumFeed = 3000.0;
    context.machine.acceleration = 500.0;
    context.lendStock = lendBar;
    return context;
}

std::vector<PathPoint> fed(const std::vector<Edit>& tuning, const PathContext& context = barContext()) {
    std::vector<Edit> edits{{Simplify{}}, {Link{}}, {SetFeed{}}};
    edits.insert(edits.end(), tuning.begin(), tuning.end());
    const auto path = run({takeOf(along({{-10, 0, -depth}, {50, 0, -depth}}, 50.0))}, edits, context);
    return path ? path->path.points : std::vector<PathPoint>{};
}

} // namespace

class TestFeedOptimisation : public QObject {
    Q_OBJECT

private slots:
    void theForceOnAGradedBarIsLevel() {
        const std::vector<PathPoint> constant = fed({}), level = fed({{FeedOptimisation{}}});
        QVERIFY(!constant.empty() && !level.empty());
        const Variation before = variationOf(constant, forceAt), after = variationOf(level, forceAt);
        qInfo() << "coefficient of variation" << before.coefficient << "at constant feed," << after.coefficient
                << "levelled;" << before.mean << "N," << after.mean << "N;" << level.size() << "points";
        QVERIFY(before.coefficient > 0.25);
        QVERIFY(after.coefficient <= 0.10);
        QVERIFY(level.size() < 60); // not one block per sample
    }

    void theTargetIsMetInNewtons() {
        FeedOptimisation edit;
        edit.target = 200.0;
        const Variation after = variationOf(fed({{edit}}), forceAt);
        QVERIFY2(after.mean > 180.0 && after.mean < 206.0, qPrintable(QString::number(after.mean)));
    }

    /// Power is the tangential force times the cutting speed.
    void theSpindleIsNotOverloaded() {
        FeedOptimisation edit;
        edit.target = 400.0;
        edit.largestChip = 5.0;
        PathContext weak = barContext();
        weak.machine.spindlePower = 150.0 * edgeSpeed / 1000.0; // W, at 150 N
        const Variation free = variationOf(fed({{edit}}), forceAt), held = variationOf(fed({{edit}}, weak), forceAt);
        QVERIFY2(free.mean > 250.0, qPrintable(QString::number(free.mean)));
        QVERIFY2(held.mean > 130.0 && held.mean < 155.0, qPrintable(QString::number(held.mean)));
    }

    /// Existing feeds are reduced where the cut exceeds a limit, and nowhere else.
    void withTheLimitsAloneFeedsOnlyComeDown() {
        const FeedOptimisation edit{.goal = FeedOptimisation::Goal::limits};
        const std::vector<PathPoint> constant = fed({});
        const double feed = std::ranges::max(constant, {}, &PathPoint::feed).feed;
        PathContext strong = barContext();
        strong.machine.spindlePower = 1e5;
        QCOMPARE(fed({{edit}}, strong).size(), constant.size());
        PathContext weak = barContext();
        const double most = 0.6 * forceAt(22.0, feed); // N: between the forces of the softest and the hardest bands
        weak.machine.spindleTorque = {{spindle, most * radius / 1000.0}};
        const std::vector<PathPoint> held = fed({{edit}}, weak);
        bool cameDown = false, stayed = false;
        for (std::size_t i = 1; i < held.size(); ++i) {
            if (held[i].kind != MoveKind::cut) continue;
            QVERIFY(held[i].feed <= feed + 1e-9);
            cameDown = cameDown || held[i].feed < 0.7 * feed;
            stayed = stayed || held[i].feed > 0.9 * feed; // a block has the lowest feed of its intervals
            for (double x = std::max(radius, held[i - 1].pose.tip.x); x < std::min(held[i].pose.tip.x, 40.0 - radius);
                 x += 0.25)
                QVERIFY2(forceAt(x, held[i].feed) < 1.1 * most, qPrintable(QString::number(x)));
        }
        QVERIFY(cameDown && stayed);
        // Tool breakage: bending of shank and flutes as a beam, with the greatest moment at the holder.
        PathContext brittle = barContext();
        brittle.tool.strength = 1.0;
        for (const PathPoint& point : fed({{edit}}, brittle)) // where it cuts, the feed of the smallest chip
            if (point.kind == MoveKind::cut && point.pose.tip.x > 1.0 && point.pose.tip.x < 37.0)
                QVERIFY(point.feed <= 0.006 * 2.0 * spindle);
        // No value is given, or there is no stock to examine.
        QCOMPARE(fed({{edit}}).size(), constant.size());
        strong.lendStock = {};
        QCOMPARE(fed({{edit}}, strong).size(), constant.size());
    }

    void theRemovalRateIsLevel() {
        FeedOptimisation edit;
        edit.goal = FeedOptimisation::Goal::removal;
        edit.target = 150.0; // mm³/s: 12 mm² at 750 mm/min
        const auto rate = [](double, double feed) { return 2.0 * radius * depth * feed / 60.0; };
        const Variation after = variationOf(fed({{edit}}), rate);
        QVERIFY2(after.mean > 135.0 && after.mean < 158.0, qPrintable(QString::number(after.mean)));
        QVERIFY(after.coefficient < 0.1);
    }

    void feedsStayWithinTheirLimits() {
        FeedOptimisation edit;
        edit.smallestChip = 0.03;
        edit.largestChip = 0.06;
        edit.target = 200.0;
        for (const PathPoint& point : fed({{edit}})) {
            if (point.kind != MoveKind::cut) continue;
            QVERIFY(point.feed >= 0.03 * 2.0 * spindle - 1e-6 && point.feed <= 0.06 * 2.0 * spindle + 1e-6);
        }
        edit.largestChip = 5.0;
        edit.target = 1e6;
        for (const PathPoint& point : fed({{edit}})) QVERIFY(point.feed <= 3000.0);
    }

    void theAccelerationSufficesToSlowDown() {
        PathContext context = barContext();
        context.machine.acceleration = 20.0;
        const std::vector<PathPoint> points = fed({{FeedOptimisation{}}}, context);
        QVERIFY(!points.empty());
        double last = 0.0;
        for (std::size_t i = points.size(); i-- > 1;) {
            if (points[i].kind != MoveKind::cut) {
                last = 0.0;
                continue;
            }
            const double speed = points[i].feed / 60.0, length = points[i].pose.tip.x - points[i - 1].pose.tip.x;
            if (last > 0.0) QVERIFY(speed * speed <= last * last + 2.0 * 20.0 * (length + 0.5) + 1e-6);
            last = speed;
        }
    }

    void theWayAndThePlungesStay() {
        const std::vector<PathPoint> constant = fed({}), level = fed({{FeedOptimisation{}}});
        QVERIFY(farthestFrom(tipsOf(level), tipsOf(constant)) < 1e-9);
        QVERIFY(level.front().pose.tip == constant.front().pose.tip &&
                level.back().pose.tip == constant.back().pose.tip);
        for (const PathPoint& point : level)
            if (point.kind == MoveKind::plunge) QCOMPARE(point.feed, 300.0);
    }

    void withoutAStockItIsRefused() {
        PathContext context = barContext();
        context.lendStock = {};
        QVERIFY(fed({{FeedOptimisation{}}}, context).empty());
    }
};

BURIN_TEST(TestFeedOptimisation, NoApplication)

} // namespace burin::tst_feed_optimisation

#include "tst_feed_optimisation.moc"
