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
    Workbench& workbench = driver.window().workbench();
    QVERIFY(driver.clickOn("welcomeShowMeButton"));
    QVERIFY(driver.waitFor(
        [&] { return workbench.session.running() && workbench.session.state().recordedSeconds > 20.0; }, 60000));
    driver.shoot("14-show-me");
    QVERIFY(driver.clickOn("showMeButton")); // stops it
    QVERIFY(driver.waitFor([&] { return !workbench.session.running() && !workbench.showMe.showing(); }, 5000));
    QVERIFY(driver.waitFor([&] { return !workbench.mill.takes().empty() && workbench.mill.takes().front().complete; }));
    QVERIFY(workbench.mill.takes().front().sampleCount >= 20000); // what was recorded stays
    QVERIFY(driver.waitFor([&] { return workbench.path.evaluated() != nullptr || workbench.path.problem(); }));
    QVERIFY2(!workbench.path.problem(),
             workbench.path.problem() ? qPrintable(Messages::sentence(*workbench.path.problem())) : "");
    driver.shoot("15-shown-path");
}

QTEST_MAIN(TestWindowShow)
#include "tst_window_show.moc"
