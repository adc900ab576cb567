// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/project.h"
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/notice.h"
#include "ui/scene/camera_view.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

namespace burin::tst_window_reopen {

using namespace burin::testing;

/// A project that is opened again shows the window as it was left.
class TestWindowReopen : public QObject {
    Q_OBJECT
private slots:
    void aProjectIsWhereItWasLeft();
    BURIN_ONLY_IN_LONG_RUNS void aWorkpieceIsThereWithoutAStroke();
    void lookingAroundIsNothingToSave();
    BURIN_ONLY_IN_LONG_RUNS void whatCanBeUndoneIsSaid();
    BURIN_ONLY_IN_LONG_RUNS void aProgramThatPassedIsPassedAgain();
    BURIN_ONLY_IN_LONG_RUNS void aVerdictOfSomethingElseIsOutOfDate();
    BURIN_ONLY_IN_LONG_RUNS void whatChangesAfterOpeningMakesTheVerdictOutOfDate();
};

namespace {

/// Turns the view by a drag with the right button.
void orbit(WindowDriver& driver) {
    Viewport& viewport = driver.window().viewport();
    const QPoint middle = viewport.rect().center();
    QTest::mousePress(&viewport, Qt::RightButton, Qt::NoModifier, middle);
    for (int i = 1; i <= 10; ++i) QTest::mouseMove(&viewport, middle + QPoint(9 * i, 4 * i));
    QTest::mouseRelease(&viewport, Qt::RightButton, Qt::NoModifier, middle + QPoint(90, 40));
}

bool same(const CameraView& one, const CameraView& other) {
    return glm::length(one.focus - other.focus) < 1e-9 && std::abs(one.azimuth - other.azimuth) < 1e-9 &&
           std::abs(one.elevation - other.elevation) < 1e-9 && std::abs(one.distance - other.distance) < 1e-9;
}

/// Mills a stroke, posts it, saves the project and ends the program.
bool postAndLeave(WindowDriver& driver) {
    Workbench& workbench = driver.window().workbench();
    if (!makeReady(driver) || !recordLine(driver, {-15, 0}, {15, 0}) || !driver.settle()) return false;
    if (!driver.step(JobStep::path) || !driver.clickOn("newPathButton")) return false;
    if (!driver.waitFor(
            [&] { return workbench.path.evaluated() && !workbench.path.outdated() && !workbench.path.busy(); }))
        return false;
    if (!postProgram(driver) || !workbench.program.exportable()) return false;
    return saveAs(driver, driver.folder().filePath("posted.burin")) && driver.restart();
}

Notice* verdict(const WindowDriver& driver) {
    return driver.visible<Notice>("verdict");
}

/// Whether the verdict becomes one of that kind in time.
bool told(const WindowDriver& driver, Notice::Kind kind) {
    return driver.waitFor([&] { return verdict(driver) != nullptr && verdict(driver)->kind() == kind; });
}

QString figure(const WindowDriver& driver, const char* name) {
    const auto* row = driver.visible(name);
    QStringList texts;
    for (const QLabel* label : row != nullptr ? row->findChildren<QLabel*>() : QList<QLabel*>()) texts << label->text();
    return texts.join(QLatin1Char(' '));
}

bool reopen(WindowDriver& driver) {
    const Workbench& workbench = driver.window().workbench();
    if (!driver.clickOn("recentFileButton")) return false;
    return driver.waitFor([&] { return workbench.workpiece.ready(); }) && driver.settle();
}

} // namespace

void TestWindowReopen::aProjectIsWhereItWasLeft() {
    WindowDriver driver;
    QVERIFY(makeReady(driver, 1.0));
    QVERIFY(recordLine(driver, {-10, 0}, {10, 0}) && driver.settle());
    QVERIFY(driver.clickOn("alongPartButton"));
    QVERIFY(driver.enter("pressField", QStringLiteral("1.5")));
    driver.window().workbench().tool.choose("flat-6");
    QVERIFY(driver.settle());
    orbit(driver);
    auto* const tool = menuAction(driver, QStringLiteral("showToolAction"));
    QVERIFY(tool != nullptr && tool->isChecked());
    tool->trigger();
    QVERIFY(driver.step(JobStep::tool));
    QTest::qWait(300);
    const CameraView left = driver.window().viewport().cameraView();
    QVERIFY(saveAs(driver, driver.folder().filePath("left.burin")));
    QVERIFY(driver.restart());

    QVERIFY(reopen(driver));
    driver.shoot("42-reopened");
    QVERIFY(driver.visible<QWidget>("toolPanel") != nullptr);
    QVERIFY(same(driver.window().viewport().cameraView(), left));
    QCOMPARE(driver.window().workbench().tool.current().id, std::string("flat-6"));
    QVERIFY(!menuAction(driver, QStringLiteral("showToolAction"))->isChecked());
    QVERIFY(menuAction(driver, QStringLiteral("showWorkpieceAction"))->isChecked());
    QVERIFY(!driver.window().workbench().document.unsaved());
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.visible<QPushButton>("alongPartButton")->isChecked());
    QCOMPARE(driver.visible<QAbstractSpinBox>("pressField")->text().left(3), QStringLiteral("1.5"));
}

