// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QComboBox>
#include <QScrollArea>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_axis {

using namespace burin::testing;

namespace {

bool choose(WindowDriver& driver, const char* name, int index) {
    auto* choice = driver.window().findChild<QComboBox*>(QLatin1String(name));
    if (choice == nullptr) return false;
    choice->setCurrentIndex(index);
    emit choice->activated(index);
    return true;
}

} // namespace

class TestWindowAxis : public QObject {
    Q_OBJECT
private slots:
    void theToolStandsAsChosen();
};

void TestWindowAxis::theToolStandsAsChosen() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    QVERIFY(choose(driver, "axisChoice", 1));
    QVERIFY(driver.enter("axisLeanField", "25"));
    QVERIFY(driver.settle());
    QVERIFY(driver.waitFor(
        [&] { return std::abs(workbench.workpiece.bound().axis.direction.z - std::cos(25.0 * pi / 180.0)) < 1e-9; }));
    driver.shoot("18-chosen-axis");
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.clickOn("millButton"));
    QVERIFY(driver.waitFor([&] { return workbench.mill.active(); }));
    const glm::dvec3 axis = workbench.workpiece.bound().axis.direction;
    bool stood = true;
    int ticks = 0;
    QObject::connect(&workbench.session, &SessionRunner::ticked, this, [&] {
        if (!workbench.session.state().cutting) return;
        ++ticks;
        stood = stood && glm::distance(workbench.session.state().sample.proxy.axis, axis) < 1e-9;
    });
    millLine(driver, {-15, 0}, {15, 0});
    QVERIFY(ticks > 10 && stood);
    driver.shoot("19-milled-leaning");
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));

    driver.window().viewport().setStandardView(StandardView::top);
    QTest::qWait(400);
    driver.key(Qt::Key_X, Qt::ControlModifier | Qt::ShiftModifier); // along the view direction: straight down
    QVERIFY(driver.waitFor([&] { return workbench.surroundings.axis().direction.z > 1.0 - 1e-9; }));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return glm::distance(workbench.surroundings.axis().direction, axis) < 1e-9; }));
    QVERIFY(driver.settle());
}

BURIN_TEST(TestWindowAxis, QApplication)

} // namespace burin::tst_window_axis

#include "tst_window_axis.moc"
