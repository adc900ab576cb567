// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/base/units.h"
#include "path_fixture.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QTest>

#include <random>

namespace burin::tst_fit_arcs {

using namespace burin::test;

namespace {

const MeshDistance nothing{TriangleMesh{}};

PathContext freeContext() {
    PathContext context = contextOf(nothing, ballTool(), {{-100, -100, -60}, {100, 100, 0}});
    context.workOffset = {3.1234567, -2.7654321, 0.3333333};
    return context;
}

/// Ticks on a curve of `length` parameters, a fiftieth of a millimetre apart for a curve of unit speed.
std::vector<Tick> onCurve(double length, const std::function<glm::dvec3(double)>& curve) {
    std::vector<Tick> ticks;
    for (double t = 0.0; t <= length; t += 0.02) ticks.push_back({curve(t)});
    return ticks;
}

/// The rounded value of a coordinate that a control receives.
double figure(double value, double zero) {
    return *parseNumber(formatFixed(value - zero, 3));
}

/// The rule of the edit that an arc breaks, or empty.
std::string brokenRule(const glm::dvec3& from, const PathPoint& to, const PathContext& context, const FitArcs& rules) {
    const int w = to.arc->axis, u = (w + 1) % 3, v = (w + 2) % 3;
    const auto plane = [&](const glm::dvec3& place) {
        return glm::dvec2(figure(place[u], context.workOffset[u]), figure(place[v], context.workOffset[v]));
    };
    const glm::dvec2 start = plane(from), end = plane(to.pose.tip), centre = plane(to.arc->centre);
    const double startRadius = glm::distance(centre, start), endRadius = glm::distance(centre, end);
    if (std::abs(startRadius - endRadius) > rules.radiusMismatch + 1e-9) return "mismatch of radii";
    if (startRadius < rules.smallestRadius - 0.002 || startRadius > rules.largestRadius + 0.002) return "radius";
    double length = 0.0;
    const std::vector<glm::dvec3> places = placesOf(from, to, 0.01);
    for (std::size_t i = 1; i < places.size(); ++i)
        length += std::hypot(places[i][u] - places[i - 1][u], places[i][v] - places[i - 1][v]);
    if (length > (rules.largestSweep + 0.01) * startRadius) return "sweep";
    return {};
}

std::size_t arcsIn(const std::vector<PathPoint>& points) {
    std::size_t count = 0;
    for (const PathPoint& point : points)
        if (point.arc) ++count;
    return count;
}

} // namespace

class TestFitArcs : public QObject {
    Q_OBJECT

private slots:
    void planarIntervalsTakeFewBlocks_data() {
        QTest::addColumn<std::vector<Tick>>("ticks");
        QTest::newRow("circle in XY") << onCurve(
            125.0, [](double t) { return glm::dvec3(20.0 * std::cos(t / 20.0), 20.0 * std::sin(t / 20.0), -3.0); });
        QTest::newRow("clockwise circle in XZ") << onCurve(60.0, [](double t) {
            return glm::dvec3(10.0 * std::cos(t / 10.0), 4.0, -20.0 - 10.0 * std::sin(t / 10.0));
        });
        QTest::newRow("half circle in YZ") << onCurve(47.0, [](double t) {
            return glm::dvec3(4.0, 15.0 * std::cos(t / 15.0), -30.0 + 15.0 * std::sin(t / 15.0));
        });
        QTest::newRow("wave") << onCurve(
            150.0, [](double t) { return glm::dvec3(t - 75.0, 12.0 * std::sin(t / 18.0), -3.0); });
        QTest::newRow("spiral") << onCurve(28.0, [](double t) {
            const double radius = 8.0 + 1.2 * t;
            return glm::dvec3(radius * std::cos(t / 3.0), radius * std::sin(t / 3.0), -3.0);
        });
        QTest::newRow("helix of constant pitch") << onCurve(150.0, [](double t) {
            return glm::dvec3(12.0 * std::cos(t / 12.0), 12.0 * std::sin(t / 12.0), -t / 40.0);
        });
    }
    void planarIntervalsTakeFewBlocks() {
        QFETCH(std::vector<Tick>, ticks);
        const PathContext context = freeContext();
        const FitArcs rules;
        const auto arcs = run({takeOf(ticks)}, {{rules}}, context);
        const auto lines = run({takeOf(ticks)}, {{Simplify{rules.tolerance}}}, context);
        QVERIFY(arcs && lines);
        const std::vector<PathPoint>& points = arcs->path.points;
        qInfo() << lines->path.points.size() - 1 << "lines," << points.size() - 1 << "arcs and lines";
        QVERIFY(5 * (points.size() - 1) <= lines->path.points.size() - 1);
        for (std::size_t i = 1; i < points.size(); ++i)
            if (points[i].arc) QCOMPARE(brokenRule(points[i - 1].pose.tip, points[i], context, rules), std::string());
        const std::vector<glm::dvec3> fitted = placesAlong(points, 0.01), source = tipsOf(ticks);
        QVERIFY(farthestFrom(source, fitted) <= rules.tolerance + 1e-5); // the sampled arc's own chords: 1e-6
        QVERIFY(farthestFrom(fitted, source) <= rules.tolerance + 1e-9);
        QVERIFY(arcs->reports.front().largestDeviation >= farthestFrom(fitted, source) - 1e-9);
        QVERIFY(arcs->reports.front().largestDeviation <= rules.tolerance);
    }

