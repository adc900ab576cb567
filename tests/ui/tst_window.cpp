// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/scene/viewport.h"

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QtTest>

#include <algorithm>

namespace burin::tst_window {

using namespace burin::testing;

class TestWindow : public QObject {
    Q_OBJECT
private slots:
    void settingsCanBeTakenBack();
    void unitAndThemeChangeAtOnce();
    void aPreferenceRestylesNothingThatItDoesNotConcern();
    void allKeysAreListed();
    void unsavedChangesAreGuarded();
    void aWrongFileCostsOneSentence();
    void unsavedWorkIsThereAfterAnEndFromOutside();
    void workOfAProgramThatIsStillEndingIsOfferedOnceItHasEnded();
};

void TestWindow::settingsCanBeTakenBack() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    const double voxel = workbench.setup.setup().voxel;
    QCOMPARE(voxel, 0.5);
    auto* field = driver.visible<QWidget>("voxelField");
    QVERIFY(field != nullptr);
    field->setFocus();
    QTest::qWait(1100); // changes that follow immediately form a single undo entry
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, "1");
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(workbench.setup.setup().voxel, 1.0);
    QVERIFY(!workbench.workpiece.embedded());
    QVERIFY(driver.step(JobStep::material));
    QVERIFY(driver.step(JobStep::stock));
    driver.window().setFocus();
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(workbench.setup.setup().voxel, voxel);
    QVERIFY(workbench.workpiece.embedded()); // the same workpiece as before
    driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(workbench.setup.setup().voxel, 1.0);
    QVERIFY(driver.step(JobStep::stock));
    field->setFocus();
    QTest::qWait(1100);
    for (int i = 0; i < 3; ++i) QTest::keyClick(field, Qt::Key_Up);
    QTRY_COMPARE(workbench.setup.setup().voxel, 1.3);
    driver.window().setFocus();
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(workbench.setup.setup().voxel, 1.0);
}

