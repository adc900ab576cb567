// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/window_steps.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QtTest>

using namespace burin;
using namespace burin::testing;

namespace {

/// Makes the path of the tool in force.
bool makePath(WindowDriver& driver) {
    Workbench& bench = driver.window().workbench();
    return driver.step(JobStep::path) && driver.clickOn("newPathButton") &&
           driver.waitFor([&] { return bench.path.evaluated() && !bench.path.outdated(); }) && driver.settle();
}

bool useTool(WindowDriver& driver, const char* id) {
    Workbench& bench = driver.window().workbench();
    bench.tool.choose(id);
    return driver.waitFor([&] { return bench.bench.ready() && bench.bench.bench()->tool.id == id; }) && driver.settle();
}

QStringList toolChanges(const Workbench& bench) {
    QStringList tools;
    auto match =
        QRegularExpression("^T(\\d+) M6", QRegularExpression::MultilineOption).globalMatch(bench.program.storedText());
    while (match.hasNext()) tools.append(match.next().captured(1));
    return tools;
}

} // namespace

/// A job of two tools in the window: each has its path, the program has both.
class TestWindowTools : public QObject {
    Q_OBJECT
private slots:
    void eachToolHasItsPathAndTheProgramHasThemAll();
    void aLaterToolSeesWhatAnEarlierOneLeft();
};

void TestWindowTools::eachToolHasItsPathAndTheProgramHasThemAll() {
    WindowDriver driver;
    Workbench& bench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    QCOMPARE(bench.tool.current().id, std::string("ball-6"));
    QVERIFY(recordLine(driver, {-15, -5}, {15, -5}));
    QVERIFY(makePath(driver));
    const auto ball = bench.path.evaluated();
    QVERIFY(postProgram(driver));
    QCOMPARE(toolChanges(bench), QStringList{"3"});
    QVERIFY(driver.visible("programPath0Switch") == nullptr); // one tool needs no list

    // The other tool: no path of it yet, and the program says so.
    QVERIFY(useTool(driver, "flat-10"));
    QVERIFY(bench.path.stored() == nullptr && !bench.program.outdated());
    QVERIFY(recordLine(driver, {-15, 5}, {15, 5}));
    QVERIFY(driver.step(JobStep::program));
    QVERIFY(driver.waitFor([&] { return driver.visible("withoutPathNotice") != nullptr; }, 3000));
    driver.shoot("29-tool-without-path");
    QVERIFY(bench.program.outdated());
    QVERIFY(makePath(driver));
    QVERIFY(bench.path.evaluated()->path.toolId == "flat-10");
    QVERIFY(driver.step(JobStep::program));
    QVERIFY(driver.waitFor([&] { return driver.visible("programPath1Switch") != nullptr; }, 3000));
    QVERIFY(driver.visible("withoutPathNotice") == nullptr);
    QVERIFY(postProgram(driver));
    QCOMPARE(toolChanges(bench), (QStringList{"7", "3"})); // the larger tool first
    QVERIFY(bench.program.exportable());
    driver.shoot("30-two-tools");

    // One left out: the program of the other is judged by its own tool, whichever is in force.
    QVERIFY(driver.clickOn("programPath1Switch"));
    QVERIFY(bench.program.outdated());
    QVERIFY(postProgram(driver));
    QCOMPARE(toolChanges(bench), QStringList{"3"});
    QCOMPARE(bench.program.program()->tools.front().id, std::string("ball-6"));
    QVERIFY(bench.program.exportable());
    QVERIFY(driver.clickOn("programPath1Switch"));

    // What is changed while it is posted makes it out of date when it comes; taken back, it is what is wanted again.
    const auto before = bench.program.program();
    QVERIFY(driver.clickOn("postButton"));
    bench.target.chooseUnits(NcUnits::inch);
    QVERIFY(driver.waitFor([&] { return bench.program.program() != before && !bench.program.busy(); }));
    QVERIFY(bench.program.outdated() && !bench.program.exportable());
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(bench.program.exportable());
    const double tolerance = bench.program.gougeTolerance();
    bench.program.setGougeTolerance(0.5 * tolerance);
    QVERIFY(!bench.program.exportable());
    bench.program.setGougeTolerance(tolerance);
    QVERIFY(bench.program.exportable());

    // Inches, and back.
    QVERIFY(driver.waitFor([&] { return driver.visible<QComboBox>("programUnits") != nullptr; }, 3000));
    auto* units = driver.visible<QComboBox>("programUnits");
    QTRY_COMPARE(units->currentIndex(), 0); // panels follow a moment later
    units->setFocus();
    QTest::keyClick(units, Qt::Key_Down);
    QTRY_VERIFY(bench.target.target().units == NcUnits::inch);
    QVERIFY(postProgram(driver));
    QVERIFY(bench.program.storedText().contains("G20") && bench.program.exportable());
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(bench.target.target().units == NcUnits::millimetre);

    // Each tool keeps its path and its edits.
    QVERIFY(useTool(driver, "ball-6"));
    QVERIFY(driver.waitFor([&] { return bench.path.evaluated() && !bench.path.outdated(); }));
    QCOMPARE(bench.path.evaluated()->path.points.size(), ball->path.points.size());
    QVERIFY(driver.waitFor([&] { return driver.settle(); }));
}