    /// Rows of a typical hand: level, with waves of a few millimetres, and random deviations of a micrometre.
    void rowsOfAHandTakeFewerBlocks() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> micrometres(-0.001, 0.001);
        std::vector<Tick> ticks;
        for (double x = -60.0; x < 60.0; x += 0.25)
            ticks.push_back({{x, 0.05 * std::sin(x / 1.16) + 0.04 * std::sin(x / 0.65 + 1.0) + micrometres(random),
                              -3.0 + micrometres(random)}});
        const PathContext context = freeContext();
        const FitArcs rules;
        const auto arcs = run({takeOf(ticks)}, {{rules}}, context);
        const auto lines = run({takeOf(ticks)}, {{Simplify{rules.tolerance}}}, context);
        QVERIFY(arcs && lines);
        const double blocks = static_cast<double>(arcs->path.points.size() - 1);
        const double share = static_cast<double>(lines->path.points.size() - 1) / blocks;
        QVERIFY2(share >= 2.05, qPrintable(QString("%1 times fewer, %2").arg(share).arg(blocks)));
        const std::vector<glm::dvec3> fitted = placesAlong(arcs->path.points, 0.01), source = tipsOf(ticks);
        QVERIFY(farthestFrom(source, fitted) <= rules.tolerance + 1e-5);
        QVERIFY(farthestFrom(fitted, source) <= rules.tolerance + 1e-9);
    }

    void randomStrokesStayWithinTheTolerance() {
        const PathContext context = freeContext();
        QVERIFY(testing::holdsInShare("both ways, and every arc by the rules", [&] {
            FitArcs rules;
            rules.tolerance = *rc::gen::element(0.003, 0.01, 0.05);
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            std::uniform_real_distribution<double> one(-1.0, 1.0);
            // A point that moves with a curvature and a slope which change from time to time.
            std::vector<Tick> ticks;
            glm::dvec3 at(20.0 * one(random), 20.0 * one(random), -20.0);
            double heading = 3.0 * one(random), curvature = 0.0, climb = 0.0;
            const int plane = *rc::gen::inRange(0, 3);
            for (int i = 0; i < 900; ++i) {
                if (i % 150 == 0) {
                    curvature = i % 300 == 0 ? 0.3 * one(random) : 0.0;
                    climb = i % 450 == 0 ? 0.2 * one(random) : 0.0;
                }
                heading += 0.03 * curvature;
                glm::dvec3 step(0.0);
                step[(plane + 1) % 3] = 0.03 * std::cos(heading);
                step[(plane + 2) % 3] = 0.03 * std::sin(heading);
                step[plane] = 0.03 * climb;
                at += step;
                ticks.push_back({at});
            }
            const auto path = run({takeOf(ticks)}, {{rules}}, context);
            RC_ASSERT(static_cast<bool>(path));
            const std::vector<PathPoint>& points = path->path.points;
            for (std::size_t i = 1; i < points.size(); ++i)
                if (points[i].arc) RC_ASSERT(brokenRule(points[i - 1].pose.tip, points[i], context, rules).empty());
            const std::vector<glm::dvec3> fitted = placesAlong(points, 0.02), source = tipsOf(ticks);
            RC_ASSERT(farthestFrom(source, fitted) <= rules.tolerance + 1e-4); // chords of the arc's own samples
            RC_ASSERT(farthestFrom(fitted, source) <= rules.tolerance + 1e-9);
            RC_ASSERT(points.front().pose.tip == source.front() && points.back().pose.tip == source.back());
        }));
    }

