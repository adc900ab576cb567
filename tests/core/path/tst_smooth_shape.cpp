// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/path/back_steps.h"
#include "hands.h"
#include "path_fixture.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QTest>

#include <random>

namespace burin::tst_smooth_shape {

using namespace burin::test;

namespace {

/// From corner to corner at constant speed, with a rest of half a second in the middle of each move.
std::vector<Tick> withRests(const std::vector<glm::dvec3>& corners, double speed) {
    std::vector<Tick> ticks;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const glm::dvec3 middle = glm::mix(corners[i - 1], corners[i], 0.5);
        append(ticks, along({corners[i - 1], middle}, speed));
        append(ticks, std::vector<Tick>(500, {middle}));
        append(ticks, along({middle, corners[i]}, speed));
    }
    return ticks;
}

} // namespace

class TestSmoothShape : public QObject {
    Q_OBJECT

private slots:
    /// Waves across a straight stroke keep 1 / (1 + (wavelength / w)^6) of their height, also with as much tremor along
    /// it.
    void wavesKeepTheShareOfTheLaw_data() {
        QTest::addColumn<double>("wave");  // mm
        QTest::addColumn<double>("along"); // mm
        for (const double wave : {1.5, 2.0, 3.0, 4.5, 9.0})
            for (const double along : {0.0, 0.05})
                QTest::addRow("%.1f mm, %.2f mm along", wave, along) << wave << along;
    }
    void wavesKeepTheShareOfTheLaw() {
        QFETCH(double, wave);
        QFETCH(double, along);
        constexpr double height = 0.05, length = 90.0, speed = 15.0;
        std::vector<Tick> ticks;
        for (double way = 0.0; way <= length; way += 0.001 * speed) {
            const double turn = 2.0 * pi * way / wave;
            ticks.push_back({{way + along * std::cos(turn), height * std::sin(turn), -1.0}});
        }
        const auto path = run({takeOf(ticks)}, {{SmoothShape{3.0, 1.0}}}, context());
        QVERIFY(path);
        double square = 0.0, count = 0.0, mean = 0.0;
        for (const glm::dvec3& tip : tipsOf(path->path.points)) {
            if (tip.x < 18.0 || tip.x > length - 18.0) continue; // at the ends the filter knows less
            square += tip.y * tip.y;
            mean += tip.y;
            count += 1.0;
        }
        const double kept = std::sqrt(2.0 * square / count) / height;
        const double law = 1.0 / (1.0 + std::pow(3.0 / wave, 6.0));
        qInfo() << "kept" << kept << "law" << law << "mean" << mean / count;
        QVERIFY(std::abs(kept - law) < (along > 0.0 ? 0.03 : 0.01));
    }

    void tremorComesDownTwentyTimes() {
        constexpr double tube = 0.2;
        for (unsigned seed = 1; seed <= testing::inLongRun(5U, 2U); ++seed) {
            std::vector<Tick> ticks = circle(20.0, 15.0, 3.0);
            tremble(ticks, 0.05, seed);
            const auto path = run({takeOf(ticks)}, {{SmoothShape{3.0, tube}}}, context());
            QVERIFY(path);
            const std::vector<glm::dvec3> recorded = tipsOf(ticks), smoothed = tipsOf(path->path.points);
            QCOMPARE(smoothed.size(), recorded.size());
            const double across = rmsOffCircle(recorded, 20.0), left = rmsOffCircle(smoothed, 20.0);
            qInfo() << "across the curve" << 1000.0 * across << "um down to" << 1000.0 * left;
            QVERIFY(20.0 * left <= across);
            QVERIFY(farthestFrom(recorded, smoothed) <= tube + 1e-9);
            QVERIFY(farthestFrom(smoothed, recorded) <= tube + 1e-9);
        }
    }

