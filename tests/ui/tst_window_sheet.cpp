// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The setup sheet, from the window.
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QtTest>

namespace burin::tst_window_sheet {

using namespace burin::testing;

class TestWindowSheet : public QObject {
    Q_OBJECT
private slots:
    /// It shows the job as the window has it, saved or not, and does not interrupt the work.
    void theSetupSheetIsWritten() {
        WindowDriver driver;
        QVERIFY(!menuAction(driver, "exportSheetAction")->isEnabled());
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(recordLine(driver, {-15, 0}, {15, 0}));
        QVERIFY(newPath(driver) && postProgram(driver));
        const QString file = driver.folder().filePath("sheet.html");
        chooseFile(driver, file);
        driver.key(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return driver.message().contains("sheet.html"); }));
        QFile page(file);
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QByteArray text = page.readAll();
        QVERIFY(text.contains("50 × 40 × 30") && text.contains("G54") && text.contains("data:image/png"));
        QCOMPARE(text.count("<svg class=\"tool\""), 1);
        QVERIFY(!text.contains("There is no checked program"));
        driver.shoot("sheet-1-written");
    }

    /// A sheet that was asked for is written although the window is closed at once.
    void closingTheWindowLosesNoSheet() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        const QString file = driver.folder().filePath("closed.html");
        chooseFile(driver, file);
        driver.key(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return workbenchOf(driver).sheet.writing(); }));
        QVERIFY(!QFile::exists(file));
        driver.whenDialogStands([](QWidget& dialog) { answer(dialog, "discardButton"); });
        driver.window().close();
        QVERIFY(driver.waitFor([&] { return !driver.window().isVisible(); }));
        QFile page(file);
        QVERIFY(page.open(QIODevice::ReadOnly));
        QVERIFY(page.readAll().endsWith("</html>\n"));
    }

    void aSheetIsCancelledAsAnyTask() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        const QString file = driver.folder().filePath("cancelled.html");
        workbenchOf(driver).sheet.write(QStringLiteral("job"), file);
        QVERIFY(driver.waitFor([&] { return workbenchOf(driver).tasks().running(TaskKind::sheet); }));
        workbenchOf(driver).tasks().cancelAll();
        QVERIFY(driver.waitFor([&] { return !workbenchOf(driver).sheet.writing(); }));
        QVERIFY(driver.settle());
        QVERIFY(!QFile::exists(file));
    }

    void aFolderThatIsNotThereIsSaid() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        workbenchOf(driver).sheet.write(QStringLiteral("job"), driver.folder().filePath("none/sheet.html"));
        QVERIFY(driver.waitFor([&] { return driver.message().contains("sheet.html"); }));
        QVERIFY(!QFile::exists(driver.folder().filePath("none")));
    }

private:
    static Workbench& workbenchOf(WindowDriver& driver) { return driver.window().workbench(); }
};

BURIN_TEST(TestWindowSheet, QApplication)

} // namespace burin::tst_window_sheet

#include "tst_window_sheet.moc"
