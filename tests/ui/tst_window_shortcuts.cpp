// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Shortcuts that the user chooses, and a picture of the view, by mouse and keys.
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QDialog>
#include <QFile>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest>

#include <set>

namespace burin::tst_window_shortcuts {

using namespace burin::testing;

namespace {

/// Selects an action in the dialog by searching for its name.
bool select(QWidget& dialog, const QString& name) {
    auto* search = dialog.findChild<QLineEdit*>("shortcutSearch");
    auto* list = dialog.findChild<QTreeWidget*>("shortcutList");
    if (search == nullptr || list == nullptr) return false;
    search->setFocus();
    search->selectAll();
    QTest::keyClicks(search, name);
    for (int i = 0; i < list->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = list->topLevelItem(i);
        if (item->isHidden() || item->text(0) != name) continue;
        list->scrollToItem(item);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(item).center());
        return list->currentItem() == item;
    }
    return false;
}

void press(QWidget& dialog, const char* button) {
    QTest::mouseClick(dialog.findChild<QPushButton*>(button), Qt::LeftButton);
}

} // namespace

class TestWindowShortcuts : public QObject {
    Q_OBJECT
private slots:
    /// By default no two actions have the same keys.
    void eachHasItsOwn() {
        WindowDriver driver;
        std::set<QString> seen;
        for (const QAction* action : menuActions(driver)) {
            const QString keys = action->shortcut().toString();
            if (action == menuAction(driver, "exportAction") && seen.contains(keys)) continue; // in two menus
            QVERIFY2(!keys.isEmpty(), qPrintable(action->objectName()));
            QVERIFY2(seen.insert(keys).second, qPrintable(keys + " " + action->objectName()));
        }
        QVERIFY(seen.size() > 70);
    }

    /// New keys for an action, taken from another one, are kept, and can be reset.
    void keysAreChangedAndKept() {
        WindowDriver driver;
        QAction* fit = menuAction(driver, "fitAction");
        QAction* mill = menuAction(driver, "millModeAction");
        QVERIFY(fit && mill && fit->shortcut() == QKeySequence("F") && mill->shortcut() == QKeySequence("M"));
        driver.whenDialogStands([&](QWidget& dialog) {
            QVERIFY(select(dialog, "Fit"));
            auto* keys = dialog.findChild<QKeySequenceEdit*>("shortcutKeys");
            keys->setFocus();
            QTest::keyClick(keys, Qt::Key_M);
            QTRY_VERIFY(dialog.findChild<QLabel*>("shortcutConflict")->text().contains("Mill"));
            driver.shoot("shortcuts");
            press(dialog, "assignShortcutButton");
            QCOMPARE(fit->shortcut(), QKeySequence("M"));
            QVERIFY(mill->shortcut().isEmpty());
            static_cast<QDialog&>(dialog).reject();
        });
        driver.key(Qt::Key_Comma, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.restart());
        fit = menuAction(driver, "fitAction");
        mill = menuAction(driver, "millModeAction");
        QCOMPARE(fit->shortcut(), QKeySequence("M"));
        QVERIFY(mill->shortcut().isEmpty());
        driver.whenDialogStands([&](QWidget& dialog) {
            press(dialog, "resetShortcutsButton");
            static_cast<QDialog&>(dialog).reject();
        });
        driver.key(Qt::Key_Comma, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(fit->shortcut(), QKeySequence("F"));
        QCOMPARE(mill->shortcut(), QKeySequence("M"));
    }

    void thePictureOfTheViewIsWritten() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        const QString file = driver.folder().filePath("view.png");
        chooseFile(driver, file);
        driver.key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY2(driver.message().contains("view.png"), qPrintable(driver.message()));
        const QImage picture(file);
        const auto& viewport = *driver.visible<Viewport>("viewport");
        QCOMPARE(picture.size(), viewport.size() * viewport.devicePixelRatioF());
        // If it cannot be written, a sentence says so, and no partial file remains.
        chooseFile(driver, "/proc/view.png");
        driver.key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY2(driver.message().contains("/proc"), qPrintable(driver.message()));
    }
};

BURIN_TEST(TestWindowShortcuts, QApplication)

} // namespace burin::tst_window_shortcuts

#include "tst_window_shortcuts.moc"
