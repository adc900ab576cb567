// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/scene/viewport.h"

#include <QAction>
#include <QComboBox>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>

namespace burin::tst_window_section {

using namespace burin::testing;

namespace {

bool evaluatedNow(const WindowDriver& driver, const Workbench& workbench) {
    return driver.waitFor(
        [&] { return !workbench.path.busy() && !workbench.path.outdated() && !workbench.path.problem(); });
}

/// Returns the recorded path point nearest to a position along X. @param x mm from program zero
PathPoint pointAt(const Workbench& workbench, double x) {
    const std::vector<PathPoint>& points = workbench.path.evaluated()->path.points;
    const double zero = workbench.workpiece.milling()->setup.workOffset.x;
    return *std::ranges::min_element(points, {}, [&](const PathPoint& point) {
        const bool cuts = point.kind == MoveKind::cut && point.sample >= 0;
        return cuts ? std::abs(point.pose.tip.x - zero - x) : 1e9;
    });
}

/// Returns the place of an edit in the list, its end if there is none.
std::size_t placeOf(const Workbench& workbench, std::string_view id) {
    const std::vector<Edit>& edits = workbench.path.stored()->edits;
    return static_cast<std::size_t>(
        std::ranges::find(edits, id, [](const Edit& edit) { return idOf(edit.parameters); }) - edits.begin());
}
std::size_t placeOfSection(const Workbench& workbench) {
    return placeOf(workbench, "section");
}

void select(WindowDriver& driver, const PathPoint& from, const PathPoint& to) {
    auto* viewport = driver.visible<Viewport>("viewport");
    QTest::mouseClick(viewport, Qt::LeftButton, {}, viewport->project(from.pose.tip).toPoint());
    QTest::mouseClick(viewport, Qt::LeftButton, Qt::ShiftModifier, viewport->project(to.pose.tip).toPoint());
}

} // namespace

/// A part of the path gets its own spindle speed and coolant, and its own tool axis, by mouse and keys.
class TestWindowSection : public QObject {
    Q_OBJECT
private slots:
    void aPartTurnsSlowerAndIsCooled() {
        WindowDriver driver(QSize(1280, 920));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(makeReady(driver) && recordLine(driver, {-15, 0}, {15, 0}) && newPath(driver));
        QVERIFY(evaluatedNow(driver, workbench));
        QVERIFY(postProgram(driver));
        const QString before = workbench.program.storedText();
        QVERIFY(driver.step(JobStep::path));
        QVERIFY(driver.settle());
        auto* viewport = driver.visible<Viewport>("viewport");
        QVERIFY(viewport != nullptr);
        QCOMPARE(workbench.path.evaluated()->path.coolant, Coolant::off);

        const PathPoint from = pointAt(workbench, -6.0), to = pointAt(workbench, 6.0);
        select(driver, from, to);
        QVERIFY(workbench.path.selection() && workbench.path.selection()->last > workbench.path.selection()->first);
        driver.window().findChild<QAction*>("add-section")->trigger();
        QVERIFY(driver.waitFor([&] { return placeOfSection(workbench) < workbench.path.stored()->edits.size(); }));
        QCOMPARE(placeOfSection(workbench), workbench.path.stored()->edits.size() - 1);
        QVERIFY(evaluatedNow(driver, workbench));
        const auto field = [&](const char* key) {
            return QStringLiteral("edit%1_%2").arg(placeOfSection(workbench)).arg(key).toLatin1();
        };
        const auto edit = [&] {
            return std::get<SpindleAndCoolant>(workbench.path.stored()->edits[placeOfSection(workbench)].parameters);
        };
        QCOMPARE(edit().interval, *workbench.path.selection());
        QVERIFY(driver.enter(field("speed_rpm"), QStringLiteral("4000")));
        QVERIFY(driver.waitFor([&] { return edit().speed == 4000.0; }));
        QVERIFY(evaluatedNow(driver, workbench));
        auto* coolant = driver.visible<QComboBox>(field("coolant"));
        QVERIFY(driver.waitFor([&] { return coolant != nullptr && coolant->isEnabled(); }));
        coolant->setFocus();
        driver.key(Qt::Key_End);
        QVERIFY(driver.waitFor([&] { return edit().cooling == SpindleAndCoolant::Cooling::flood; }));
        QVERIFY(evaluatedNow(driver, workbench));
        driver.shoot("32-section");

        // The changes apply between the two points, and nowhere else.
        const Path& path = workbench.path.evaluated()->path;
        double low = 1e9, high = -1e9;
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const PathPoint& point = path.points[i];
            QCOMPARE(point.coolant.has_value(), point.spindleSpeed == 4000.0);
            if (!point.coolant) continue;
            low = std::min({low, path.points[i - 1].pose.tip.x, point.pose.tip.x});
            high = std::max({high, path.points[i - 1].pose.tip.x, point.pose.tip.x});
        }
        QVERIFY2(std::abs(low - from.pose.tip.x) < 0.1 && std::abs(high - to.pose.tip.x) < 0.1,
                 qPrintable(QStringLiteral("%1 %2").arg(low).arg(high)));
        QVERIFY(postProgram(driver));
        const QString after = workbench.program.storedText();
        QCOMPARE(after.count("\nS4000 M3\nM8\n"), 1);
        QCOMPARE(after.count(QStringLiteral("\nS%1 M3\nM9\n").arg(path.spindleSpeed, 0, 'f', 0)), 1);
        QVERIFY(driver.step(JobStep::path));

