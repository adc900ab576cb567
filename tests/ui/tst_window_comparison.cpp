// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Compares a path with another version of it, by mouse and keys.
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/scene/camera_view.h"
#include "ui/scene/viewport.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_comparison {

using namespace burin::testing;

namespace {

PathController& pathOf(WindowDriver& driver) {
    return driver.window().workbench().path;
}

bool isEvaluated(WindowDriver& driver) {
    const PathController& path = pathOf(driver);
    return path.evaluated() && !path.outdated() && !path.busy();
}

/// Adds two slots across the top of the block, and an edit that shifts them by 0.25 mm.
bool openShifted(WindowDriver& driver) {
    const QString name = driver.folder().filePath("slots.nc");
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly)) return false;
    file.write("G21 G90 G17 G94 G54\nM3 S9000\nG0 X-18 Y-5\nZ5\nG1 Z-1 F150\nX18 F480\nG0 Z5\nX18 Y5\nG1 Z-2 F150\n"
               "X-18 F240\nG0 Z20\nM30\n");
    file.close();
    chooseFile(driver, name);
    driver.key(Qt::Key_G, Qt::ControlModifier | Qt::AltModifier);
    if (!driver.waitFor([&] { return isEvaluated(driver); })) return false;
    pathOf(driver).addEdit({HoldOut{}});
    pathOf(driver).addEdit({Offset{{}, 0.25}}); // before it
    return driver.waitFor([&] { return isEvaluated(driver); });
}

std::shared_ptr<const ComparedPaths> compared(WindowDriver& driver) {
    const PathComparer& comparer = driver.window().workbench().pathComparer;
    return comparer.busy() ? nullptr : comparer.compared();
}

void compareByKey(WindowDriver& driver) {
    driver.key(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
}

QString textOf(WindowDriver& driver, const char* name) {
    const auto* label = driver.visible<QLabel>(name);
    return label != nullptr ? label->text() : QString();
}

bool same(const CameraView& one, const CameraView& other) {
    return one.focus == other.focus && one.azimuth == other.azimuth && one.elevation == other.elevation &&
           one.distance == other.distance;
}

} // namespace

class TestWindowComparison : public QObject {
    Q_OBJECT
private slots:
    /// Compares with the recording, then without an edit; the view moves to the largest deviation and back.
    void aPathIsComparedWithItsVersions() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(!menuAction(driver, "comparePathsAction")->isEnabled()); // there is no path yet
        QVERIFY(openShifted(driver));
        auto& viewport = *driver.visible<Viewport>("viewport");
        const CameraView view = viewport.cameraView();
        QVERIFY(driver.settle());
        const QImage before = viewport.grabFramebuffer();

        compareByKey(driver);
        QVERIFY(driver.waitFor([&] { return compared(driver) != nullptr; }));
        QVERIFY(driver.visible("comparisonDialog") != nullptr);
        const PathDifference& values = compared(driver)->values;
        QVERIFY(values.ofFirst && std::abs(values.ofFirst->largest - 0.25) < 0.002);
        QVERIFY(std::abs(values.second.cutting - 85.0) < 0.01);
        QTRY_COMPARE(textOf(driver, "comparedCuttingFirst"), lengthText(values.first.cutting, LengthUnit::millimetre));
        QCOMPARE(textOf(driver, "comparedPointsSecond"), QString::number(values.second.points));
        QTRY_VERIFY(viewport.grabFramebuffer() != before);
        driver.shoot("comparison-1-recorded");

        // Choose the first version without an edit from the list.
        auto* version = driver.visible<QComboBox>("comparedVersion");
        version->setFocus();
        QTest::keyClick(version, Qt::Key_Down);
        QTRY_COMPARE(driver.window().workbench().pathComparer.version().kind, PathVersion::Kind::withoutEdit);
        QVERIFY(driver.waitFor([&] { return compared(driver) != nullptr; }));
        driver.shoot("comparison-2-without-an-edit");

        // Nothing is marked within the tolerance; both slots lie entirely outside the default tolerance.
        QTest::keyClick(version, Qt::Key_Home);
        QVERIFY(driver.waitFor(
            [&] { return compared(driver) != nullptr && compared(driver)->values.ofFirst->farther > 71.0; }));
        QVERIFY(driver.enter("comparedTolerance", "0.3"));
        QVERIFY(
            driver.waitFor([&] { return compared(driver) != nullptr && compared(driver)->values.tolerance == 0.3; }));
        QCOMPARE(compared(driver)->values.ofFirst->farther, 0.0);

        QVERIFY(driver.clickOn("largestFirst"));
        QVERIFY(!same(viewport.cameraView(), view));
        QCOMPARE(viewport.cameraView().focus, compared(driver)->values.ofFirst->largestAt);
        driver.shoot("comparison-3-largest");
        auto* shown = driver.visible<QDialog>("comparisonDialog");

        QTest::mouseClick(shown->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Close), Qt::LeftButton);
        QTRY_VERIFY(driver.visible("comparisonDialog") == nullptr);
        QVERIFY(same(viewport.cameraView(), view));
        QVERIFY(!driver.window().workbench().pathComparer.isOpen());
        QVERIFY(driver.settle());
        QTRY_VERIFY(viewport.grabFramebuffer() == before);
    }

    /// The comparison follows the edits and ends with the path. A hidden path is visible while it is compared.
    BURIN_ONLY_IN_LONG_RUNS void theComparisonFollowsThePath() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(openShifted(driver));
        driver.key(Qt::Key_4, Qt::ControlModifier);
        QVERIFY(!menuAction(driver, "showPathAction")->isChecked());
        auto& viewport = *driver.visible<Viewport>("viewport");
        QVERIFY(driver.settle());
        const QImage hidden = viewport.grabFramebuffer();
        compareByKey(driver);
        QVERIFY(driver.waitFor([&] { return compared(driver) != nullptr; }));
        const std::vector<Edit>& edits = pathOf(driver).stored()->edits;
        std::size_t offset = 0;
        while (!std::holds_alternative<Offset>(edits[offset].parameters)) ++offset;
        pathOf(driver).changeEdit(offset, {Offset{{}, -0.5}});
        QVERIFY(driver.waitFor([&] {
            return compared(driver) != nullptr && std::abs(compared(driver)->values.ofFirst->largest - 0.5) < 0.002;
        }));
        auto* dialog = driver.visible<QDialog>("comparisonDialog");
        dialog->close();
        QTRY_VERIFY(driver.visible("comparisonDialog") == nullptr);
        QVERIFY(driver.settle());
        QTRY_VERIFY(viewport.grabFramebuffer() == hidden);

        compareByKey(driver);
        QVERIFY(driver.waitFor([&] { return compared(driver) != nullptr; }));
        // An edit was changed, two were added, and the path was made.
        for (int i = 0; i < 4; ++i) {
            driver.window().workbench().undoLast();
            QVERIFY(driver.settle());
        }
        QTRY_VERIFY(pathOf(driver).stored() == nullptr);
        QVERIFY(compared(driver) == nullptr);
        QTRY_VERIFY(!menuAction(driver, "comparePathsAction")->isEnabled());
        QTRY_COMPARE(textOf(driver, "comparedCuttingFirst"), QStringLiteral("–"));
    }
};

BURIN_TEST(TestWindowComparison, QApplication)

} // namespace burin::tst_window_comparison

#include "tst_window_comparison.moc"
