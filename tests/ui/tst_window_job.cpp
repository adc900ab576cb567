// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/window_steps.h"
#include "ui/messages/messages.h"

#include <QFile>
#include <QtTest>

#include <cmath>

using namespace burin;
using namespace burin::testing;

class TestWindowJob : public QObject {
    Q_OBJECT
private slots:
    void strokesAreMilledTakenBackSavedAndFoundAgain();
};

void TestWindowJob::strokesAreMilledTakenBackSavedAndFoundAgain() {
    WindowDriver driver;
    Workbench& bench = driver.window().workbench();
    driver.shoot("01-welcome");
    QVERIFY(makeReady(driver));
    driver.shoot("02-embedded");
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.clickOn("recordButton")); // takes the tool in hand as well
    QVERIFY(driver.waitFor([&] { return bench.mill.recording(); }, 5000));
    millLine(driver, {-20, -12}, {20, -12});
    driver.shoot("03-first-stroke");
    QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == 1; }, 3000));
    millLine(driver, {-20, 0}, {20, 0});
    QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == 2; }, 3000));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == 1; }, 3000));
    driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == 2; }, 3000));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == 1; }, 3000));
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !bench.session.running(); }, 5000));
    QCOMPARE(bench.mill.takes().size(), std::size_t{1});
    QVERIFY(bench.setup.locked());
    const double removed = removedSoFar(*bench.bench.bench());
    // One groove of a ball of 6 mm, 1 mm deep and about 40 mm long: a segment of the circle of 3.0 mm².
    const double section = 9.0 * std::acos(2.0 / 3.0) - 2.0 * std::sqrt(5.0);
    QVERIFY2(removed > 0.7 * 40.0 * section && removed < 1.3 * 40.0 * section, qPrintable(QString::number(removed)));
    QVERIFY(driver.step(JobStep::path));
    QVERIFY(driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor([&] { return bench.path.evaluated() != nullptr; }));
    driver.shoot("04-path");
    QVERIFY(postProgram(driver));
    QVERIFY2(!bench.program.problem(),
             bench.program.problem() ? qPrintable(Messages::sentence(*bench.program.problem())) : "");
    QVERIFY(bench.program.program() != nullptr);
    driver.shoot("05-program");
    QVERIFY(bench.program.exportable());
    const QString program = driver.folder().filePath("groove.ngc");
    chooseFile(driver, program);
    QVERIFY(driver.clickOn("exportButton"));
    QVERIFY(driver.waitFor([&] { return QFile::exists(program); }, 5000));

    const QString file = driver.folder().filePath("groove.burin");
    chooseFile(driver, file);
    driver.key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return QFile::exists(file) && !bench.document.unsaved(); }, 5000));
    QCOMPARE(bench.document.title(), QString("groove"));
    QVERIFY(driver.restart());
    driver.shoot("06-welcome-recent");
    QVERIFY(driver.clickOn("recentFileButton"));
    Workbench& again = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return again.bench.ready(); }));
    QCOMPARE(again.mill.takes().size(), std::size_t{1});
    QCOMPARE(again.mill.strokesOf(again.mill.takes().front().id), std::size_t{1});
    // Replayed from the recording: exactly what the hand left.
    QCOMPARE(removedSoFar(*again.bench.bench()), removed);
    QVERIFY(driver.waitFor([&] { return again.path.evaluated() != nullptr; }));
    QVERIFY(driver.settle());
    QTest::qWait(500);                  // the window asks a moment after work on the project
    QVERIFY(!again.document.unsaved()); // it was only looked at
    QVERIFY(!driver.window().isWindowModified());
    driver.shoot("07-reopened");
}

QTEST_MAIN(TestWindowJob)
#include "tst_window_job.moc"
