// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/core/tool/cutters.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>

namespace burin::tst_engagement {

using namespace burin::tests;

namespace {

constexpr double edge = 0.2, radius = 3.0; // mm
// A patch at each end of the arc plus half a voxel, and a ring's height, for these tools: the accuracy stated by
// Engagement.
constexpr double arcTolerance = 0.4, depthTolerance = 0.15; // rad, mm

/// Solid below z = 0.
Grid gridOf(RunAxis axis) {
    return Grid::make({-15.0, -15.0, -10.0}, edge, {150, 150, 50}, axis).value();
}

/// One short move that ends at `tip`; the tool has been in the stock since 6 mm before.
CutResult millTo(RunVolume& workpiece, const Cutter& cutter, const glm::dvec3& tip, const glm::dvec3& direction,
                 const glm::dvec3& axis = {0.0, 0.0, 1.0}, double step = 0.01) {
    MaterialRemoval removal(cutter, workpiece.grid());
    const glm::dvec3 last = tip - step * direction;
    removal.cut(workpiece, {tip - 6.0 * direction, axis}, {last, axis});
    return removal.cut(workpiece, {last, axis}, {tip, axis});
}

bool near(double found, double expected, double tolerance) {
    return std::abs(found - expected) <= tolerance;
}

} // namespace

class EngagementTest : public QObject {
    Q_OBJECT

private slots:
    void cases_data() {
        QTest::addColumn<int>("runs");
        QTest::addColumn<double>("degrees");
        for (const int runs : {0, 1, 2})
            for (const double degrees : {0.0, 90.0, 37.0})
                QTest::addRow("runs along %c, %.0f degrees", "xyz"[runs], degrees) << runs << degrees;
    }

    void aSlotIsHalfTheCircle_data() { cases_data(); }
    void aSlotIsHalfTheCircle() {
        QFETCH(int, runs);
        QFETCH(double, degrees);
        const glm::dvec3 direction(std::cos(degrees * pi / 180.0), std::sin(degrees * pi / 180.0), 0.0);
        for (const double depth : {1.5, 4.0}) {
            RunVolume workpiece = block(gridOf(static_cast<RunAxis>(runs)));
            clearAbove(workpiece, 0.0);
            const Engagement met = millTo(workpiece, flat(6.0, 20.0), {0.03, 0.05, -depth}, direction).engagement;
            QVERIFY2(near(met.arc, pi, arcTolerance), qPrintable(QString::number(met.arc)));
            QVERIFY2(near(met.depth, depth, depthTolerance), qPrintable(QString::number(met.depth)));
            const double area = met.arc * radius * depth;
            QVERIFY2(near(met.area, area, 0.15 * area), qPrintable(QString::number(met.area / area)));
        }
    }

    void halfImmersionIsAQuarterOfTheCircle_data() { cases_data(); }
    void halfImmersionIsAQuarterOfTheCircle() {
        QFETCH(int, runs);
        QFETCH(double, degrees);
        const glm::dvec3 direction(std::cos(degrees * pi / 180.0), std::sin(degrees * pi / 180.0), 0.0);
        RunVolume workpiece = block(gridOf(static_cast<RunAxis>(runs)));
        clearAbove(workpiece, 0.0);
        // A first slot, offset by a radius, leaves half the width to the second.
        const glm::dvec3 aside = radius * glm::dvec3(-direction.y, direction.x, 0.0);
        MaterialRemoval first(flat(6.0, 20.0), workpiece.grid());
        const glm::dvec3 down(0.0, 0.0, -2.0), upright(0.0, 0.0, 1.0);
        first.cut(workpiece, {aside - 12.0 * direction + down, upright}, {aside + 12.0 * direction + down, upright});
        const CutResult cut = millTo(workpiece, flat(6.0, 20.0), {0.0, 0.0, -2.0}, direction);
        QVERIFY2(near(cut.engagement.arc, 0.5 * pi, arcTolerance), qPrintable(QString::number(cut.engagement.arc)));
        QVERIFY2(near(cut.engagement.depth, 2.0, depthTolerance), qPrintable(QString::number(cut.engagement.depth)));
    }

