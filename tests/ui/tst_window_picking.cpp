// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// A click on a path selects the point under the pointer, on a line and on an arc.
#include "core/geometry/arc.h"
#include "core/path/hand_interval.h"
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/input/mill_tool.h"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_window_picking {

using namespace burin::testing;

namespace {

/// Records a stroke round the middle of the stock's top: three quarters of a circle with this radius, mm.
bool recordCircle(WindowDriver& driver, double radius) {
    Workbench& workbench = driver.window().workbench();
    Viewport& viewport = driver.window().viewport();
    if (!driver.step(JobStep::mill) || !driver.clickOn("millButton")) return false;
    if (!driver.waitFor([&] { return workbench.mill.active(); })) return false;
    const glm::dvec3 zero = workbench.setup.setup().workOffset;
    const auto at = [&](int degrees) {
        const double angle = degrees * M_PI / 180.0;
        return viewport.project(zero + radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0)).toPoint();
    };
    QTest::mouseMove(&viewport, at(0));
    QTest::qWait(300);
    QTest::mousePress(&viewport, Qt::LeftButton, {}, at(0));
    for (int degrees = 0; degrees <= 270; degrees += 3) QTest::mouseMove(&viewport, at(degrees), 15);
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, at(270));
    if (!driver.waitFor([&] { return workbench.workpiece.strokes().count() == 1; })) return false;
    driver.key(Qt::Key_Escape);
    return driver.waitFor([&] { return !workbench.session.running(); });
}

QString escapeLabel(WindowDriver& driver) {
    auto* label = driver.visible<QLabel>("escapeStatus");
    return label != nullptr ? label->text() : QString();
}

} // namespace