void TestWindow::unitAndThemeChangeAtOnce() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    QVERIFY(driver.step(JobStep::allowance));
    auto* viewport = driver.visible<Viewport>("viewport");
    QVERIFY(viewport != nullptr);
    const auto scaleBar = [&] { return viewport->grabFramebuffer().copy(0, viewport->height() - 44, 300, 44); };
    bool scaleBarFollows = false;
    driver.whenDialogStands([&](QWidget& dialog) {
        const QImage millimetres = scaleBar();
        const auto chooseNext = [&](const char* choice) {
            auto* box = dialog.findChild<QComboBox*>(choice);
            box->setFocus();
            QTest::keyClick(box, Qt::Key_Down);
        };
        chooseNext("unitChoice");
        scaleBarFollows = driver.waitFor([&] { return scaleBar() != millimetres; });
        chooseNext("themeChoice");
        QTest::qWait(200);
        keepPicture(dialog, "08-preferences");
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    driver.key(Qt::Key_Comma, Qt::ControlModifier);
    QVERIFY(scaleBarFollows);
    driver.shoot("09-light-inch");
    QCOMPARE(driver.window().palette().color(QPalette::Window).lightness() > 128, true);
    auto* step = driver.visible<QWidget>("stepAllowance");
    QVERIFY(step != nullptr);
    QVERIFY(driver.restart(true)); // the preferences are restored at the next start
    QCOMPARE(UserSettings().preferences().unit, LengthUnit::inch);
    QCOMPARE(UserSettings().preferences().theme, Theme::light);
    driver.shoot("10-light-welcome");
}

namespace {

/// Counts how often each widget was told to update its style.
class StyleChanges : public QObject {
public:
    StyleChanges() { qApp->installEventFilter(this); }
    int most() const { return counts_.isEmpty() ? 0 : *std::ranges::max_element(counts_); }
    void forget() { counts_.clear(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::StyleChange) ++counts_[watched];
        return false;
    }

private:
    QHash<QObject*, int> counts_;
};

} // namespace

/// While all widgets are updated, the window does not respond.
void TestWindow::aPreferenceRestylesNothingThatItDoesNotConcern() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    int byLanguage = -1, byUnit = -1, byTheme = -1;
    driver.whenDialogStands([&](QWidget& dialog) {
        StyleChanges changes;
        const auto chooseNext = [&](const char* choice, int& most) {
            changes.forget();
            auto* box = dialog.findChild<QComboBox*>(choice);
            box->setFocus();
            const int before = box->currentIndex();
            QTest::keyClick(box, before == 0 ? Qt::Key_Down : Qt::Key_Up);
            QTest::qWait(200);
            most = box->currentIndex() == before ? -1 : changes.most();
        };
        chooseNext("languageChoice", byLanguage);
        chooseNext("unitChoice", byUnit);
        chooseNext("themeChoice", byTheme);
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    driver.key(Qt::Key_Comma, Qt::ControlModifier);
    QCOMPARE(byLanguage, 0);
    QCOMPARE(byUnit, 0);
    QVERIFY(byTheme >= 1);
}

void TestWindow::allKeysAreListed() {
    WindowDriver driver;
    driver.key(Qt::Key_F1, Qt::ControlModifier);
    auto* list = driver.window().findChild<KeyList*>();
    QVERIFY(list != nullptr && list->isVisible());
    const auto shown = [&] {
        QStringList texts;
        for (const QLabel* label : list->findChildren<QLabel*>())
            if (label->isVisible()) texts << label->text();
        return texts;
    };
    const QStringList all = shown();
    int shortcuts = 0;
    for (const QAction* action : driver.window().actions()) {
        if (action->shortcut().isEmpty()) continue;
        ++shortcuts;
        QVERIFY2(all.contains(action->shortcut().toString(QKeySequence::NativeText)), qPrintable(action->text()));
    }
    QVERIFY(shortcuts > 40);
    keepPicture(*list, "24-keys");
    auto* search = list->findChild<QLineEdit*>(QStringLiteral("keySearch"));
    QTest::keyClicks(search, "spindle");
    QVERIFY(shown().contains(QStringLiteral("Space")));
    QVERIFY(!shown().contains(QStringLiteral("Ctrl+S")));
    QTest::keyClicks(search, "xyz");
    QVERIFY(shown().contains(QStringLiteral("No key does that.")));
    search->clear();
    QCOMPARE(shown(), all);
    driver.key(Qt::Key_F1, Qt::ControlModifier);
    QCOMPARE(driver.window().findChildren<KeyList*>().size(), 1);
    QTest::keyClick(list, Qt::Key_Escape);
    QTRY_VERIFY(driver.window().findChild<KeyList*>() == nullptr);
}

void TestWindow::unsavedChangesAreGuarded() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    QTRY_VERIFY(driver.window().workbench().document.unsaved());
    bool asked = false;
    driver.whenDialogStands([&](QWidget& dialog) {
        keepPicture(dialog, "11-unsaved");
        asked = answer(dialog, "cancelButton");
    });
    driver.window().close();
    QVERIFY(asked);
    QVERIFY(driver.window().isVisible());
    driver.whenDialogStands([&](QWidget& dialog) { answer(dialog, "discardButton"); });
    QVERIFY(driver.restart());
    QVERIFY(driver.visible<QWidget>("recoverButton") == nullptr); // the recovery was declined
}

void TestWindow::aWrongFileCostsOneSentence() {
    WindowDriver driver;
    const QString file = driver.folder().filePath("letter.txt");
    QFile letter(file);
    QVERIFY(letter.open(QIODevice::WriteOnly) && letter.write("Dear Emil, this is no part.\n") > 0);
    letter.close();
    drop(driver.window(), file);
    QVERIFY(driver.waitFor([&] { return !driver.message().isEmpty(); }));
    QVERIFY2(driver.message().contains("letter.txt") && driver.message().endsWith('.'), qPrintable(driver.message()));
    driver.shoot("12-wrong-file");
    QVERIFY(driver.clickOn("dismissMessageButton"));
    QCOMPARE(driver.message(), QString());
    const QString project = driver.folder().filePath("no.burin");
    QVERIFY(QFile::copy(file, project));
    drop(driver.window(), project);
    QVERIFY(driver.waitFor([&] { return driver.message().contains("no.burin"); }));
}

void TestWindow::unsavedWorkIsThereAfterAnEndFromOutside() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    QVERIFY(driver.restart(true));
    driver.shoot("13-recover");
    QVERIFY(driver.clickOn("recoverButton"));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return workbench.model.model() != nullptr; }));
    QCOMPARE(workbench.model.model()->bodies.size(), std::size_t{1});
    QTRY_VERIFY(workbench.document.unsaved());
    QVERIFY(workbench.document.isUnnamed());
}

/// A program that is killed while the disk is busy keeps its work locked for seconds. A user who restarted Burin at
/// once was not offered that work.
void TestWindow::workOfAProgramThatIsStillEndingIsOfferedOnceItHasEnded() {
    WindowDriver driver;
    auto ending = std::make_unique<Workbench>();
    ending->document.createNew(false);
    QTRY_VERIFY(ending->document.isOpen());
    ending->tool.choose("flat-6");
    QTRY_VERIFY(ending->document.unsaved());
    QVERIFY(driver.restart(true));
    QVERIFY(driver.visible<QWidget>("recoverButton") == nullptr);
    ending.reset();
    QVERIFY(driver.waitFor([&] { return driver.visible<QWidget>("recoverButton") != nullptr; }));
}

BURIN_TEST(TestWindow, QApplication)

} // namespace burin::tst_window

#include "tst_window.moc"
