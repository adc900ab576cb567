// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/window_steps.h"
#include "ui/messages/messages.h"

#include <QtTest>

using namespace burin;
using namespace burin::testing;

class TestWindowShow : public QObject {
    Q_OBJECT
private slots:
    void theVirtualOperatorShowsHowItIsDone();
};

void TestWindowShow::theVirtualOperatorShowsHowItIsDone() {
    WindowDriver driver;
    Workbench& bench = driver.window().workbench();
    QVERIFY(driver.clickOn("welcomeShowMeButton"));
    QVERIFY(
        driver.waitFor([&] { return bench.session.running() && bench.session.state().recordedSeconds > 20.0; }, 60000));
    driver.shoot("14-show-me");
    QVERIFY(driver.clickOn("showMeButton")); // stops it
    QVERIFY(driver.waitFor([&] { return !bench.session.running() && !bench.showMe.showing(); }, 5000));
    QVERIFY(driver.waitFor([&] { return !bench.mill.takes().empty() && bench.mill.takes().front().complete; }));
    QVERIFY(bench.mill.takes().front().sampleCount >= 20000); // what was recorded stays
    QVERIFY(driver.waitFor([&] { return bench.path.evaluated() != nullptr || bench.path.problem(); }));
    QVERIFY2(!bench.path.problem(), bench.path.problem() ? qPrintable(Messages::sentence(*bench.path.problem())) : "");
    driver.shoot("15-shown-path");
}

QTEST_MAIN(TestWindowShow)
#include "tst_window_show.moc"
