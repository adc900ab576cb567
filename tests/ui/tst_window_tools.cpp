// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/notice.h"
#include "ui/panels/step_button.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_tools {

using namespace burin::testing;

namespace {

/// Makes the path of the current tool.
bool makePath(WindowDriver& driver) {
    Workbench& workbench = driver.window().workbench();
    return driver.step(JobStep::path) && driver.clickOn("newPathButton") &&
           driver.waitFor([&] { return workbench.path.evaluated() && !workbench.path.outdated(); }) && driver.settle();
}

bool useTool(WindowDriver& driver, const char* id) {
    Workbench& workbench = driver.window().workbench();
    workbench.tool.choose(id);
    return driver.waitFor([&] {
        return workbench.workpiece.ready() && workbench.workpiece.milling()->tool.id == id;
    }) && driver.settle();
}

QStringList toolChanges(const Workbench& workbench) {
    QStringList tools;
    auto match = QRegularExpression("^T(\\d+) M6", QRegularExpression::MultilineOption)
                     .globalMatch(workbench.program.storedText());
    while (match.hasNext()) tools.append(match.next().captured(1));
    return tools;
}

} // namespace

/// A job of two tools in the window: each has its path, the program has both.
class TestWindowTools : public QObject {
    Q_OBJECT
private slots:
    void eachToolHasItsPathAndTheProgramHasThemAll();
    BURIN_ONLY_IN_LONG_RUNS void aLaterToolSeesWhatAnEarlierOneLeft();
    BURIN_ONLY_IN_LONG_RUNS void oneClickMakesThePathsOfAllTools();
};

void TestWindowTools::eachToolHasItsPathAndTheProgramHasThemAll() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    QCOMPARE(workbench.tool.current().id, std::string("ball-6"));
    QVERIFY(recordLine(driver, {-15, -5}, {15, -5}));
    QVERIFY(makePath(driver));
    const auto ball = workbench.path.evaluated();
    QVERIFY(postProgram(driver));
    QCOMPARE(toolChanges(workbench), QStringList{"3"});
    const auto listed = [&](const char* name) { // "" if there is no such row
        const auto* row = driver.visible<QCheckBox>(name);
        return row != nullptr ? row->accessibleName() : QString();
    };
    QTRY_VERIFY(listed("programPath0Switch").contains(QStringLiteral("6 mm")));
    QVERIFY(!driver.visible("programPath0Switch")->isEnabled()); // with one tool there is no choice
    const QPoint fields = driver.visible("machineChoice")->mapToGlobal(QPoint());

    // The other tool has no path yet, and the program says so.
    QVERIFY(useTool(driver, "flat-10"));
    QVERIFY(workbench.path.stored() == nullptr && !workbench.program.outdated());
    QVERIFY(recordLine(driver, {-15, 5}, {15, 5}));
    QVERIFY(driver.step(JobStep::program));
    QTRY_VERIFY(listed("programPath1Switch").contains(QStringLiteral("10 mm")));
    QVERIFY(!driver.visible("programPath1Switch")->isEnabled() &&
            !driver.visible<QCheckBox>("programPath1Switch")->isChecked());
    QCOMPARE(driver.visible<ElidedLabel>("programPath1News")->text(), QStringLiteral("no path"));
    driver.shoot("29-tool-without-path");
    QVERIFY(workbench.program.outdated());
    QVERIFY(makePath(driver));
    QVERIFY(workbench.path.evaluated()->path.toolId == "flat-10");
    QVERIFY(driver.step(JobStep::program));
    QTRY_VERIFY(driver.visible("programPath1Switch") != nullptr && driver.visible("programPath1Switch")->isEnabled());
    QVERIFY(postProgram(driver));
    QCOMPARE(toolChanges(workbench), (QStringList{"7", "3"})); // the larger tool comes first
    QVERIFY(workbench.program.exportable());
    driver.shoot("30-two-tools");
    // The list has the order of the program, and nothing has moved.
    QVERIFY2(listed("programPath0Switch").contains(QStringLiteral("10 mm")), qPrintable(listed("programPath0Switch")));
    QVERIFY2(listed("programPath1Switch").contains(QStringLiteral("6 mm")), qPrintable(listed("programPath1Switch")));
    QTRY_COMPARE(driver.visible("machineChoice")->mapToGlobal(QPoint()), fields); // laid out once updates have arrived

    // With one path left out, the program of the other one is checked with its own tool, whichever tool is current.
    QVERIFY(driver.clickOn("programPath0Switch"));
    QVERIFY(workbench.program.outdated());
    QVERIFY(postProgram(driver));
    QCOMPARE(toolChanges(workbench), QStringList{"3"});
    QCOMPARE(workbench.program.program()->tools.front().id, std::string("ball-6"));
    QVERIFY(workbench.program.exportable());
    QVERIFY(driver.clickOn("programPath0Switch"));

    // A change while the program is posted makes it out of date when it arrives; once the change is undone, it is up to
    // date again.
    const auto before = workbench.program.program();
    QVERIFY(driver.clickOn("postButton"));
    workbench.target.chooseUnits(NcUnits::inch);
    QVERIFY(driver.waitFor([&] { return workbench.program.program() != before && !workbench.program.busy(); }));
    QVERIFY(workbench.program.outdated() && !workbench.program.exportable());
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(workbench.program.exportable());
    const double tolerance = workbench.program.gougeTolerance();
    workbench.program.setGougeTolerance(0.5 * tolerance);
    QVERIFY(!workbench.program.exportable());
    workbench.program.setGougeTolerance(tolerance);
    QVERIFY(workbench.program.exportable());

    // Inches, and back.
    QVERIFY(driver.waitFor([&] { return driver.visible<QComboBox>("programUnits") != nullptr; }));
    auto* units = driver.visible<QComboBox>("programUnits");
    QTRY_COMPARE(units->currentIndex(), 0); // panels follow a moment later
    units->setFocus();
    QTest::keyClick(units, Qt::Key_Down);
    QTRY_VERIFY(workbench.target.target().units == NcUnits::inch);
    QVERIFY(postProgram(driver));
    QVERIFY(workbench.program.storedText().contains("G20") && workbench.program.exportable());
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(workbench.target.target().units == NcUnits::millimetre);

    // Each tool keeps its path and its edits.
    QVERIFY(useTool(driver, "ball-6"));
    QVERIFY(driver.waitFor([&] { return workbench.path.evaluated() && !workbench.path.outdated(); }));
    QCOMPARE(workbench.path.evaluated()->path.points.size(), ball->path.points.size());
    QVERIFY(driver.waitFor([&] { return driver.settle(); }));
}