    /// Straight down, the bottom and all around.
    void aPlungeIsTheWholeCircle() {
        for (const int runs : {0, 1, 2}) {
            RunVolume workpiece = block(gridOf(static_cast<RunAxis>(runs)));
            const Engagement met = millTo(workpiece, flat(6.0, 20.0), {0.0, 0.0, -2.0}, {0.0, 0.0, -1.0}).engagement;
            QVERIFY2(near(met.arc, 2.0 * pi, 1e-9), qPrintable(QString::number(met.arc)));
            QVERIFY2(near(met.depth, 0.0, depthTolerance), qPrintable(QString::number(met.depth)));
            QVERIFY2(near(met.area, pi * radius * radius, 0.02 * met.area), qPrintable(QString::number(met.area)));
        }
    }

    /// In solid stock everything that faces the motion cuts: the front half of a sphere.
    void aBallThatLeansMeetsHalfOfItself() {
        for (const int runs : {0, 1, 2}) {
            RunVolume workpiece = block(gridOf(static_cast<RunAxis>(runs)));
            const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, -0.4, 0.87));
            const glm::dvec3 direction = glm::normalize(glm::cross(axis, glm::dvec3(0.3, 0.8, 0.1)));
            const glm::dvec3 tip = glm::dvec3(0.0, 0.0, -6.0);
            // Flutes no longer than the ball: only the sphere.
            const Engagement met = millTo(workpiece, ball(6.0, 3.0), tip, direction, axis).engagement;
            QVERIFY2(near(met.arc, pi, arcTolerance), qPrintable(QString::number(met.arc)));
            QVERIFY2(near(met.depth, radius, 2.0 * depthTolerance), qPrintable(QString::number(met.depth)));
            const double area = pi * radius * radius; // half a hemisphere
            QVERIFY2(near(met.area, area, 0.15 * area), qPrintable(QString::number(met.area / area)));
        }
    }

    /// Half the lateral area of a cone up to its depth in the stock: pi / 2 (R + r) s with the side's length s.
    void aConeInASlotMeetsHalfItsSide() {
        for (const int runs : {0, 1, 2}) {
            RunVolume workpiece = block(gridOf(static_cast<RunAxis>(runs)));
            clearAbove(workpiece, 0.0);
            const double depth = 2.2; // of the cone's 2.5, from a tip of 0.5 mm radius at 45 degrees
            const glm::dvec3 direction(0.8, 0.6, 0.0);
            const Engagement met = millTo(workpiece, cutters::chamfer(), {0.0, 0.0, -depth}, direction).engagement;
            const double area = 0.5 * pi * (0.5 + 0.5 + depth) * depth * std::sqrt(2.0);
            QVERIFY2(near(met.arc, pi, arcTolerance), qPrintable(QString::number(met.arc)));
            QVERIFY2(near(met.depth, depth, 2.0 * depthTolerance), qPrintable(QString::number(met.depth)));
            QVERIFY2(near(met.area, area, 0.15 * area), qPrintable(QString::number(met.area / area)));
        }
    }

    /// Steps of a drawing that are level except for rounding are shoulders: a plunge engages the whole disc.
    void aShoulderThatIsNextToLevelIsOne() {
        const double rounded = std::nextafter(0.3, 1.0);
        for (const double height : {0.3, rounded, 0.3 + 5e-14, 0.3 + 1e-5, 0.3 + 1e-3}) {
            Cutter cutter = cutters::make(CutterType::profile, 10.0, 0.0, 9.0);
            cutter.profile = {{1.0, 0.0}, {2.0, 0.3}, {5.0, height}, {5.0, 9.0}};
            RunVolume workpiece = block(gridOf(RunAxis::z));
            const Engagement met = millTo(workpiece, cutter, {0.0, 0.0, -4.0}, {0.0, 0.0, -1.0}).engagement;
            const double area = pi * (1.0 + 21.0 + 3.0 * std::sqrt(1.0 + 0.09)); // disc, shoulder, cone between
            QVERIFY2(near(met.area, area, 0.05 * area), qPrintable(QString::number(met.area / area)));
        }
    }

    /// Half a sphere between its bottom and its neck: pi R h.
    void aLollipopUnderCutsWithHalfItsSphere() {
        for (const int runs : {0, 1, 2}) {
            RunVolume workpiece = block(gridOf(static_cast<RunAxis>(runs)));
            const Cutter cutter = cutters::lollipop();
            const Engagement met = millTo(workpiece, cutter, {0.0, 0.0, -8.0}, {0.6, -0.8, 0.0}).engagement;
            const double area = pi * radius * cutter.fluteLength;
            QVERIFY2(near(met.arc, pi, arcTolerance), qPrintable(QString::number(met.arc)));
            QVERIFY2(near(met.depth, cutter.fluteLength, 2.0 * depthTolerance), qPrintable(QString::number(met.depth)));
            QVERIFY2(near(met.area, area, 0.15 * area), qPrintable(QString::number(met.area / area)));
        }
    }

    /// On request, engagement is known for a long move and for large balls as well: that of a slot, whatever the step.
    void aLongMoveMeetsWhatAShortOneDoes() {
        for (const int runs : {0, 1, 2})
            for (const Cutter& cutter : {flat(6.0, 20.0), ball(14.0, 20.0)}) {
                const Grid grid = gridOf(static_cast<RunAxis>(runs));
                RunVolume workpiece = block(grid);
                clearAbove(workpiece, 0.0);
                MaterialRemoval removal(cutter, grid, Writing::deferred);
                const ToolPose from{{-5.0, 0.03, -2.0}, {0.0, 0.0, 1.0}}, to{{0.0, 0.05, -2.0}, {0.0, 0.0, 1.0}};
                removal.cut(workpiece, from, to);
                const Engagement met = removal.engagement(workpiece, from, to);
                const double tolerance = cutter.radius() > 30.0 * edge ? 0.5 : arcTolerance;
                QVERIFY2(near(met.arc, pi, tolerance), qPrintable(QString::number(met.arc)));
                QVERIFY2(near(met.depth, 2.0, 2.0 * depthTolerance), qPrintable(QString::number(met.depth)));
            }
    }

    /// Every cut that removes anything reports the engagement: also large balls, and steps too long for the flux.
    void everyCutKnowsItsEngagement_data() {
        QTest::addColumn<double>("diameter");
        QTest::addColumn<double>("step");
        QTest::addRow("large ball") << 14.0 << 0.02;
        QTest::addRow("large ball, long steps") << 14.0 << 0.2;
        QTest::addRow("small ball, long steps") << 6.0 << 0.2;
    }
    void everyCutKnowsItsEngagement() {
        QFETCH(double, diameter);
        QFETCH(double, step);
        RunVolume workpiece = block(gridOf(RunAxis::z));
        clearAbove(workpiece, 0.0);
        MaterialRemoval removal(ball(diameter, 20.0), workpiece.grid(), Writing::deferred);
        const auto cutTo = [&](const glm::dvec3& from, const glm::dvec3& to) {
            return removal.cut(workpiece, from, to);
        };
        // A slot 2 mm deep starting at the stock's side, and another one offset by 0.6 mm: then only the front on the
        // other side cuts.
        glm::dvec3 tip(-15.0 - diameter, 0.03, -2.0);
        int unknown = 0;
        const auto mill = [&](double toX) {
            CutResult last;
            for (; tip.x < toX; tip.x += step) {
                const CutResult cut = cutTo(tip, tip + glm::dvec3(step, 0.0, 0.0));
                if (cut.volume <= 0.0) continue;
                const bool inside = tip.x > -15.0; // not merely touching
                unknown += inside && !(cut.engagement.arc > 0.0 && cut.engagement.area > 0.0) ? 1 : 0;
                last = cut;
            }
            return last;
        };
        const double radius = 0.5 * diameter;
        const Engagement slot = mill(0.0).engagement;
        QVERIFY2(near(slot.arc, pi, 0.5), qPrintable(QString::number(slot.arc)));
        const double halfCap = pi * radius * 2.0;
        QVERIFY2(near(slot.area, halfCap, 0.15 * halfCap), qPrintable(QString::number(slot.area / halfCap)));
        cutTo(tip, {tip.x, 0.03, 30.0});
        tip = {-15.0 - diameter, 0.63, -2.0};
        cutTo({0.0, 0.03, 30.0}, {tip.x, tip.y, 30.0});
        cutTo({tip.x, tip.y, 30.0}, tip);
        const Engagement half = mill(-2.0).engagement;
        QCOMPARE(unknown, 0);
        const double share = half.area / slot.area;
        QVERIFY2(share < 0.7 && share > 0.25, qPrintable(QString::number(share)));
    }

    /// The engagement that a fast cut uses was measured at most 16 cuts ago, whether those were fast or slow.
    void slowCutsBetweenFastOnesCount() {
        RunVolume workpiece = block(gridOf(RunAxis::z));
        clearAbove(workpiece, 0.0);
        MaterialRemoval removal(flat(6.0, 20.0), workpiece.grid(), Writing::deferred);
        glm::dvec3 tip(-10.0, 0.03, -4.0);
        const auto go = [&](const glm::dvec3& step) {
            const CutResult cut = removal.cut(workpiece, tip, tip + step);
            tip += step;
            return cut;
        };
        for (int i = 0; i < 5; ++i) go({0.2, 0.0, 0.0});
        for (int i = 0; i < 300; ++i) go({0.03, 0.0, 0.01}); // up to a depth of 1 mm
        const CutResult fast = go({0.2, 0.0, 0.0});
        QVERIFY(fast.volume > 0.0);
        QVERIFY2(near(fast.engagement.depth, 1.0, 2.0 * depthTolerance),
                 qPrintable(QString::number(fast.engagement.depth)));
    }

    void airAndStandingStillMeetNothing() {
        RunVolume workpiece = block(gridOf(RunAxis::z));
        clearAbove(workpiece, 0.0);
        const Engagement above = millTo(workpiece, flat(6.0, 20.0), {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}).engagement;
        QVERIFY(above.arc == 0.0 && above.depth == 0.0 && above.area == 0.0);
        MaterialRemoval removal(flat(6.0, 20.0), workpiece.grid());
        removal.cut(workpiece, glm::dvec3(0.0, 0.0, 5.0), glm::dvec3(0.0, 0.0, -2.0));
        const Engagement still =
            removal.cut(workpiece, glm::dvec3(0.0, 0.0, -2.0), glm::dvec3(0.0, 0.0, -2.0)).engagement;
        QVERIFY(still.arc == 0.0 && still.depth == 0.0 && still.area == 0.0);
    }

private:
    static void clearAbove(RunVolume& workpiece, double height) {
        const Grid& all = workpiece.grid();
        for (LineIndex line; line.v < all.lineCountV(); ++line.v)
            for (line.u = 0; line.u < all.lineCountU(); ++line.u) {
                if (all.axisOfRuns() == 2) {
                    (void)workpiece.fillSpan(line, all.toRunPosition(height), all.lineEnd(), airProperty);
                    continue;
                }
                const glm::dvec2 middle = all.lineCentre(line);
                if ((all.axisOfU() == 2 ? middle.x : middle.y) > height)
                    (void)workpiece.fillSpan(line, 0, all.lineEnd(), airProperty);
            }
    }
};

BURIN_TEST(EngagementTest, NoApplication)

} // namespace burin::tst_engagement

#include "tst_engagement.moc"