    void circlesStayTheirSize_data() {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("most"); // mm
        QTest::newRow("radius 5") << 5.0 << 0.001;
        QTest::newRow("radius 2") << 2.0 << 0.002;
        QTest::newRow("radius 1") << 1.0 << 0.015;
    }
    void circlesStayTheirSize() {
        QFETCH(double, radius);
        QFETCH(double, most);
        for (const double speed : {5.0, 20.0, 100.0}) {
            const auto path = run({takeOf(circle(radius, speed, 4.0))}, {{SmoothShape{3.0, 0.2}}}, context());
            QVERIFY(path);
            const std::vector<glm::dvec3> tips = tipsOf(path->path.points);
            double off = 0.0; // two wavelengths from the ends, beyond which nothing is known
            const auto margin = static_cast<std::size_t>(6.0 / (0.001 * speed));
            for (std::size_t i = margin; i + margin < tips.size(); ++i) off = std::max(off, offCircle(tips[i], radius));
            qInfo() << "radius" << radius << "at" << speed << "mm/s:" << 1000.0 * off << "um";
            QVERIFY(off <= most);
        }
    }

    void cornersStayWhereTheTubeDemands() {
        const std::vector<Tick> ticks = along({{0, 0, -1}, {30, 0, -1}, {30, 30, -1}, {5, 2, -3}}, 50.0);
        for (const double tube : {0.005, 0.03, 0.3}) {
            const auto path = run({takeOf(ticks)}, {{SmoothShape{3.0, tube}}}, context());
            QVERIFY(path);
            const std::vector<glm::dvec3> tips = tipsOf(path->path.points), source = tipsOf(ticks);
            qInfo() << tube << farthestFrom(tips, source) << farthestFrom(source, tips)
                    << path->reports.front().largestDeviation;
            QVERIFY(farthestFrom(tips, source) <= tube + 1e-9);
            QVERIFY(farthestFrom(source, tips) <= tube + 1e-9);
            QVERIFY(path->reports.front().largestDeviation >= farthestFrom(source, tips) - 1e-9);
            QVERIFY(path->reports.front().largestDeviation <= tube + 1e-9);
        }
    }

    /// A stiff curve oscillates before and after a corner, as far as its tube permits: a wavy wall where the hand moved
    /// straight.
    void straightMovesStayStraight() {
        const std::vector<glm::dvec3> corners{{0, 0, 5},   {0, 0, -1},    {20, 0, -1}, {20, 15, -1},
                                              {4, 12, -1}, {4, 11.7, -1}, {18, 5, -1}};
        std::vector<Tick> ticks;
        for (std::size_t i = 1; i < corners.size(); ++i) append(ticks, along({corners[i - 1], corners[i]}, 20.0));
        const auto path = run({takeOf(ticks)}, {{SmoothShape{}}, {Simplify{}}}, context());
        QVERIFY(path);
        const std::vector<glm::dvec3> tips = tipsOf(path->path.points);
        qInfo() << tips.size() << "points, at most" << 1000.0 * farthestFrom(tips, corners) << "um";
        QVERIFY(tips.size() <= corners.size() + 2);
        QVERIFY(farthestFrom(tips, corners) <= 0.003);
        QVERIFY(farthestFrom(corners, tips) <= 0.01 + 0.003);
    }

