// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/window_steps.h"
#include "ui/panels/notice.h"

#include <QtTest>

using namespace burin;
using namespace burin::testing;

class TestWindowSteps : public QObject {
    Q_OBJECT
private slots:
    void eachStepTellsWhatItHolds();
    void aDoubtfulPartIsObjectedTo();
};

void TestWindowSteps::eachStepTellsWhatItHolds() {
    WindowDriver driver(QSize(1280, 800));
    Workbench& bench = driver.window().workbench();
    driver.shoot("small-01-welcome");
    QVERIFY(driver.clickOn("samplePartButton"));
    QVERIFY(driver.waitFor([&] { return bench.model.model() != nullptr; }));
    const std::pair<JobStep, const char*> before[] = {{JobStep::part, "part"},           {JobStep::stock, "stock"},
                                                      {JobStep::material, "material"},   {JobStep::tool, "tool"},
                                                      {JobStep::allowance, "allowance"}, {JobStep::mill, "mill"},
                                                      {JobStep::path, "path"},           {JobStep::program, "program"}};
    for (const auto& [step, name] : before) {
        QVERIFY(driver.step(step));
        driver.shoot(QStringLiteral("small-02-%1").arg(name));
    }
    // Nothing can be milled yet, and the panel says what is to be done first.
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(!driver.visible<QWidget>("millButton")->isEnabled());
    QVERIFY(driver.visible<QWidget>("millMissing") != nullptr);
    QVERIFY(driver.step(JobStep::stock));
    QVERIFY(driver.clickOn("embedButton"));
    QVERIFY(driver.waitFor([&] { return bench.bench.ready(); }));
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.clickOn("millButton"));
    QVERIFY(driver.waitFor([&] { return bench.mill.active(); }));
    QTest::qWait(300);
    driver.shoot("small-03-mill");
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !bench.mill.active(); }, 5000));
}

/// A guess in what is protected must not look like a step that is done.
void TestWindowSteps::aDoubtfulPartIsObjectedTo() {
    WindowDriver driver(QSize(1280, 800));
    Workbench& bench = driver.window().workbench();
    const auto progress = [&] { return driver.visible<QWidget>("stepStock")->accessibleDescription(); };
    QVERIFY(makeReady(driver, 1.0));
    QVERIFY(progress().startsWith(QStringLiteral("done")));
    QVERIFY(driver.visible<QWidget>("findingsNotice") == nullptr);

    const auto sound = bench.model.model();
    drop(driver.window(), writeBlock(driver, false));
    QVERIFY(driver.waitFor([&] { return bench.model.model() != sound; }));
    QVERIFY(driver.step(JobStep::stock) && driver.settle());
    QVERIFY(driver.clickOn("embedButton"));
    QVERIFY(driver.waitFor([&] { return bench.bench.ready(); }) && driver.settle());
    driver.shoot("small-04-doubtful");
    QVERIFY2(progress().startsWith(QStringLiteral("objected to")), qPrintable(progress()));
    auto* const notice = driver.visible<Notice>("findingsNotice");
    QVERIFY(notice != nullptr);
    QVERIFY(notice->sentence().contains(QStringLiteral("is open (edges: 4, rims: 1)")));
}

QTEST_MAIN(TestWindowSteps)
#include "tst_window_steps.moc"