class TestWindowPicking : public QObject {
    Q_OBJECT
private slots:
    /// A straight groove has few points; a click between them selects the position that was clicked.
    void aPlaceBetweenTwoPointsIsChosen() {
        WindowDriver driver(QSize(1280, 920)); // as high a resolution as without the timeline
        Workbench& workbench = driver.window().workbench();
        QVERIFY(makeReady(driver) && recordLine(driver, {-15, 0}, {15, 0}) && newPath(driver));
        // A path that is evaluated again meanwhile gets other points.
        QVERIFY(driver.waitFor([&] { return !workbench.path.busy() && !workbench.path.outdated(); }));
        auto* viewport = driver.visible<Viewport>("viewport");
        const std::shared_ptr<const EvaluatedPath> evaluated = workbench.path.evaluated();
        const std::vector<PathPoint>& points = evaluated->path.points;
        std::size_t longest = 0;
        double length = 0.0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double way = glm::distance(points[i - 1].pose.tip, points[i].pose.tip);
            if (!hasMoment(points[i - 1]) || !hasMoment(points[i]) || points[i].kind != MoveKind::cut || way < length)
                continue;
            longest = i;
            length = way;
        }
        QVERIFY2(length > 1.2, qPrintable(QString::number(length)));
        // Ticks that a busy machine missed left no recorded position to choose.
        const TakeInfo& take = workbench.mill.takes().front();
        const double missed = std::max(0.0, *take.seconds - static_cast<double>(take.sampleCount) * take.tickPeriod);
        const double nearest = 0.3 + missed * MillToolSettings{}.speed;
        for (const double share : {0.25, 0.4, 0.7}) {
            const glm::dvec3 meant = glm::mix(points[longest - 1].pose.tip, points[longest].pose.tip, share);
            QTest::mouseClick(viewport, Qt::LeftButton, {}, viewport->project(meant).toPoint());
            QVERIFY(workbench.path.selection());
            const auto chosen = pointsOf(workbench.path.evaluated()->path, *workbench.path.selection());
            QVERIFY(!chosen.empty());
            const double off = glm::distance(chosen.front().front().pose.tip, meant);
            QVERIFY2(off < nearest, qPrintable(QStringLiteral("%1 of %2").arg(off).arg(nearest))); // a pixel is 0.3 mm
        }
        QVERIFY(driver.waitFor([&] { return driver.visible<QLabel>("pathSelection") != nullptr; }));
        QTest::qWait(100);
        // The time of the recording at that point. A take that missed ticks lasts longer than its ticks.
        const QString told = driver.visible<QLabel>("pathSelection")->text();
        const auto time = QRegularExpression(QStringLiteral("([0-9.]+) s(?: |$)")).match(told);
        QVERIFY2(time.hasMatch(), qPrintable(told));
        const double ticks = static_cast<double>(workbench.path.selection()->first) * take.tickPeriod;
        QVERIFY2(std::abs(time.captured(1).toDouble() - ticks) < 0.051 + missed, qPrintable(told));
        driver.shoot("46-place-between");
    }

    /// Seen from above and obliquely: a click on a drawn arc selects that point of it, with its time in the recording;
    /// a click on the middle of the chord, where nothing is drawn, selects nothing. Esc does what the status line says.
    BURIN_ONLY_IN_LONG_RUNS void aPlaceOnAFittedArcIsChosen() {
        WindowDriver driver(QSize(1280, 920)); // as high a resolution as without the timeline
        Workbench& workbench = driver.window().workbench();
        QVERIFY(makeReady(driver));
        Viewport& viewport = driver.window().viewport();
        viewport.setStandardView(StandardView::top);
        QTest::qWait(400); // the view turns
        QVERIFY(recordCircle(driver, 9.0));
        QVERIFY(newPath(driver)); // fits arcs
        QVERIFY(driver.waitFor([&] { return !workbench.path.busy() && !workbench.path.outdated(); }));
        const std::shared_ptr<const EvaluatedPath> evaluated = workbench.path.evaluated();
        const std::vector<PathPoint>& points = evaluated->path.points;
        std::size_t largest = 0;
        Arc arc;
        for (std::size_t i = 1; i < points.size(); ++i) {
            if (!points[i].arc || !hasMoment(points[i - 1]) || !hasMoment(points[i])) continue;
            const PathArc& turn = *points[i].arc;
            const Arc candidate{points[i - 1].pose.tip, points[i].pose.tip, turn.centre, turn.axis, turn.clockwise};
            if (turn.axis != 2 || turnOf(candidate).startRadius < 3.0) continue; // part of a descent
            if (largest != 0 && std::abs(turnOf(candidate).sweep) < std::abs(turnOf(arc).sweep)) continue;
            largest = i;
            arc = candidate;
        }
        QVERIFY(largest != 0);
        const ArcTurn turn = turnOf(arc);
        QVERIFY2(std::abs(turn.sweep) > 0.3, qPrintable(QString::number(turn.sweep)));
        QTRY_COMPARE(escapeLabel(driver), QString());
        for (const StandardView view : {StandardView::top, StandardView::isometric}) {
            viewport.setStandardView(view);
            QTest::qWait(500);
            for (const double share : {0.2, 0.5, 0.85}) {
                const double angle = turn.startAngle + share * turn.sweep;
                const glm::dvec3 meant(arc.centre.x + turn.startRadius * std::cos(angle),
                                       arc.centre.y + turn.startRadius * std::sin(angle), arc.from.z);
                QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.project(meant).toPoint());
                QVERIFY(workbench.path.selection());
                const double ticks = static_cast<double>(points[largest].sample - points[largest - 1].sample);
                const double told =
                    static_cast<double>(workbench.path.selection()->first - points[largest - 1].sample) / ticks;
                const double pixel = 0.4 / (turn.startRadius * std::abs(turn.sweep)); // as a share of the arc
                QVERIFY2(std::abs(told - share) < pixel + 1.0 / ticks, qPrintable(QString::number(told)));
                const auto chosen = pointsOf(workbench.path.evaluated()->path, *workbench.path.selection());
                QVERIFY(!chosen.empty() && glm::distance(chosen.front().front().pose.tip, meant) < 0.4);
            }
            QTRY_COMPARE(escapeLabel(driver), QStringLiteral("Esc: clear the selection"));
            driver.shoot(view == StandardView::top ? "picking-arc-top" : "picking-arc-aslant");
            driver.key(Qt::Key_Escape);
            QVERIFY(driver.waitFor([&] { return !workbench.path.selection(); }));
            QTRY_COMPARE(escapeLabel(driver), QString());
        }
    }
};

BURIN_TEST(TestWindowPicking, QApplication)

} // namespace burin::tst_window_picking

#include "tst_window_picking.moc"
