// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/window_steps.h"

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

QTEST_MAIN(TestWindowTools)
#include "tst_window_tools.moc"