/// Embedded in a window, embedded by the command line (which stores no window state), not embedded at all.
void TestWindowReopen::aWorkpieceIsThereWithoutAStroke() {
    WindowDriver driver;
    QVERIFY(makeReady(driver, 1.0));
    const QString file = driver.folder().filePath("embedded.burin");
    QVERIFY(saveAs(driver, file));
    QVERIFY(driver.restart());
    QVERIFY(reopen(driver));
    QVERIFY(driver.visible<QWidget>("millPanel") != nullptr || driver.step(JobStep::mill));
    QVERIFY(driver.window().workbench().document.file() == file.toStdString());
    QVERIFY(driver.restart());

    {
        Result<Project> project = Project::open(file.toStdString());
        QVERIFY(project && project->setLeftAt("") && project->save());
    }
    QVERIFY(reopen(driver));
    QVERIFY(driver.step(JobStep::stock) && driver.enter("topMarginField", QStringLiteral("4")));
    QVERIFY(driver.settle() && !driver.window().workbench().workpiece.embedded());
    driver.key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return !driver.window().workbench().document.unsaved(); }));
    QVERIFY(driver.restart());

    const Workbench& workbench = driver.window().workbench();
    QVERIFY(driver.clickOn("recentFileButton"));
    QVERIFY(driver.waitFor([&] { return workbench.model.model() != nullptr; }) && driver.settle());
    QTest::qWait(200);
    QVERIFY(!workbench.workpiece.embedded() && !workbench.workpiece.embedding());
}

void TestWindowReopen::lookingAroundIsNothingToSave() {
    WindowDriver driver;
    QVERIFY(makeReady(driver, 1.0));
    QVERIFY(saveAs(driver, driver.folder().filePath("seen.burin")));
    orbit(driver);
    QVERIFY(driver.step(JobStep::material));
    QTest::qWait(500);
    QVERIFY(!driver.window().workbench().document.unsaved());
    QVERIFY(driver.restart()); // a question would keep the window open
}

void TestWindowReopen::whatCanBeUndoneIsSaid() {
    WindowDriver driver;
    QVERIFY(makeReady(driver, 1.0));
    const auto undo = [&] { return driver.visible<QPushButton>("undoStrokeButton"); };
    QVERIFY(recordLine(driver, {-10, 0}, {10, 0}) && driver.settle());
    QVERIFY(driver.waitFor([&] { return undo()->toolTip().contains(QStringLiteral("no other one")); }));
    QVERIFY(recordLine(driver, {-10, 5}, {10, 5}) && driver.settle());
    QVERIFY(driver.waitFor([&] { return undo()->toolTip().contains(QStringLiteral("last 2 strokes")); }));
    QVERIFY(saveAs(driver, driver.folder().filePath("strokes.burin")));
    QVERIFY(driver.restart());
    QVERIFY(reopen(driver));
    QVERIFY(driver.waitFor([&] { return undo() != nullptr && !undo()->isEnabled(); }));
    QVERIFY2(undo()->toolTip().contains(QStringLiteral("delete their take")), qPrintable(undo()->toolTip()));
}

