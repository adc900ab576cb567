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
    /// It is of the job as the window has it, saved or not; and it does not stop the work.
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

    void aFolderThatIsNotThereIsSaid() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        workbenchOf(driver).sheet.gather(QStringLiteral("job"), driver.folder().filePath("none/sheet.html"));
        QVERIFY(driver.waitFor([&] { return driver.message().contains("sheet.html"); }));
        QVERIFY(!QFile::exists(driver.folder().filePath("none")));
    }

private:
    static Workbench& workbenchOf(WindowDriver& driver) { return driver.window().workbench(); }
};

BURIN_TEST(TestWindowSheet, QApplication)

} // namespace burin::tst_window_sheet

#include "tst_window_sheet.moc"
