// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Milling with the pen of a tablet, whose events Qt delivers to the window.
#include "core/base/units.h"
#include "core/geometry/angle.h"
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/tablet_pen.h"
#include "tests/ui/window_steps.h"
#include "ui/dialogs/preferences.h"
#include "ui/panels/notice.h"
#include "ui/scene/camera_view.h"

#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_window_tablet {

using namespace burin::testing;

class TestWindowTablet : public QObject {
    Q_OBJECT

private slots:
    void thePressureSetsTheDepth();
    BURIN_ONLY_IN_LONG_RUNS void thePressureSinksTheTool();
    void aTiltedPenLeansAFreeAxis();
    void aFixedAxisIgnoresTheTilt();
    void theEraserRetractsTheTool();
    void thePenMovesTheViewAndIsLost();
};

namespace {

/// A window in mill mode with a pen above the stock. Positions in mm from the middle of the stock's top.
struct Table {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    Viewport& viewport = driver.window().viewport();
    TabletPen pen{viewport};
    double lowest = 1e9;               ///< mm, z of the tip below the top while cutting
    glm::dvec3 leaning{0.0, 0.0, 1.0}; ///< the axis that leaned most while cutting

    bool begin(bool freeAxis = false) {
        if (!makeReady(driver, 1.0)) return false;
        if (freeAxis) {
            auto* choice = driver.window().findChild<QComboBox*>("axisChoice");
            choice->setCurrentIndex(2);
            emit choice->activated(2);
            if (!driver.waitFor([&] {
                    return workbench.workpiece.ready() && workbench.workpiece.bounds() &&
                           workbench.workpiece.bounds()->axis().free;
                }) ||
                !driver.settle())
                return false;
        }
        QObject::connect(&workbench.session, &SessionRunner::ticked, &driver.window(), [this] { watch(); });
        return driver.step(JobStep::mill) && driver.clickOn("millButton") &&
               driver.waitFor([&] { return workbench.mill.active(); });
    }
    double top() const { return workbench.setup.setup().workOffset.z; }
    void watch() {
        const SessionState& state = workbench.session.state();
        if (!state.cutting) return;
        lowest = std::min(lowest, state.sample.proxy.tip.z - top());
        if (state.sample.proxy.axis.z < leaning.z) leaning = state.sample.proxy.axis;
    }
    QPointF at(double x, double y) const {
        return viewport.project(workbench.setup.setup().workOffset + glm::dvec3(x, y, 0.0));
    }
    void putDown(double x, double y, double pressure) {
        pen.hover(at(x, y));
        QTest::qWait(300); // the tool arrives above
        pen.pressure = pressure;
        pen.press(at(x, y));
    }
    void drawTo(double x, double y, double fromX) {
        for (int i = 1; i <= 30; ++i) {
            pen.drag(at(fromX + (x - fromX) * i / 30.0, y));
            QTest::qWait(15);
        }
        QTest::qWait(300);
    }
    double lean() const { return angleBetween(leaning, {0.0, 0.0, 1.0}) * 180.0 / pi; } ///< degrees
    /// @param wanted  degrees of lean for which the pen is held at the end, as a free axis turns no faster than a hand
    void line(double y, double pressure, double wanted = 0.0) {
        lowest = 1e9;
        putDown(-12.0, y, pressure);
        drawTo(12.0, y, -12.0);
        if (wanted > 0.0) driver.waitFor([&] { return std::abs(lean() - wanted) < 0.5; });
        pen.release(at(12.0, y));
        driver.waitFor([this] { return !workbench.mill.stylus()->strokeUnderWay(); });
    }
};

} // namespace

void TestWindowTablet::thePressureSetsTheDepth() {
    Table table;
    QVERIFY(table.begin());
    QVERIFY(!table.driver.visible("penDepthButton")); // no pen was seen yet
    table.line(0.0, 0.25);                            // of the depth of cut, 1 mm
    QVERIFY2(std::abs(table.lowest + 0.25) < 0.02, qPrintable(QString::number(table.lowest)));
    QVERIFY(table.driver.waitFor([&] { return table.driver.visible("penDepthButton") != nullptr; }));
    const double shallow = removedSoFar(*table.workbench.workpiece.milling());
    table.line(9.0, 0.75);
    QVERIFY2(std::abs(table.lowest + 0.75) < 0.02, qPrintable(QString::number(table.lowest)));
    // Lines of the same length: the deeper one removes more.
    const double deep = removedSoFar(*table.workbench.workpiece.milling()) - shallow;
    QVERIFY(shallow > 0.0 && deep > shallow);
    QCOMPARE(table.workbench.mill.takes().size(), std::size_t{1});
    table.driver.shoot("tablet-1-depth");
    // The mouse mills as before, at full depth.
    table.lowest = 1e9;
    millLine(table.driver, {-12.0, -9.0}, {12.0, -9.0});
    QVERIFY2(std::abs(table.lowest + 1.0) < 0.02, qPrintable(QString::number(table.lowest)));
}