/// Two tools milled before a path was requested: the program includes both, and one undo removes both paths.
void TestWindowTools::oneClickMakesThePathsOfAllTools() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    QVERIFY(recordLine(driver, {-15, -5}, {15, -5}));
    QVERIFY(useTool(driver, "flat-10"));
    QVERIFY(recordLine(driver, {-15, 5}, {15, 5}));
    QVERIFY(makePath(driver));
    QCOMPARE(workbench.path.jobPaths().size(), std::size_t{2});
    QVERIFY(workbench.path.toolsWithoutPath().empty());
    QVERIFY(postProgram(driver));
    QCOMPARE(toolChanges(workbench), (QStringList{"7", "3"}));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(workbench.path.jobPaths().empty());
    QCOMPARE(workbench.path.toolsWithoutPath().size(), std::size_t{2});
    driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(workbench.path.jobPaths().size(), std::size_t{2});

    // For a tool that has not milled, the panel says so and leads to those that have.
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(workbench.path.jobPaths().empty());
    QVERIFY(useTool(driver, "flat-3"));
    QVERIFY(driver.step(JobStep::path));
    QTRY_VERIFY(driver.visible<QComboBox>("pathTool") != nullptr);
    driver.shoot("29-tool-that-has-not-milled");
    QVERIFY(driver.clickOn("newPathButton"));
    QTRY_COMPARE(workbench.path.jobPaths().size(), std::size_t{2});
    const QList<StepButton*> steps = driver.window().findChildren<StepButton*>();
    const auto pathStep = std::ranges::find(steps, JobStep::path, &StepButton::step);
    QVERIFY(pathStep != steps.end()); // no path is missing
    QTRY_COMPARE((*pathStep)->accessibleDescription(), QStringLiteral("done: 2 paths"));
    auto* choice = driver.visible<QComboBox>("pathTool");
    QVERIFY(choice != nullptr);
    QCOMPARE(choice->count(), 2);
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_End);
    QTRY_COMPARE(workbench.tool.current().id, std::string("flat-10"));
    QVERIFY(driver.waitFor([&] { return workbench.path.evaluated() && !workbench.path.busy(); }));
}