void TestWindowReopen::aProgramThatPassedIsPassedAgain() {
    WindowDriver driver;
    Workbench* workbench = &driver.window().workbench();
    QVERIFY(makeReady(driver) && recordLine(driver, {-15, 0}, {15, 0}) && driver.settle());
    QVERIFY(driver.step(JobStep::path) && driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor(
        [&] { return workbench->path.evaluated() && !workbench->path.busy() && !workbench->path.outdated(); }));
    QVERIFY(postProgram(driver));
    QVERIFY(told(driver, Notice::Kind::passed));
    const QString sentence = verdict(driver)->sentence(), removed = figure(driver, "removedVolume"),
                  time = figure(driver, "machiningTime");
    const std::string text = workbench->program.program()->text;
    QVERIFY(!removed.isEmpty() && !time.isEmpty());
    QVERIFY(saveAs(driver, driver.folder().filePath("posted.burin")));
    QVERIFY(driver.restart());

    QVERIFY(reopen(driver));
    workbench = &driver.window().workbench();
    driver.shoot("43-verdict-reopened");
    QVERIFY(driver.visible("programPanel") != nullptr);
    QVERIFY(driver.waitFor([&] { return workbench->path.evaluated() && driver.settle(); }));
    QVERIFY(told(driver, Notice::Kind::passed));
    QCOMPARE(verdict(driver)->sentence(), sentence);
    QCOMPARE(figure(driver, "removedVolume"), removed);
    QCOMPARE(figure(driver, "machiningTime"), time);
    QVERIFY(!workbench->document.unsaved());

    const QString exported = driver.folder().filePath("again.ngc");
    chooseFile(driver, exported);
    QVERIFY(driver.clickOn("exportButton"));
    QVERIFY(driver.waitFor([&] { return QFile::exists(exported); }));
    QFile file(exported);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll().toStdString(), text);
}

/// The file was changed by another program meanwhile: the tool that milled, as an older Burin would.
void TestWindowReopen::aVerdictOfSomethingElseIsOutOfDate() {
    WindowDriver driver;
    QVERIFY(postAndLeave(driver));
    {
        Result<Project> project = Project::open(driver.folder().filePath("posted.burin").toStdString());
        QVERIFY(project);
        const Result<std::vector<Tool>> tools = project->tools();
        QVERIFY(tools && !tools->empty());
        Tool longer = tools->front();
        longer.cutter.stickOut += 1.0;
        QVERIFY(project->setTool(longer) && project->save());
    }
    QVERIFY(reopen(driver));
    driver.shoot("44-verdict-out-of-date");
    QVERIFY(told(driver, Notice::Kind::warning));
    QVERIFY2(verdict(driver)->sentence().startsWith(QStringLiteral("Out of date")),
             qPrintable(verdict(driver)->sentence()));
    QVERIFY(!driver.visible<QPushButton>("exportButton")->isEnabled());
}

void TestWindowReopen::whatChangesAfterOpeningMakesTheVerdictOutOfDate() {
    WindowDriver driver;
    QVERIFY(postAndLeave(driver));
    QVERIFY(reopen(driver));
    QVERIFY(told(driver, Notice::Kind::passed));
    QVERIFY(driver.enter("gougeToleranceField", QStringLiteral("0.5")));
    QVERIFY(told(driver, Notice::Kind::warning));
    QVERIFY(driver.enter("gougeToleranceField", QStringLiteral("0.02")));
    QVERIFY(told(driver, Notice::Kind::passed));
    QVERIFY(driver.enter("excessToleranceField", QStringLiteral("0.3")));
    QVERIFY(told(driver, Notice::Kind::warning));
    QVERIFY(driver.enter("excessToleranceField", QStringLiteral("0.1")));
    QVERIFY(told(driver, Notice::Kind::passed));
    // A second stroke is missing in the program.
    QVERIFY(recordLine(driver, {-15, 8}, {15, 8}) && driver.settle());
    QVERIFY(driver.step(JobStep::program));
    QVERIFY(told(driver, Notice::Kind::warning));
    QVERIFY(!driver.visible<QPushButton>("exportButton")->isEnabled());
}

BURIN_TEST(TestWindowReopen, QApplication)

} // namespace burin::tst_window_reopen

#include "tst_window_reopen.moc"
