// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/messages/messages.h"

#include <QApplication>
#include <QtTest>

namespace burin::tst_window_show {

using namespace burin::testing;

class TestWindowShow : public QObject {
    Q_OBJECT
private slots:
    BURIN_ONLY_IN_LONG_RUNS void theVirtualOperatorShowsHowItIsDone();
};

void TestWindowShow::theVirtualOperatorShowsHowItIsDone() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(driver.clickOn("welcomeShowMeButton"));
    QVERIFY(driver.waitFor(
        [&] { return workbench.session.running() && workbench.session.state().recordedSeconds > 20.0; }, 60000));
    driver.shoot("14-show-me");
    QVERIFY(driver.clickOn("showMeButton")); // stops the demonstration
    QVERIFY(driver.waitFor([&] { return !workbench.session.running() && !workbench.showMe.showing(); }));
    QVERIFY(driver.waitFor([&] { return !workbench.mill.takes().empty() && workbench.mill.takes().front().complete; }));
    QVERIFY(workbench.mill.takes().front().sampleCount >= 20000); // the recording is kept
    QVERIFY(driver.waitFor([&] { return workbench.path.evaluated() != nullptr || workbench.path.problem(); }));
    QVERIFY2(!workbench.path.problem(),
             workbench.path.problem() ? qPrintable(Messages::sentence(*workbench.path.problem())) : "");
    driver.shoot("15-shown-path");
}

BURIN_TEST(TestWindowShow, QApplication)

} // namespace burin::tst_window_show

#include "tst_window_show.moc"
