// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/window_driver.h"

#include <QtTest>

using namespace burin;
using burin::testing::WindowDriver;

class TestWindow : public QObject {
    Q_OBJECT
private slots:
    void theSamplePartIsMadeReadyToMill() {
        WindowDriver driver;
        Workbench& bench = driver.window().workbench();
        driver.shoot("01-welcome");
        QVERIFY(driver.clickOn("samplePartButton"));
        QVERIFY(driver.waitFor([&] { return bench.model.model() != nullptr; }));
        driver.shoot("02-stock");
        QVERIFY(driver.step(JobStep::part));
        driver.shoot("03-part");
        QVERIFY(driver.step(JobStep::material));
        driver.shoot("04-material");
        QVERIFY(driver.step(JobStep::tool));
        driver.shoot("05-tool");
        QVERIFY(driver.step(JobStep::allowance));
        driver.shoot("06-allowance");
        QVERIFY(driver.step(JobStep::mill));
        driver.shoot("07-mill-missing");
        QVERIFY(driver.step(JobStep::stock));
        QVERIFY(driver.clickOn("embedButton"));
        QVERIFY(driver.waitFor([&] { return bench.bench.embedded(); }));
        QVERIFY(driver.settle());
        driver.shoot("08-embedded");
        QVERIFY(driver.step(JobStep::mill));
        driver.shoot("09-ready");
        QVERIFY(driver.clickOn("millButton"));
        QVERIFY(driver.waitFor([&] { return bench.mill.active(); }));
        QTest::qWait(1000);
        driver.shoot("10-mill-mode");
    }
};

QTEST_MAIN(TestWindow)
#include "tst_window.moc"
