// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/messages/messages.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_job {

using namespace burin::testing;

class TestWindowJob : public QObject {
    Q_OBJECT
private slots:
    void strokesAreMilledTakenBackSavedAndFoundAgain();
    void aProjectsOwnMaterialIsMilled();
};

void TestWindowJob::strokesAreMilledTakenBackSavedAndFoundAgain() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    driver.shoot("01-welcome");
    QVERIFY(makeReady(driver));
    driver.shoot("02-embedded");
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.clickOn("millButton"));
    QVERIFY(driver.waitFor([&] { return workbench.mill.active(); }));
    millLine(driver, {-20, -12}, {20, -12});
    driver.shoot("03-first-stroke");
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.strokes().count() == 1; }));
    millLine(driver, {-20, 0}, {20, 0});
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.strokes().count() == 2; }));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.strokes().count() == 1; }));
    driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.strokes().count() == 2; }));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.strokes().count() == 1; }));
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));
    QCOMPARE(workbench.mill.takes().size(), std::size_t{1});
    QVERIFY(workbench.setup.locked());
    const double removed = removedSoFar(*workbench.workpiece.milling());
    // One groove of a ball-end mill of 6 mm, 1 mm deep and about 40 mm long: the section is a segment of the circle,
    // 3.0 mm².
    const double section = 9.0 * std::acos(2.0 / 3.0) - 2.0 * std::sqrt(5.0);
    QVERIFY2(removed > 0.7 * 40.0 * section && removed < 1.3 * 40.0 * section, qPrintable(QString::number(removed)));
    QVERIFY(driver.step(JobStep::path));
    QVERIFY(driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor([&] { return workbench.path.evaluated() != nullptr; }));
    driver.shoot("04-path");
    QVERIFY(postProgram(driver));
    QVERIFY2(!workbench.program.problem(),
             workbench.program.problem() ? qPrintable(Messages::sentence(*workbench.program.problem())) : "");
    QVERIFY(workbench.program.program() != nullptr);
    driver.shoot("05-program");
    QVERIFY(workbench.program.exportable());
    const QString program = driver.folder().filePath("groove.ngc");
    chooseFile(driver, program);
    QVERIFY(driver.clickOn("exportButton"));
    QVERIFY(driver.waitFor([&] { return QFile::exists(program); }));

    const QString file = driver.folder().filePath("groove.burin");
    QVERIFY(saveAs(driver, file));
    QCOMPARE(workbench.document.title(), QString("groove"));
    QVERIFY(driver.restart());
    driver.shoot("06-welcome-recent");
    QVERIFY(driver.clickOn("recentFileButton"));
    Workbench& again = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return again.workpiece.ready(); }));
    QCOMPARE(again.mill.takes().size(), std::size_t{1});
    QCOMPARE(again.mill.strokesOf(again.mill.takes().front().id), std::size_t{1});
    // Replayed from the recording: exactly the volume that was removed by hand.
    QCOMPARE(removedSoFar(*again.workpiece.milling()), removed);
    QVERIFY(driver.waitFor([&] { return again.path.evaluated() != nullptr; }));
    QVERIFY(driver.settle());
    QTest::qWait(500);                  // the window checks a moment after work on the project
    QVERIFY(!again.document.unsaved()); // it was only viewed
    QVERIFY(!driver.window().isWindowModified());
    const auto* post = menuAction(driver, "postAction");
    QVERIFY(post != nullptr);
    QVERIFY(post->isEnabled()); // by key and menu as well as by the panel's button
    driver.shoot("07-reopened");
}

/// The library does not have the material; the project keeps it.
void TestWindowJob::aProjectsOwnMaterialIsMilled() {
    WindowDriver driver;
    const auto energy = [&] {
        double sum = 0.0;
        for (const MotionLoad& load : driver.window().workbench().program.program()->report.loads)
            sum += load.power * load.duration;
        return sum;
    };
    QVERIFY(makeReady(driver));
    QVERIFY(recordLine(driver, {-15, 0}, {15, 0}));
    QVERIFY(driver.step(JobStep::path));
    QVERIFY(driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor([&] { return driver.window().workbench().path.evaluated() != nullptr; }));
    QVERIFY(postProgram(driver));
    const double before = energy();
    const QString file = driver.folder().filePath("own.burin");
    QVERIFY(saveAs(driver, file));
    QVERIFY(driver.restart());
    {
        Result<Project> project = Project::open(file.toStdString());
        QVERIFY(project);
        Setup setup = project->setup().value();
        Property material = loadMaterial(setup.stockMaterial).value();
        material.id = setup.stockMaterial = "wax-of-our-own";
        material.name = "Wax of our own";
        material.values.at(std::string(specificCuttingEnergy)).value *= 3.0;
        QVERIFY(project->setSetup(setup) && project->setMaterials({material}) && project->save());
    }
    QVERIFY(driver.clickOn("recentFileButton"));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.ready() && workbench.path.evaluated(); }));
    QVERIFY(driver.settle());
    const EmbeddedSetup& embedded = workbench.workpiece.milling()->embedded;
    QCOMPARE(embedded.workpiece.properties()[embedded.stockProperty].name, std::string("Wax of our own"));
    QVERIFY(workbench.setup.stockMaterial() != nullptr);
    QVERIFY(postProgram(driver));
    QVERIFY(workbench.program.exportable());
    QVERIFY2(before > 0.0 && std::abs(energy() / before - 3.0) < 0.01, qPrintable(QString::number(energy() / before)));
    QVERIFY(driver.step(JobStep::material));
    driver.shoot("34-own-material");
}

BURIN_TEST(TestWindowJob, QApplication)

} // namespace burin::tst_window_job

#include "tst_window_job.moc"