    /// The tremor between corners is removed nevertheless, also close to them.
    void tremorGoesBetweenCorners_data() {
        QTest::addColumn<double>("margin"); // mm from the corner
        QTest::addColumn<double>("least");  // reduction factor
        QTest::newRow("4 mm away") << 4.0 << 8.0;
        QTest::newRow("up to 0.5 mm") << 0.5 << 5.0;
    }
    void tremorGoesBetweenCorners() {
        QFETCH(double, margin);
        QFETCH(double, least);
        for (unsigned seed = 1; seed <= 5; ++seed) {
            std::vector<Tick> ticks = along({{0, 0, -1}, {40, 0, -1}, {40, 40, -1}}, 15.0);
            tremble(ticks, 0.03, seed);
            const auto path = run({takeOf(ticks)}, {{SmoothShape{3.0, 0.1}}}, context());
            QVERIFY(path);
            const auto roughness = [margin](const std::vector<glm::dvec3>& tips) { // distance from the two lines
                double square = 0.0, count = 0.0;
                for (const glm::dvec3& tip : tips) {
                    if (tip.x > 40.0 - margin && tip.y < margin) continue;
                    const double across = tip.x > 40.0 - margin ? tip.x - 40.0 : tip.y;
                    square += across * across + (tip.z + 1.0) * (tip.z + 1.0);
                    count += 1.0;
                }
                return std::sqrt(square / count);
            };
            const double before = roughness(tipsOf(ticks)), after = roughness(tipsOf(path->path.points));
            qInfo() << "off the lines" << 1000.0 * before << "um down to" << 1000.0 * after;
            QVERIFY(least * after <= before);
        }
    }

    /// Rows as short as the wavelength, as on small parts: the corners of a raster do not preserve the tremor.
    void shortRowsAreSmoothed() {
        for (unsigned seed = 1; seed <= 5; ++seed) {
            std::vector<glm::dvec3> corners;
            for (int row = 0; row < 12; ++row)
                for (const int end : {row % 2, 1 - row % 2}) corners.emplace_back(5.0 * end, 0.8 * row, -1.0);
            std::vector<Tick> ticks = along(corners, 15.0);
            tremble(ticks, 0.01, seed);
            const auto path = run({takeOf(ticks)}, {{SmoothShape{}}}, context());
            QVERIFY(path);
            const auto roughness = [](const std::vector<glm::dvec3>& tips) { // distance from rows, 1 mm off their ends
                double square = 0.0, count = 0.0;
                for (const glm::dvec3& tip : tips) {
                    if (tip.x < 1.0 || tip.x > 4.0) continue;
                    const double across = tip.y - 0.8 * std::round(tip.y / 0.8);
                    square += across * across + (tip.z + 1.0) * (tip.z + 1.0);
                    count += 1.0;
                }
                return std::sqrt(square / count);
            };
            const double before = roughness(tipsOf(ticks)), after = roughness(tipsOf(path->path.points));
            qInfo() << "off the rows" << 1000.0 * before << "um down to" << 1000.0 * after;
            QVERIFY(5.0 * after <= before);
        }
    }

    /// The shape is the same, whatever the hand's timing: at constant speed, and with stops.
    void timeSaysNothingAboutTheShape() {
        const std::vector<glm::dvec3> corners{{0, 0, -1}, {12, 1, -1}, {20, 6, -1.5}, {24, 16, -1}};
        const auto even = run({takeOf(along(corners, 20.0))}, {{SmoothShape{3.0, 0.1}}}, context());
        const auto halting = run({takeOf(withRests(corners, 20.0))}, {{SmoothShape{3.0, 0.1}}}, context());
        QVERIFY(even && halting);
        const double apart = farthestFrom(tipsOf(halting->path.points), tipsOf(even->path.points));
        qInfo() << "apart by" << 1000.0 * apart << "um";
        QVERIFY(apart < 0.002);
    }