/// Two tools in one groove: the larger one is milled first, whichever was recorded first.
void TestWindowTools::aLaterToolSeesWhatAnEarlierOneLeft() {
    WindowDriver driver;
    Workbench& bench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    QVERIFY(recordLine(driver, {-15, 0}, {15, 0}));
    QVERIFY(makePath(driver));
    // Feeds by engagement, of a tool that is alone.
    driver.window().findChild<QAction*>("add-level-feed")->trigger();
    const auto levelled = [&] {
        return driver.waitFor([&] { return bench.path.evaluated() && !bench.path.outdated() && !bench.path.busy(); });
    };
    QVERIFY(driver.waitFor([&] { return bench.path.stored()->edits.size() > standardEdits().size(); }, 3000));
    QVERIFY(levelled());
    const auto mostFeed = [&] {
        double most = 0.0;
        for (const PathPoint& point : bench.path.evaluated()->path.points)
            if (point.kind == MoveKind::cut) most = std::max(most, point.feed);
        return most;
    };
    const auto plungesFrom = [&] { // the first one
        const std::vector<PathPoint>& points = bench.path.evaluated()->path.points;
        for (std::size_t i = 1; i < points.size(); ++i)
            if (points[i].kind == MoveKind::plunge) return points[i - 1].tip.z;
        return 1e9;
    };
    const double alone = mostFeed(), aloneDown = plungesFrom();
    const double top = bench.bench.bench()->setup.stock.high.z;
    QVERIFY(std::abs(aloneDown - top - Link{}.approach) < 1e-6);

    // The same groove with a flat one of 10 mm, as deep: nothing is left for the ball.
    QVERIFY(useTool(driver, "flat-10"));
    QVERIFY(recordLine(driver, {-15, 0}, {15, 0}));
    QVERIFY(makePath(driver));
    const auto large = bench.path.evaluated();
    QVERIFY(driver.waitFor([&] { return bench.path.others().size() == 1 && bench.tasks().idle(); }));
    QVERIFY(bench.path.others().front()->path.toolId == "ball-6");
    QVERIFY(bench.path.others().front()->after == std::vector{large});
    driver.shoot("32-other-tools-path");
    auto* shown = driver.window().findChild<QAction*>("showOtherPathsAction");
    QVERIFY(shown != nullptr && shown->isChecked() && !shown->toolTip().isEmpty());
    auto* viewport = driver.visible<Viewport>("viewport");
    QTest::qWait(800); // until it is drawn at rest
    const QImage with = viewport->grabFramebuffer();
    driver.key(Qt::Key_6, Qt::ControlModifier);
    QVERIFY(!shown->isChecked());
    QTest::qWait(300);
    QVERIFY(viewport->grabFramebuffer() != with);
    driver.key(Qt::Key_6, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return viewport->grabFramebuffer() == with; }, 3000));

    // The ball's feeds and rapids are those of a groove that is there.
    QVERIFY(useTool(driver, "ball-6"));
    QVERIFY(levelled());
    const double machine = bench.bench.bench()->machine.maximumFeed;
    const double air = std::min(machine, bench.path.evaluated()->path.spindleSpeed *
                                             bench.bench.bench()->tool.fluteCount * LevelFeed{}.largestChip);
    QVERIFY2(mostFeed() > 0.9 * air && mostFeed() <= air + 1e-6 && alone < 0.8 * air,
             qPrintable(QString("%1 %2 %3").arg(mostFeed()).arg(air).arg(alone)));
    QVERIFY2(plungesFrom() < aloneDown - 0.5, qPrintable(QString::number(plungesFrom() - top)));
    // The program says the same as the path, and passes its check.
    QVERIFY(postProgram(driver));
    QVERIFY(bench.program.exportable());
    QVERIFY(bench.program.storedText().contains(QString("F%1").arg(air)));

    // Without the large tool's path the ball cuts all of it: the program of it alone is as it was alone.
    QVERIFY(driver.step(JobStep::program));
    QVERIFY(driver.waitFor([&] { return driver.visible("programPath1Switch") != nullptr; }, 3000));
    QVERIFY(driver.clickOn("programPath1Switch"));
    QVERIFY(postProgram(driver));
    QVERIFY(bench.program.exportable());
    QVERIFY(!bench.program.storedText().contains(QString("F%1").arg(air)));
    QVERIFY(driver.clickOn("programPath1Switch"));

    // A change of the large tool's path changes the ball's.
    const auto before = bench.path.evaluated();
    QVERIFY(useTool(driver, "flat-10"));
    QVERIFY(levelled());
    driver.window().findChild<QAction*>("add-remove-area")->trigger();
    QVERIFY(driver.waitFor([&] { return bench.path.stored()->edits.size() > standardEdits().size(); }, 3000));
    const Edit area = [&] {
        Edit edit;
        const glm::dvec3 zero = bench.bench.bench()->setup.workOffset;
        RemoveArea everything;
        for (const glm::dvec2& corner :
             {glm::dvec2(-30, -30), glm::dvec2(0, -30), glm::dvec2(0, 30), glm::dvec2(-30, 30)})
            everything.outline.push_back(zero + glm::dvec3(corner, 0.0));
        everything.low = -1e3;
        everything.high = 1e3;
        edit.parameters = everything;
        return edit;
    }();
    const auto place = std::ranges::find_if(bench.path.stored()->edits, [](const Edit& edit) {
        return std::holds_alternative<RemoveArea>(edit.parameters);
    });
    bench.path.changeEdit(static_cast<std::size_t>(place - bench.path.stored()->edits.begin()), area);
    QVERIFY(levelled());
    QVERIFY(driver.waitFor([&] { return bench.path.others().front() != before && bench.tasks().idle(); }));
    const auto& points = bench.path.others().front()->path.points;
    double left = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].kind == MoveKind::cut && points[i].tip.x < bench.bench.bench()->setup.workOffset.x - 8.0)
            left = std::max(left, points[i].feed);
    QVERIFY2(left > 0.0 && left < 0.9 * air, qPrintable(QString::number(left))); // stock stands there again
}

QTEST_MAIN(TestWindowTools)
#include "tst_window_tools.moc"
