// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/visible_texts.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/notice.h"

#include <QApplication>
#include <QComboBox>
#include <QtTest>

namespace burin::tst_window_steps {

using namespace burin::testing;

class TestWindowSteps : public QObject {
    Q_OBJECT
private slots:
    void eachStepTellsWhatItHolds();
    void aDoubtfulPartIsObjectedTo();
    BURIN_ONLY_IN_LONG_RUNS void choosingAMaterialKeepsTheWorkpiece();
};

void TestWindowSteps::eachStepTellsWhatItHolds() {
    WindowDriver driver(QSize(1280, 800));
    Workbench& workbench = driver.window().workbench();
    driver.shoot("small-01-welcome");
    QVERIFY(driver.clickOn("samplePartButton"));
    QVERIFY(driver.waitFor([&] { return workbench.model.model() != nullptr; }));
    const std::pair<JobStep, const char*> before[] = {{JobStep::part, "part"},           {JobStep::stock, "stock"},
                                                      {JobStep::material, "material"},   {JobStep::tool, "tool"},
                                                      {JobStep::allowance, "allowance"}, {JobStep::mill, "mill"},
                                                      {JobStep::path, "path"},           {JobStep::program, "program"}};
    for (const auto& [step, name] : before) {
        QVERIFY(driver.step(step));
        driver.shoot(QStringLiteral("small-02-%1").arg(name));
        for (const VisibleText& cut : clippedTexts(driver.window()))
            QFAIL(qPrintable(QStringLiteral("cut in the window of %1: %2: %3").arg(name, cut.where, cut.text)));
    }
    // Nothing can be milled yet, and the panel says what has to be done first.
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(!driver.visible<QWidget>("millButton")->isEnabled());
    QVERIFY(driver.visible<QWidget>("millMissing") != nullptr);
    QVERIFY(driver.step(JobStep::stock));
    QVERIFY(driver.clickOn("embedButton"));
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.ready(); }));
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.clickOn("millButton"));
    QVERIFY(driver.waitFor([&] { return workbench.mill.active(); }));
    QTest::qWait(300);
    driver.shoot("small-03-mill");
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !workbench.mill.active(); }));
}

/// A guess about what is protected must not look like a completed step.
void TestWindowSteps::aDoubtfulPartIsObjectedTo() {
    WindowDriver driver(QSize(1280, 800));
    Workbench& workbench = driver.window().workbench();
    const auto progress = [&] { return driver.visible<QWidget>("stepStock")->accessibleDescription(); };
    QVERIFY(makeReady(driver, 1.0));
    QVERIFY(progress().startsWith(QStringLiteral("done")));
    QVERIFY(driver.visible<QWidget>("findingsNotice") == nullptr);
    const auto places = [&] {
        std::vector<QPoint> found;
        for (const char* name : {"sideMarginField", "embedButton", "addObstacleButton", "travelSwitch", "axisChoice"})
            found.push_back(driver.visible<QWidget>(name)->mapToGlobal(QPoint()));
        return found;
    };
    const std::vector<QPoint> before = places();

    const auto sound = workbench.model.model();
    drop(driver.window(), writeBlock(driver, false));
    QVERIFY(driver.waitFor([&] { return workbench.model.model() != sound; }));
    QVERIFY(driver.step(JobStep::stock) && driver.settle());
    QVERIFY(driver.clickOn("embedButton"));
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.ready(); }) && driver.settle());
    driver.shoot("small-04-doubtful");
    QVERIFY2(progress().startsWith(QStringLiteral("has a problem")), qPrintable(progress()));
    auto* const notice = driver.visible<Notice>("findingsNotice");
    QVERIFY(notice != nullptr);
    QVERIFY(notice->sentence().contains(QStringLiteral("is open (edges: 4, rims: 1)")));
    QCOMPARE(places(), before); // regardless of the amount of text
    QVERIFY(driver.visible<Notice>("stockNotice")->sentence().contains(QStringLiteral("1 finding")));
}

/// Stock precedes material in the job: going through the steps from left to right loses nothing.
void TestWindowSteps::choosingAMaterialKeepsTheWorkpiece() {
    WindowDriver driver(QSize(1280, 800));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver, 1.0));
    const auto workpiece = workbench.workpiece.milling();
    const auto bounds = workbench.workpiece.bounds();
    const auto materialCut = [&] {
        const EmbeddedSetup& embedded = workbench.workpiece.milling()->embedded;
        return embedded.workpiece.properties()[embedded.stockProperty].id;
    };
    QCOMPARE(materialCut(), std::string("machinable-wax"));
    const double volume = workpiece->workpieceVolume();
    QVERIFY(driver.step(JobStep::material));
    auto* const choice = driver.visible<QComboBox>("stockMaterial");
    QVERIFY(choice != nullptr);
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Home);
    const std::string chosen = choice->currentData().toString().toStdString();
    QVERIFY(chosen != "machinable-wax");
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.embedded() && materialCut() == chosen; }));
    QVERIFY(driver.settle());
    QCOMPARE(workbench.workpiece.milling(), workpiece);
    QCOMPARE(workbench.workpiece.bounds(), bounds);
    QCOMPARE(workpiece->workpieceVolume(), volume);
    QVERIFY(workbench.workpiece.ready());
    driver.shoot("small-05-other-material");
    QVERIFY(driver.visible<QWidget>("stepStock")->accessibleDescription().startsWith(QStringLiteral("done")));

    driver.window().setFocus();
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.embedded() && materialCut() == "machinable-wax"; }));
    driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.embedded() && materialCut() == chosen; }));
    QVERIFY(driver.settle());
    QVERIFY(recordLine(driver, {-10, 0}, {10, 0})); // and it is milled as any other
    QVERIFY(driver.settle());
    QVERIFY(removedSoFar(*workbench.workpiece.milling()) > 1.0);
}

BURIN_TEST(TestWindowSteps, QApplication)

} // namespace burin::tst_window_steps

#include "tst_window_steps.moc"