    void strokesOfSteadyHandsNeverTurnBack_data() {
        QTest::addColumn<QVector<int>>("edits");
        QTest::newRow("smoothed") << QVector<int>{0};
        QTest::newRow("smoothed, simplified") << QVector<int>{0, 1};
        QTest::newRow("smoothed, held out, simplified") << QVector<int>{0, 2, 1};
        QTest::newRow("smoothed, held out, simplified, corners rounded") << QVector<int>{0, 2, 1, 4};
        QTest::newRow("smoothed, held out, simplified, arcs") << QVector<int>{0, 2, 1, 3};
        QTest::newRow("in time, linked") << QVector<int>{5, 2, 7};
        QTest::newRow("by a spline in time, simplified, linked") << QVector<int>{6, 2, 1, 7};
    }
    void strokesOfSteadyHandsNeverTurnBack() {
        QFETCH(QVector<int>, edits);
        const bool inTime = edits.front() == 5 || edits.front() == 6;
        const std::vector<Edit> kinds{{SmoothShape{}},  {Simplify{}}, {HoldOut{}},      {FitArcs{}},
                                      {RoundCorners{}}, {Smooth{}},   {SmoothSpline{}}, {Link{}}};
        QVERIFY(testing::holdsInShare("no back-step that the hand has not made", [&] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const bool corners = !inTime && *rc::gen::arbitrary<bool>(); // filters in time oscillate around corners
            const std::vector<Tick> ticks = corners ? corneredHand(random) : steadyHand(random);
            RC_PRE(backSteps(tipsOf(ticks)) == 0U);
            std::vector<Edit> list;
            for (const int edit : edits) list.push_back(kinds[static_cast<std::size_t>(edit)]);
            const auto path = run({takeOf(ticks)}, list, context());
            RC_ASSERT(static_cast<bool>(path));
            RC_ASSERT(backSteps(cutsOf(path->path.points)) == 0U);
        }));
    }

    void tremblingHandsLoseTheirBackSteps() {
        QVERIFY(testing::holdsInShare("those within the tolerance", [&] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            std::vector<Tick> ticks = steadyHand(random);
            tremble(ticks, 0.02, static_cast<unsigned>(random()));
            const auto path = run({takeOf(ticks)}, {{SmoothShape{}}, {HoldOut{}}, {Simplify{}}, {Link{}}}, context());
            RC_ASSERT(static_cast<bool>(path));
            // A hand that rests may wander farther than the tolerance: that turn is what it did.
            RC_ASSERT(backSteps(cutsOf(path->path.points), backStepTolerance) == 0U);
        }));
    }

    void handsThatGoBackForReasonStillDo() {
        const std::vector<Tick> ticks = along({{0, 0, -1}, {30, 0, -1}, {10, 0, -1}, {40, 0, -1}}, 40.0);
        const auto path = run({takeOf(ticks)}, {{SmoothShape{}}}, context());
        QVERIFY(path);
        double length = 0.0;
        for (std::size_t i = 1; i < path->path.points.size(); ++i)
            length += glm::distance(path->path.points[i - 1].pose.tip, path->path.points[i].pose.tip);
        QVERIFY(std::abs(length - 80.0) < 0.2);
    }

    void randomStrokesStayInTheTube() {
        QVERIFY(testing::holdsInShare("both ways, whatever the cut-off", [&] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const int count = *rc::gen::inRange(1, 600);
            const double tube = *rc::gen::element(0.0, 0.01, 0.1), wavelength = *rc::gen::element(0.2, 3.0, 50.0);
            const std::vector<Tick> ticks = jitteryHand(random, count);
            const auto path = run({takeOf(ticks)}, {{SmoothShape{wavelength, tube}}}, context());
            RC_ASSERT(static_cast<bool>(path));
            RC_ASSERT(path->path.points.size() == ticks.size());
            const std::vector<glm::dvec3> tips = tipsOf(path->path.points), source = tipsOf(ticks);
            double farthest = 0.0;
            for (const glm::dvec3& tip : tips) farthest = std::max(farthest, distanceToPolyline(tip, source));
            for (const glm::dvec3& tip : source) farthest = std::max(farthest, distanceToPolyline(tip, tips));
            RC_ASSERT(path->reports.front().largestDeviation >= farthest - 1e-9);
            RC_ASSERT(farthest <= tube + 1e-9);
        }));
    }

private:
    PathContext context() const { return contextOf(nothing_, ballTool(), {{-200, -200, -20}, {200, 200, 0}}); }
    const MeshDistance nothing_{TriangleMesh{}};
};

BURIN_TEST(TestSmoothShape, NoApplication)

} // namespace burin::tst_smooth_shape

#include "tst_smooth_shape.moc"
