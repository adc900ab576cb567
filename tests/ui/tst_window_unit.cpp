// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The unit of a part's file, replaced in the window.
#include "core/cad/file_unit.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_unit {

using namespace burin::testing;

namespace {

/// Opens a list and clicks on a text.
bool chooseByMouse(WindowDriver& driver, QComboBox& box, const QString& text) {
    QTest::mouseClick(&box, Qt::LeftButton);
    QAbstractItemView& list = *box.view();
    if (!driver.waitFor([&] { return list.isVisible(); })) return false;
    // A release right after the press that opened the list only ends that click.
    QTest::qWait(QApplication::doubleClickInterval() + 100);
    const int item = box.findText(text);
    if (item < 0) return false;
    const QModelIndex index = list.model()->index(item, 0);
    list.scrollTo(index);
    QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, list.visualRect(index).center());
    return true;
}

bool showsText(WindowDriver& driver, const QString& text) {
    for (const QLabel* label : driver.window().findChildren<QLabel*>())
        if (label->isVisible() && label->text() == text) return true;
    return false;
}

} // namespace

class TestWindowUnit : public QObject {
    Q_OBJECT
private slots:
    /// A tetrahedron with edges along the axes of 2 cm, which its file states: 8/3 cm³. In mm it is a thousandth.
    /// Margins and materials stay, a suitable voxel stays a suitable one, and one undo restores the stated unit.
    void aStatedUnitIsReplaced() {
        WindowDriver driver;
        drop(driver.window(), QStringLiteral(BURIN_FIXTURES "/models/tet.step"));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(driver.waitFor([&] { return workbench.setup.hasPart(); }));
        QVERIFY(driver.settle() && driver.step(JobStep::part));
        const auto volume = [&] { return workbench.setup.part()->volume(); };
        QVERIFY(std::abs(volume() - 8000.0 / 3.0) < 1e-6);
        workbench.setup.chooseBodyMaterial(0, "oak");
        Setup margins = workbench.setup.setup();
        margins.marginLow = glm::dvec3(1.5);
        workbench.setup.edit(margins);
        const double voxel = workbench.setup.setup().voxel;
        auto* unit = driver.visible<QComboBox>("fileUnit");
        QVERIFY(unit != nullptr);
        QCOMPARE(unit->currentText(), QString("cm (stated)"));
        QVERIFY(!showsText(driver, "Size as stated"));
        QVERIFY(chooseByMouse(driver, *unit, "mm"));
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(volume() - 8.0 / 3.0) < 1e-9, 30000);
        QVERIFY(driver.settle());
        QTRY_COMPARE(unit->currentText(), QString("mm"));
        QVERIFY(showsText(driver, "Size as stated"));
        driver.shoot("unit-1-replaced");
        QVERIFY(unitReplaced(*workbench.model.model()));
        QCOMPARE(workbench.setup.setup().marginLow, glm::dvec3(1.5));
        QCOMPARE(workbench.setup.setup().bodyMaterials, std::vector<std::string>{"oak"});
        QVERIFY(workbench.setup.setup().voxel < voxel);
        // The choice is kept in the file, and when the part is read again.
        const QString file = driver.folder().filePath("unit.burin");
        QVERIFY(saveAs(driver, file));
        QVERIFY(unitReplaced(*Project::openForReading(file.toStdString())->model()));
        driver.key(Qt::Key_U, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(driver.message().contains("not changed"));
        QVERIFY(std::abs(volume() - 8.0 / 3.0) < 1e-9);
    }

    void oneUndoRestoresIt() {
        WindowDriver driver;
        drop(driver.window(), QStringLiteral(BURIN_FIXTURES "/models/tet.step"));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(driver.waitFor([&] { return workbench.setup.hasPart(); }));
        QVERIFY(driver.settle() && driver.step(JobStep::part));
        const Setup before = workbench.setup.setup();
        QVERIFY(chooseByMouse(driver, *driver.visible<QComboBox>("fileUnit"), "inch"));
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(workbench.setup.part()->box().size().x - 50.8) < 1e-6, 30000);
        QVERIFY(driver.settle());
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(std::abs(workbench.setup.part()->box().size().x - 20.0) < 1e-6);
        QCOMPARE(workbench.setup.setup().voxel, before.voxel);
        QCOMPARE(workbench.setup.setup().stock.high, before.stock.high);
        driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(std::abs(workbench.setup.part()->box().size().x - 50.8) < 1e-6);
    }
};

BURIN_TEST(TestWindowUnit, QApplication)

} // namespace burin::tst_window_unit

#include "tst_window_unit.moc"