        // A speed outside the range of the machine is refused; each step can be undone.
        QVERIFY(driver.enter(field("speed_rpm"), QStringLiteral("900000")));
        QVERIFY(driver.waitFor([&] { return workbench.path.problem().has_value(); }));
        QCOMPARE(workbench.path.problem()->code, ErrorCode::programLimit);
        driver.shoot("33-section-refused");
        for (int i = 0; i < 4; ++i) driver.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(driver.waitFor([&] { return placeOfSection(workbench) == workbench.path.stored()->edits.size(); }));
        QVERIFY(evaluatedNow(driver, workbench));
        QVERIFY(postProgram(driver));
        QCOMPARE(workbench.program.storedText(), before);
        tilt(driver, workbench, from, to);
    }

private:
    /// On a machine with rotary axes the tool leans ahead by 15° between the two points and is upright elsewhere; the
    /// program turns the axes. A machine without them is refused; each step can be undone.
    void tilt(WindowDriver& driver, Workbench& workbench, const PathPoint& from, const PathPoint& to) {
        workbench.target.chooseMachine("linuxcnc-five-axis");
        QVERIFY(driver.step(JobStep::path));
        QVERIFY(evaluatedNow(driver, workbench));
        const std::size_t edits = workbench.path.stored()->edits.size();
        select(driver, from, to);
        driver.window().findChild<QAction*>("add-tool-axis")->trigger();
        QVERIFY(driver.waitFor([&] { return workbench.path.stored()->edits.size() == edits + 1; }));
        QCOMPARE(placeOf(workbench, "tool-axis"), edits);
        QVERIFY(evaluatedNow(driver, workbench));
        const auto edit = [&] { return std::get<ToolAxis>(workbench.path.stored()->edits.back().parameters); };
        QCOMPARE(edit().interval, *workbench.path.selection());
        const QByteArray lead = QStringLiteral("edit%1_lead_rad").arg(edits).toLatin1();
        QVERIFY(driver.enter(lead, QStringLiteral("15")));
        const double angle = 15.0 * pi / 180.0;
        QVERIFY(driver.waitFor([&] { return std::abs(edit().lead - angle) < 1e-9; }));
        QVERIFY(evaluatedNow(driver, workbench));
        driver.shoot("34-tool-axis");
        const double radius = workbench.workpiece.milling()->tool.cutter.radius();
        double most = 0.0;
        for (const PathPoint& point : workbench.path.evaluated()->path.points) {
            const glm::dvec3& axis = point.pose.axis;
            QVERIFY(std::abs(axis.y) <= 0.05 * axis.x); // ahead: a stroke by mouse goes along X to a pixel
            most = std::max(most, std::hypot(axis.x, axis.y));
            if (point.pose.tip.x < from.pose.tip.x - 2.0 * radius || point.pose.tip.x > to.pose.tip.x + 2.0 * radius)
                QCOMPARE(axis, glm::dvec3(0.0, 0.0, 1.0));
        }
        QVERIFY2(std::abs(most - std::sin(angle)) < 1e-9, qPrintable(QString::number(most)));
        QVERIFY(postProgram(driver));
        QVERIFY(workbench.program.storedText().contains(QRegularExpression(" A-?15\\b")));
        driver.shoot("35-tool-axis-program");
        QVERIFY(driver.step(JobStep::path));
        workbench.target.chooseMachine("linuxcnc-mill");
        QVERIFY(driver.waitFor([&] { return workbench.path.problem().has_value(); }));
        QCOMPARE(workbench.path.problem()->code, ErrorCode::notSupported);
        driver.shoot("36-tool-axis-refused");
        for (int i = 0; i < 8 && workbench.path.stored()->edits.size() != edits; ++i)
            driver.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(driver.waitFor([&] { return workbench.path.stored()->edits.size() == edits; }));
        QVERIFY(evaluatedNow(driver, workbench));
    }
};

BURIN_TEST(TestWindowSection, QApplication)

} // namespace burin::tst_window_section

#include "tst_window_section.moc"
