// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/window_steps.h"

#include <QtTest>

using namespace burin;
using namespace burin::testing;

class TestWindowSteps : public QObject {
    Q_OBJECT
private slots:
    void eachStepTellsWhatItHolds();
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

QTEST_MAIN(TestWindowSteps)
#include "tst_window_steps.moc"