void TestWindowTablet::thePressureSinksTheTool() {
    Table table;
    QVERIFY(table.begin());
    table.pen.hover(table.at(0.0, 0.0));
    QVERIFY(table.driver.clickOn("penSinkButton"));
    QVERIFY(table.driver.enter("sinkSpeedField", "1"));
    QVERIFY(table.driver.waitFor([] { return UserSettings().penSinks() && UserSettings().penSinkSpeed() == 1.0; }));
    table.putDown(0.0, 0.0, 0.5);
    QVERIFY(table.driver.waitFor([&] { return table.lowest < -0.1; }));
    const double before = table.lowest;
    QElapsedTimer clock;
    clock.start();
    QTest::qWait(500); // the pen rests: no events
    const double sunk = before - table.lowest, seconds = 1e-3 * static_cast<double>(clock.elapsed());
    QVERIFY2(std::abs(sunk - 0.5 * seconds) < 0.12, qPrintable(QString::number(sunk))); // 0.5 mm/s at half the pressure
    QVERIFY(table.driver.waitFor([&] { return table.lowest < -0.995; }));
    QTest::qWait(300);
    QVERIFY(table.lowest > -1.02); // not below the depth of cut
    table.pen.release(table.at(0.0, 0.0));
}

void TestWindowTablet::aTiltedPenLeansAFreeAxis() {
    Table table;
    QVERIFY(table.begin(true));
    table.pen.tiltRight = 20.0;
    table.line(0.0, 1.0, 20.0);
    const glm::dvec3 right = axesOf(table.viewport.cameraView()).right;
    QVERIFY2(std::abs(table.lean() - 20.0) < 0.5, qPrintable(QString::number(table.lean())));
    const glm::dvec3 aside = glm::normalize(glm::dvec3(table.leaning.x, table.leaning.y, 0.0));
    QVERIFY(glm::dot(aside, right) > 0.999);
    table.pen.tiltRight = 0.0;
    table.pen.tiltTowardsUser = 30.0;
    table.leaning = {0.0, 0.0, 1.0};
    table.line(8.0, 1.0, 30.0);
    const glm::dvec3 towards = glm::cross(right, glm::dvec3(0.0, 0.0, 1.0));
    QVERIFY2(std::abs(table.lean() - 30.0) < 0.5, qPrintable(QString::number(table.lean())));
    QVERIFY(glm::dot(glm::normalize(glm::dvec3(table.leaning.x, table.leaning.y, 0.0)), towards) > 0.999);
    table.driver.shoot("tablet-2-tilt");
}

void TestWindowTablet::aFixedAxisIgnoresTheTilt() {
    Table table;
    QVERIFY(table.begin());
    table.pen.tiltRight = 40.0;
    table.line(0.0, 1.0);
    QCOMPARE(table.leaning.z, 1.0);
    const auto* hint = table.driver.visible<Notice>("millHint");
    QVERIFY(hint != nullptr && hint->sentence().contains("tilt has no effect"));
    table.driver.shoot("tablet-3-fixed");
}

void TestWindowTablet::theEraserRetractsTheTool() {
    Table table;
    QVERIFY(table.begin());
    table.putDown(-12.0, 0.0, 1.0);
    table.drawTo(0.0, 0.0, -12.0);
    QVERIFY(table.workbench.session.state().cutting);
    table.pen.release(table.at(0.0, 0.0));
    table.pen.leave();
    table.pen.eraser = true;
    table.pen.hover(table.at(2.0, 0.0));
    table.pen.pressure = 1.0;
    table.pen.press(table.at(2.0, 0.0));
    table.lowest = 1e9;
    table.pen.drag(table.at(6.0, 0.0));
    const double above = table.workbench.workpiece.milling()->setup.stock.high.z;
    QVERIFY(table.driver.waitFor([&] { return table.workbench.mill.stylus()->tip().z > above + 1.99; }));
    QVERIFY(table.driver.waitFor([&] { return !table.workbench.session.state().cutting; }));
    QTest::qWait(300); // it does not settle lower
    QVERIFY(table.workbench.mill.stylus()->tip().z > above + 1.99);
    table.pen.release(table.at(6.0, 0.0));
    QVERIFY(table.lowest > 0.0); // nothing was cut
}

void TestWindowTablet::thePenMovesTheViewAndIsLost() {
    Table table;
    QVERIFY(table.begin());
    const double azimuth = table.viewport.cameraView().azimuth;
    const QPointF middle(table.viewport.width() / 2.0, table.viewport.height() / 2.0);
    table.pen.press(middle, Qt::RightButton); // of its barrel
    table.pen.drag(middle + QPointF(40.0, 0.0));
    table.pen.drag(middle + QPointF(80.0, 0.0));
    table.pen.release(middle + QPointF(80.0, 0.0), Qt::RightButton);
    QVERIFY(std::abs(table.viewport.cameraView().azimuth - azimuth) > 0.05);
    table.putDown(-12.0, 0.0, 1.0);
    table.drawTo(0.0, 0.0, -12.0);
    QVERIFY(table.workbench.session.state().cutting);
    table.pen.leave(); // torn away: its release is never reported
    QVERIFY(table.driver.waitFor([&] { return !table.workbench.mill.stylus()->strokeUnderWay(); }));
    QTRY_VERIFY(!table.workbench.session.state().cutting);
}

BURIN_TEST(TestWindowTablet, QApplication)

} // namespace burin::tst_window_tablet

#include "tst_window_tablet.moc"
