// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The area of the next pass, painted by mouse and keys.
#include "core/base/units.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QComboBox>
#include <QtTest>

namespace burin::tst_window_area {

using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

double paintedArea(WindowDriver& driver) {
    return areaInPlan(workbenchOf(driver).area.area());
}

/// The point on the top of the block at an offset from its middle, mm.
glm::dvec3 onTop(WindowDriver& driver, const glm::dvec2& place) {
    const Box part = workbenchOf(driver).setup.part()->box();
    return {glm::dvec2(part.centre()) + place, part.high.z};
}

/// A drag along points on the block's top.
void drag(WindowDriver& driver, const std::vector<glm::dvec2>& corners, Qt::KeyboardModifiers modifiers = {}) {
    Viewport& viewport = driver.window().viewport();
    const auto at = [&](const glm::dvec2& place) { return viewport.project(onTop(driver, place)).toPoint(); };
    QTest::mouseMove(&viewport, at(corners.front()));
    QTest::mousePress(&viewport, Qt::LeftButton, modifiers, at(corners.front()));
    for (std::size_t i = 1; i < corners.size(); ++i)
        for (int k = 1; k <= 10; ++k) {
            QMouseEvent event(QEvent::MouseMove, at(glm::mix(corners[i - 1], corners[i], k / 10.0)),
                              viewport.mapToGlobal(at(glm::mix(corners[i - 1], corners[i], k / 10.0))), Qt::NoButton,
                              Qt::LeftButton, modifiers);
            QCoreApplication::sendEvent(&viewport, &event);
        }
    driver.shoot("area-0-under-way");
    QTest::mouseRelease(&viewport, Qt::LeftButton, modifiers, at(corners.back()));
}

bool isNear(double area, double expected) {
    return std::abs(area - expected) <= 0.03 * expected; // the pointer has whole pixels only
}

/// Prepares painting on a block of 40 x 30 x 20 mm, seen from above.
bool makeReadyToPaint(WindowDriver& driver) {
    if (!makeReady(driver, 1.0)) return false;
    workbenchOf(driver).tool.choose("ball-6");
    if (!driver.waitFor([&] { return workbenchOf(driver).passes.possible(); }) || !driver.step(JobStep::path))
        return false;
    driver.window().viewport().setStandardView(StandardView::top);
    QTest::qWait(600);
    return true;
}

} // namespace

class TestWindowArea : public QObject {
    Q_OBJECT
private slots:
    /// A stroke of 20 mm with a brush of 10 mm is a slot with round ends; Shift erases; each stroke is one undo step.
    void aBrushPaintsAndErases() {
        WindowDriver driver;
        QVERIFY(makeReadyToPaint(driver));
        driver.key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(driver.visible("brushDiameter") != nullptr);
        drag(driver, {{-10.0, 0.0}, {10.0, 0.0}});
        QTRY_VERIFY2(isNear(paintedArea(driver), 20.0 * 10.0 + pi * 25.0),
                     qPrintable(QString::number(paintedArea(driver))));
        QTest::qWait(300);
        driver.shoot("area-1-brushed");
        drag(driver, {{0.0, -15.0}, {0.0, 15.0}}, Qt::ShiftModifier);
        // What remains after erasing a stripe of 10 mm across it.
        QTRY_VERIFY2(isNear(paintedArea(driver), 10.0 * 10.0 + pi * 25.0),
                     qPrintable(QString::number(paintedArea(driver))));
        QTest::qWait(300);
        driver.shoot("area-2-erased");
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(paintedArea(driver), 0.0);
        driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(paintedArea(driver) > 0.0);
        QVERIFY(driver.clickOn("clearAreaButton"));
        QTRY_COMPARE(paintedArea(driver), 0.0);
        // Esc ends painting: a drag moves the camera again.
        driver.window().viewport().setFocus();
        driver.key(Qt::Key_Escape);
        QTRY_VERIFY(driver.visible("brushDiameter") == nullptr);
        drag(driver, {{-10.0, 0.0}, {10.0, 0.0}});
        QCOMPARE(paintedArea(driver), 0.0);
    }

    /// A triangle, and the face under a click; both areas are known.
    void lassoAndFace() {
        WindowDriver driver;
        QVERIFY(makeReadyToPaint(driver));
        QVERIFY(driver.clickOn("lassoAreaButton"));
        drag(driver, {{-10.0, -8.0}, {10.0, -8.0}, {0.0, 8.0}});
        QTRY_VERIFY2(isNear(paintedArea(driver), 160.0), qPrintable(QString::number(paintedArea(driver))));
        QTest::qWait(300);
        driver.shoot("area-3-lasso");
        QVERIFY(driver.clickOn("faceAreaButton"));
        Viewport& viewport = driver.window().viewport();
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.project(onTop(driver, {3.0, 2.0})).toPoint());
        QTRY_VERIFY2(std::abs(paintedArea(driver) - 1200.0) < 0.1, qPrintable(QString::number(paintedArea(driver))));
        QTest::qWait(300);
        driver.shoot("area-4-face");
    }

    /// The pass stays within the area; the area is preserved when saved and after a restart.
    void aPassStaysInTheArea() {
        WindowDriver driver;
        QVERIFY(makeReadyToPaint(driver));
        driver.key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        drag(driver, {{-10.0, 0.0}, {10.0, 0.0}});
        QTRY_VERIFY(paintedArea(driver) > 0.0);
        const double painted = paintedArea(driver);
        driver.whenDialogStands([&](QWidget& dialog) {
            auto* kind = dialog.findChild<QComboBox*>("passKind");
            kind->setFocus();
            for (int i = 0; i < 4; ++i) QTest::keyClick(kind, Qt::Key_Down);
            driver.shoot("area-5-dialog");
            QCOMPARE(dialog.findChild<QComboBox*>("passArea")->currentIndex(), 2);
            QTest::mouseClick(dialog.findChild<QWidget*>("computePassButton"), Qt::LeftButton);
        });
        QVERIFY(driver.clickOn("newPassButton"));
        const PathController& path = workbenchOf(driver).path;
        QTRY_VERIFY_WITH_TIMEOUT(path.evaluated() && !path.outdated() && !path.busy(), 30000);
        std::size_t cuts = 0;
        for (const PathPoint& point : path.evaluated()->path.points) {
            if (point.kind != MoveKind::cut) continue;
            const glm::dvec2 at = glm::dvec2(point.pose.tip) - glm::dvec2(onTop(driver, {0.0, 0.0}));
            const double beside = glm::distance(at, {std::clamp(at.x, -10.0, 10.0), 0.0});
            if (std::abs(point.pose.tip.z - onTop(driver, {}).z) > 0.01) continue; // a lead
            QVERIFY2(beside < 5.3, qPrintable(QString("%1 %2").arg(at.x).arg(at.y)));
            ++cuts;
        }
        QVERIFY2(cuts >= 40, qPrintable(QString::number(cuts))); // 25 rows with two ends each, some of them joined
        QTest::qWait(300);
        driver.shoot("area-6-milled");
        const QString file = driver.folder().filePath("area.burin");
        QVERIFY(saveAs(driver, file));
        QVERIFY(driver.restart());
        drop(driver.window(), file);
        QTRY_VERIFY(std::abs(paintedArea(driver) - painted) < 1e-3);
    }
};

BURIN_TEST(TestWindowArea, QApplication)

} // namespace burin::tst_window_area

#include "tst_window_area.moc"