/// Two tools in one groove: the larger one is milled first, whichever was recorded first.
void TestWindowTools::aLaterToolSeesWhatAnEarlierOneLeft() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver, 0.2));
    QVERIFY(recordLine(driver, {-15, 0}, {15, 0}));
    QVERIFY(makePath(driver));
    const glm::dvec3 zero = workbench.workpiece.milling()->setup.workOffset;
    const double top = workbench.workpiece.milling()->setup.stock.high.z;
    const auto levelled = [&] {
        return driver.waitFor(
            [&] { return workbench.path.evaluated() && !workbench.path.outdated() && !workbench.path.busy(); });
    };
    /// The point of the cut that crosses an X position relative to program zero.
    const auto cutOver = [&](const EvaluatedPath& path, double x) {
        const std::vector<PathPoint>& points = path.path.points;
        for (std::size_t i = 1; i < points.size(); ++i)
            if (points[i].kind == MoveKind::cut &&
                (points[i - 1].pose.tip.x - zero.x - x) * (points[i].pose.tip.x - zero.x - x) <= 0)
                return points[i];
        return PathPoint{};
    };
    const auto postedOver = [&](double x) { // mm/min, of the ball's cut there, read from the text of the program
        for (const NcMotion& motion : workbench.program.program()->parsed.motions)
            if ((motion.kind == NcMotionKind::line || motion.kind == NcMotionKind::arc) && motion.tool == 3 &&
                motion.from[Axis::z] < -0.5 && motion.to[Axis::z] < -0.5 &&
                (motion.from[Axis::x] - x) * (motion.to[Axis::x] - x) <= 0)
                return motion.feed;
        return 0.0;
    };

    // A constant removal rate for a single tool: the section of the ball's groove times the feed.
    FeedOptimisation level;
    level.goal = FeedOptimisation::Goal::removal;
    level.target = 50.0; // mm³/s
    workbench.path.addEdit({level});
    QVERIFY(levelled());
    const EvaluatedPath alone = *workbench.path.evaluated();
    const double depth = top - cutOver(alone, 0.0).pose.tip.z, side = 3.0 - depth;
    const double section = 9.0 * std::acos(side / 3.0) - side * std::sqrt(9.0 - side * side);
    const double inStock = 60.0 * level.target / section;
    const double air =
        std::min(workbench.workpiece.milling()->machine.maximumFeed,
                 alone.path.spindleSpeed * workbench.workpiece.milling()->tool.fluteCount * level.largestChip);
    QVERIFY2(std::abs(cutOver(alone, 0.0).feed / inStock - 1.0) < 0.2 && air > 2.0 * inStock,
             qPrintable(QString("%1 %2 %3").arg(cutOver(alone, 0.0).feed).arg(inStock).arg(air)));

    // The same groove with a flat end mill of 10 mm, equally deep: nothing is left for the ball.
    QVERIFY(useTool(driver, "flat-10"));
    QVERIFY(recordLine(driver, {-15, 0}, {15, 0}));
    QVERIFY(makePath(driver));
    const auto isBehind = [&](const std::shared_ptr<const EvaluatedPath>& large) {
        const auto others = workbench.path.others();
        return others.size() == 1 && others.front()->path.toolId == "ball-6" &&
               others.front()->after == std::vector{large};
    };
    QVERIFY(driver.waitFor([&] { return isBehind(workbench.path.evaluated()); }));
    driver.shoot("32-other-tools-path");
    const auto* shown = menuAction(driver, "showOtherPathsAction");
    QVERIFY(shown != nullptr && shown->isChecked() && !shown->toolTip().isEmpty());
    auto* viewport = driver.visible<Viewport>("viewport");
    QTest::qWait(800); // until full detail is drawn
    const QImage with = viewport->grabFramebuffer();
    driver.key(Qt::Key_6, Qt::ControlModifier);
    QVERIFY(!shown->isChecked());
    QVERIFY(driver.waitFor([&] { return viewport->grabFramebuffer() != with; }));
    driver.key(Qt::Key_6, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return viewport->grabFramebuffer() == with; }));

    // The ball's feed is that in a groove that is already cut; the program's text has the same feed.
    QVERIFY(useTool(driver, "ball-6"));
    QVERIFY(levelled());
    const double behind = cutOver(*workbench.path.evaluated(), 0.0).feed;
    QVERIFY2(behind > 0.9 * air && behind <= air + 1e-6, qPrintable(QString("%1 %2").arg(behind).arg(air)));
    QVERIFY(postProgram(driver));
    QVERIFY(workbench.program.exportable());
    QVERIFY2(std::abs(postedOver(0.0) - behind) < 1.0, qPrintable(QString::number(postedOver(0.0))));

    // Without the large tool's path the ball cuts everything in the program.
    QVERIFY(driver.step(JobStep::program));
    QVERIFY(driver.waitFor([&] { return driver.visible("programPath1Switch") != nullptr; }));
    QVERIFY(driver.clickOn("programPath0Switch"));
    QVERIFY(postProgram(driver));
    QVERIFY(workbench.program.exportable());
    QVERIFY2(std::abs(postedOver(0.0) - cutOver(alone, 0.0).feed) < 1.0, qPrintable(QString::number(postedOver(0.0))));
    QVERIFY(driver.clickOn("programPath0Switch"));

    // A change of the large tool's path changes the ball's feed: the stock on the left is there again.
    QVERIFY(useTool(driver, "flat-10"));
    QVERIFY(levelled());
    RemoveArea left;
    for (const glm::dvec2& corner : {glm::dvec2(-30, -30), glm::dvec2(0, -30), glm::dvec2(0, 30), glm::dvec2(-30, 30)})
        left.outline.push_back(zero + glm::dvec3(corner, 0.0));
    workbench.path.addEdit({left});
    QVERIFY(levelled());
    QVERIFY(driver.waitFor([&] { return isBehind(workbench.path.evaluated()); }));
    const EvaluatedPath& again = *workbench.path.others().front();
    QVERIFY2(std::abs(cutOver(again, -10.0).feed / inStock - 1.0) < 0.2,
             qPrintable(QString::number(cutOver(again, -10.0).feed)));
    QVERIFY2(cutOver(again, 8.0).feed > 0.9 * air, qPrintable(QString::number(cutOver(again, 8.0).feed)));

    // The large tool's path is empty: the ball has to cut everything, and its panel says why.
    RemoveArea right = left;
    for (glm::dvec3& corner : right.outline) corner.x = 2.0 * zero.x - corner.x;
    workbench.path.addEdit({right});
    QVERIFY(driver.waitFor([&] { return workbench.path.problem() && !workbench.path.busy(); }));
    QVERIFY(useTool(driver, "ball-6"));
    QVERIFY(levelled());
    QVERIFY(std::abs(cutOver(*workbench.path.evaluated(), 8.0).feed / inStock - 1.0) < 0.2);
    QVERIFY(driver.step(JobStep::path));
    QVERIFY(driver.waitFor([&] { return driver.visible("pathNotice") != nullptr; }));
    QTRY_VERIFY(driver.visible<Notice>("pathNotice")->sentence().contains(QStringLiteral("10 mm")));
    QVERIFY(driver.visible<Notice>("pathNotice")->kind() == Notice::Kind::warning);
    driver.shoot("33-path-before-impossible");
    QCOMPARE(workbench.path.toolsMissingBefore(), std::vector<std::string>{"flat-10"});
    QVERIFY(useTool(driver, "ball-10")); // without a path, no earlier tool is missing
    QVERIFY(workbench.path.stored() == nullptr && workbench.path.toolsMissingBefore().empty());
}

BURIN_TEST(TestWindowTools, QApplication)

} // namespace burin::tst_window_tools

#include "tst_window_tools.moc"