    /// A hand that turns back between two bends, with a hesitation of a tenth of a millimetre after the corner.
    void noArcMakesABackStep() {
        std::size_t arcs = 0;
        QVERIFY(testing::holdsInShare("nothing is sent forth and back", [&] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            std::uniform_real_distribution<double> one(0.0, 1.0);
            glm::dvec3 at(0.0, 0.0, -3.0);
            double heading = 6.0 * one(random);
            std::vector<Tick> ticks{{at}};
            const auto go = [&](double length, double curvature) {
                const int steps = std::max(1, static_cast<int>(length / 0.02));
                for (int i = 0; i < steps; ++i) {
                    heading += curvature * length / steps;
                    at += length / steps * glm::dvec3(std::cos(heading), std::sin(heading), 0.0);
                    ticks.push_back({at});
                }
            };
            const auto bend = [&] { return (one(random) < 0.5 ? 1.0 : -1.0) / (5.0 * std::pow(30.0, one(random))); };
            go(4.0 + 6.0 * one(random), bend());
            for (int corner = 0; corner < 3; ++corner) {
                heading += (150.0 + 20.0 * one(random)) * pi / 180.0;
                go(0.02 + 0.12 * one(random), 0.0);
                heading += 0.6 * (one(random) - 0.5);
                go(4.0 + 6.0 * one(random), bend());
            }
            const auto path = run({takeOf(ticks)}, {{FitArcs{}}, {Link{}}}, freeContext());
            RC_ASSERT(static_cast<bool>(path));
            arcs += arcsIn(path->path.points);
            RC_ASSERT(backStepsIn(path->path.points) == 0U);
        }));
        QVERIFY(arcs > 60);
    }

    void anArcThatWouldEnterThePartIsNotTaken() {
        // The hand passed a pin with a tiny clearance, on chords of a circle that itself would enter the pin.
        const double sagitta = 20.0 * (1.0 - std::cos(pi / 36.0));
        std::vector<glm::dvec3> corners;
        for (int i = 0; i <= 9; ++i)
            corners.push_back({20.0 * std::cos(i * pi / 18.0), 20.0 * std::sin(i * pi / 18.0), -3.0});
        const std::vector<Tick> ticks = along(corners, 50.0);
        const glm::dvec3 middle = 0.5 * (corners[4] + corners[5]),
                         out = glm::normalize(glm::dvec3(middle.x, middle.y, 0));
        const glm::dvec3 near = middle + (3.0 + 0.001) * out;
        const Box pin{{near.x, near.y, -10}, {near.x + 3.0, near.y + 3.0, 0}}; // its nearest corner lies at 45°
        const MeshDistance part(boxMesh(pin));
        PathContext context = contextOf(part, ballTool(), {{-60, -60, -20}, {60, 60, 0}});
        const FitArcs rules{1.2 * sagitta};
        const auto held = run({takeOf(ticks)}, {{rules}}, context);
        context.part = &nothing;
        const auto unheld = run({takeOf(ticks)}, {{rules}}, context);
        QVERIFY(held && unheld);
        const auto deepest = [&](const std::vector<PathPoint>& points) {
            double least = 1e9;
            for (const glm::dvec3& place : placesAlong(points, 0.005)) {
                const glm::dvec2 beside = glm::max(
                    glm::max(glm::dvec2(pin.low) - glm::dvec2(place), glm::dvec2(place) - glm::dvec2(pin.high)),
                    glm::dvec2(0.0));
                least = std::min(least, glm::length(beside) - 3.0); // the shank extends past the pin's whole height
            }
            return least;
        };
        QVERIFY(arcsIn(unheld->path.points) > 0);
        QVERIFY2(deepest(unheld->path.points) < -0.005, qPrintable(QString::number(deepest(unheld->path.points))));
        QVERIFY2(deepest(held->path.points) >= -1e-4, qPrintable(QString::number(deepest(held->path.points))));
    }

    void linksAndFeedsCarryArcsThrough() {
        const auto ring = [](double x) {
            return onCurve(31.0, [x](double t) {
                return glm::dvec3(x + 10.0 * std::cos(t / 10.0), 10.0 * std::sin(t / 10.0), -3.0);
            });
        };
        Take first = takeOf(ring(-30.0)), second = takeOf(ring(30.0));
        second.info.id = 2;
        const auto path = run({first, second}, {{FitArcs{}}, {Link{}}, {SetFeed{}}}, freeContext());
        QVERIFY(path);
        std::size_t arcs = 0;
        for (const PathPoint& point : path->path.points) {
            if (!point.arc) continue;
            ++arcs;
            QVERIFY(point.kind == MoveKind::cut);
            QCOMPARE(point.feed, 900.0);
            QVERIFY(std::abs(std::abs(point.arc->centre.x) - 30.0) < 0.02 && !point.arc->clockwise);
        }
        QVERIFY(arcs >= 2);
    }

    void anArcThatDivesGetsThePlungeFeed() {
        const auto quarter = onCurve(15.0, [](double t) {
            return glm::dvec3(10.0 * std::sin(t / 10.0), 0.0, -20.0 + 10.0 * std::cos(t / 10.0));
        });
        const auto path = run({takeOf(quarter)}, {{FitArcs{}}, {Link{}}, {SetFeed{}}}, freeContext());
        QVERIFY(path);
        QVERIFY(arcsIn(path->path.points) > 0);
        for (const PathPoint& point : path->path.points)
            if (point.arc) QCOMPARE(point.feed, 300.0);
    }
};

BURIN_TEST(TestFitArcs, NoApplication)

} // namespace burin::tst_fit_arcs

#include "tst_fit_arcs.moc"
