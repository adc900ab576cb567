// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "hands.h"
#include "path_fixture.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QTest>

namespace burin::tst_smooth_spline {

using namespace burin::test;

class TestSmoothSpline : public QObject {
    Q_OBJECT

private slots:
    void tremorComesDownTwentyTimes() {
        constexpr double tube = 0.2;
        for (unsigned seed = 1; seed <= 5; ++seed) {
            const std::vector<Tick> still = circle(20.0, 15.0, 3.0);
            std::vector<Tick> ticks = still;
            tremble(ticks, 0.05, seed);
            const auto path = run({takeOf(ticks)}, {{SmoothSpline{5.0, tube}}}, context());
            QVERIFY(path);
            const std::vector<glm::dvec3> recorded = tipsOf(ticks), smoothed = tipsOf(path->path.points);
            QCOMPARE(smoothed.size(), recorded.size());
            double before = 0.0;
            for (std::size_t i = 0; i < ticks.size(); ++i) {
                const double shake = glm::distance(recorded[i], still[i].tip);
                before += shake * shake;
                QVERIFY(glm::distance(recorded[i], smoothed[i]) <= tube);
            }
            before = std::sqrt(before / static_cast<double>(ticks.size()));
            const double across = rmsOffCircle(recorded, 20.0), left = rmsOffCircle(smoothed, 20.0);
            qInfo() << 1000.0 * before << "um, across the curve" << 1000.0 * across << "um down to" << 1000.0 * left;
            QVERIFY(std::abs(before - 0.05) < 0.005);
            QVERIFY(20.0 * left <= across);
        }
    }

    void circlesShrinkLessThanByALowPass_data() {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("lowPass"); // mm, removed by a forward and backward Butterworth filter of 5 Hz
        QTest::newRow("radius 5, 50 mm/s") << 5.0 << 50.0 << 0.051;
        QTest::newRow("radius 5, 20 mm/s") << 5.0 << 20.0 << 0.0013;
        QTest::newRow("radius 2, 20 mm/s") << 2.0 << 20.0 << 0.020;
    }
    void circlesShrinkLessThanByALowPass() {
        QFETCH(double, radius);
        QFETCH(double, speed);
        QFETCH(double, lowPass);
        const auto path = run({takeOf(circle(radius, speed, 4.0))}, {{SmoothSpline{5.0, 0.2}}}, context());
        QVERIFY(path);
        const std::vector<glm::dvec3> tips = tipsOf(path->path.points);
        double most = 0.0, atEnds = 0.0; // two periods of the cut-off from the ends, beyond which nothing is known
        for (const glm::dvec3& tip : tips) atEnds = std::max(atEnds, offCircle(tip, radius));
        for (std::size_t i = 400; i + 400 < tips.size(); ++i) most = std::max(most, offCircle(tips[i], radius));
        qInfo() << 1000.0 * most << "um, at the ends" << 1000.0 * atEnds << "um, of" << 1000.0 * lowPass;
        QVERIFY(most <= 0.5 * lowPass);
    }

    void cornersStayWhereTheTubeDemands() {
        const std::vector<Tick> ticks = along({{0, 0, -1}, {30, 0, -1}, {30, 30, -1}, {5, 2, -3}}, 50.0);
        for (const double tube : {0.005, 0.03, 0.3}) {
            const auto path = run({takeOf(ticks)}, {{SmoothSpline{5.0, tube}}}, context());
            QVERIFY(path);
            const std::vector<glm::dvec3> tips = tipsOf(path->path.points), source = tipsOf(ticks);
            QVERIFY(farthestFrom(tips, source) <= tube + 1e-9);
            QVERIFY(farthestFrom(source, tips) <= tube + 1e-9);
            QVERIFY(path->reports.front().largestDeviation >= farthestFrom(source, tips) - 1e-9);
            QVERIFY(path->reports.front().largestDeviation <= tube + 1e-12);
        }
    }

    void straightLinesStayTheyAre() {
        const std::vector<Tick> ticks = along({{0, 0, -1}, {40, 10, -3}}, 30.0);
        const auto path = run({takeOf(ticks)}, {{SmoothSpline{}}}, context());
        QVERIFY(path);
        for (std::size_t i = 0; i < ticks.size(); ++i)
            QVERIFY(glm::distance(path->path.points[i].pose.tip, ticks[i].tip) < 1e-6);
    }

    void randomStrokesStayInTheTube() {
        QVERIFY(rc::check("both ways, at every place, whatever the cut-off", [&] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const int count = *rc::gen::inRange(1, 600);
            const double tube = *rc::gen::element(0.0, 0.01, 0.1), cutOff = *rc::gen::element(0.5, 5.0, 60.0);
            const std::vector<Tick> ticks = jitteryHand(random, count);
            const auto path = run({takeOf(ticks)}, {{SmoothSpline{cutOff, tube}}}, context());
            RC_ASSERT(static_cast<bool>(path));
            RC_ASSERT(path->path.points.size() == ticks.size());
            for (std::size_t i = 0; i < ticks.size(); ++i) // hence every point between, at the same share
                RC_ASSERT(glm::distance(path->path.points[i].pose.tip, ticks[i].tip) <= tube + 1e-12);
        }));
    }

private:
    PathContext context() const { return contextOf(nothing_, ballTool(), {{-50, -50, -20}, {50, 50, 0}}); }
    const MeshDistance nothing_{TriangleMesh{}};
};

BURIN_TEST(TestSmoothSpline, NoApplication)

} // namespace burin::tst_smooth_spline

#include "tst_smooth_spline.moc"
