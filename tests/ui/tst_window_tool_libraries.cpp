// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/visible_texts.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/notice.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/row_list.h"
#include "ui/panels/value_row.h"

#include <QApplication>
#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QtTest>

namespace burin::tst_window_tool_libraries {

using namespace burin::testing;

namespace {

/// What is cut off in the dialog of tools. Sources are lines of text that scroll in their fields.
QStringList cutTexts(QWidget& dialog) {
    QStringList cut;
    for (const VisibleText& text : clippedTexts(dialog))
        if (!text.where.contains("Source")) cut << text.where + ": " + text.text;
    return cut;
}

/// Makes a dialog the active window, as a window manager would, and closes it even if a check failed in it, so that the
/// test ends as well.
class Closing {
public:
    explicit Closing(QWidget& dialog) : dialog_(qobject_cast<QDialog*>(&dialog)) {
        QApplication::setActiveWindow(&dialog);
    }
    ~Closing() {
        if (dialog_ && dialog_->isVisible()) dialog_->done(QDialog::Rejected);
    }

private:
    QPointer<QDialog> dialog_;
};

template <class T>
T& in(QWidget& dialog, const char* name) {
    T* found = dialog.findChild<T*>(QLatin1String(name));
    if (found == nullptr) qFatal("no widget %s", name);
    return *found;
}

void click(QWidget& dialog, const char* name) {
    QTest::mouseClick(&in<QWidget>(dialog, name), Qt::LeftButton);
}

/// By keys, as a user tabs into the field.
void type(QWidget& dialog, const char* name, const QString& text) {
    auto& field = in<QWidget>(dialog, name);
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

/// Chooses the entry with the data by keys.
void choose(QWidget& dialog, const char* name, const QString& data) {
    auto& box = in<ChoiceBox>(dialog, name);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Home);
    for (int i = box.findData(data); i > 0; --i) QTest::keyClick(&box, Qt::Key_Down);
    QCOMPARE(box.currentData().toString(), data);
}

/// Answers the next question for a name.
void nameNext(WindowDriver& driver, const QString& name) {
    driver.whenDialogStands([name](QWidget& asking) {
        auto* field = asking.findChild<QLineEdit*>();
        field->selectAll();
        QTest::keyClicks(field, name);
        QTest::keyClick(field, Qt::Key_Return);
    });
}

void openTools(WindowDriver& driver) {
    driver.window().setFocus();
    driver.key(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
}

/// The digits before the unit.
QString numberOf(const ValueRow& row) {
    QString digits;
    for (const QChar each : row.value()) {
        if (each.isDigit()) digits += each;
        if (each.isSpace()) break;
    }
    return digits;
}

const Tool* toolIn(const ToolController& tools, const std::string& id) {
    const auto found = std::ranges::find(tools.library(), id, &Tool::id);
    return found == tools.library().end() ? nullptr : &*found;
}

void pickEntry(QWidget& dialog, const char* name) {
    auto& menu = in<QMenu>(dialog, "toolLibraryMenu");
    QAction* action = menu.findChild<QAction*>(QLatin1String(name));
    if (action == nullptr) qFatal("no entry %s", name);
    QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(action).center());
    QTRY_VERIFY(dialog.findChild<QMenu*>("toolLibraryMenu") == nullptr);
}

} // namespace

/// Tool libraries and presets of feeds and speeds, by mouse and keys.
class TestWindowToolLibraries : public QObject {
    Q_OBJECT
private slots:
    /// A preset for the stock's material gives the feeds of the tool; undo restores those of the material.
    void aPresetIsEnteredAndUsed() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(makeReady(driver, 1.0));
        const QString material = QString::fromStdString(workbench.setup.stockMaterial()->id);
        QVERIFY(driver.step(JobStep::tool) && driver.settle());
        const QString byMaterial = driver.visible<ValueRow>("feed")->value();
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            QVERIFY(!in<QWidget>(dialog, "addPresetButton").isVisible()); // a shipped tool
            click(dialog, "copyToolButton");
            auto& area = *dialog.findChild<QScrollArea*>();
            area.ensureWidgetVisible(&in<QWidget>(dialog, "addPresetButton"));
            click(dialog, "addPresetButton");
            QVERIFY(in<QLineEdit>(dialog, "presetName0").hasFocus());
            QTest::keyClicks(&in<QLineEdit>(dialog, "presetName0"), "Roughing");
            // Without a speed it can't be saved, and the reason is stated.
            QVERIFY(!in<QPushButton>(dialog, "saveToolButton").isEnabled());
            QVERIFY(in<Notice>(dialog, "toolNotice").sentence().contains("Roughing"));
            choose(dialog, "presetMaterial0", material);
            type(dialog, "presetSpeed0", "9000");
            type(dialog, "presetChipLoad0", "0.1");
            type(dialog, "presetFeed0", "777"); // replaces the feed per tooth
            QCOMPARE(in<QuantityField>(dialog, "presetChipLoad0").value(), 0.0);
            type(dialog, "presetPlunge0", "111");
            type(dialog, "presetStepDown0", "99"); // deeper than the tool can cut: refused in the field
            QCOMPARE(in<QuantityField>(dialog, "presetStepDown0").value(), 0.0);
            type(dialog, "presetStepDown0", "1.5");
            click(dialog, "addPresetButton"); // a second one, which is deleted again
            QTest::keyClicks(&in<QLineEdit>(dialog, "presetName1"), "Other");
            area.ensureWidgetVisible(&in<QWidget>(dialog, "removePreset1"));
            driver.shoot("tool-libraries-01-presets");
            QCOMPARE(cutTexts(dialog).join("\n"), QString());
            click(dialog, "raisePreset1");
            QCOMPARE(in<QLineEdit>(dialog, "presetName0").text(), QString("Other"));
            click(dialog, "removePreset0");
            QCOMPARE(in<QLineEdit>(dialog, "presetName0").text(), QString("Roughing"));
            QTest::keyClick(&dialog, Qt::Key_S, Qt::ControlModifier);
            QTRY_VERIFY2(!in<QPushButton>(dialog, "saveToolButton").isEnabled(),
                         qPrintable(in<Notice>(dialog, "toolNotice").sentence()));
            QTest::keyClick(&dialog, Qt::Key_Return, Qt::ControlModifier);
            QTRY_VERIFY(!in<QPushButton>(dialog, "useToolButton").isEnabled());
            click(dialog, "closeToolsButton");
        });
        openTools(driver);
        const Tool& own = workbench.tool.current();
        QCOMPARE(own.presets.size(), std::size_t{1});
        QCOMPARE(own.presets[0].material, material.toStdString());
        QCOMPARE(own.presets[0].stepDown, 1.5);
        QVERIFY(driver.settle());
        QCOMPARE(numberOf(*driver.visible<ValueRow>("feed")), QString("777"));
        QCOMPARE(numberOf(*driver.visible<ValueRow>("plungeFeed")), QString("111"));
        QCOMPARE(numberOf(*driver.visible<ValueRow>("spindleSpeed")), QString("9000"));
        QVERIFY(driver.visible<Notice>("conditionsNotice")->sentence().contains("Roughing"));
        driver.shoot("tool-libraries-02-in-the-panel");
        // The milling context has the same values, from which paths and passes take theirs.
        QVERIFY(driver.waitFor(
            [&] { return workbench.workpiece.ready() && workbench.workpiece.milling()->conditions.feed == 777.0; }));
        QCOMPARE(workbench.workpiece.milling()->conditions.spindleSpeed, 9000.0);
        driver.key(Qt::Key_Z, Qt::ControlModifier); // loaded
        QTRY_COMPARE(driver.visible<ValueRow>("feed")->value(), byMaterial);
        driver.key(Qt::Key_Z, Qt::ControlModifier); // saved
        QVERIFY(toolIn(workbench.tool, "ball-6-copy")->presets.empty());
    }

    /// Libraries are added, renamed and deleted; tools move and are copied between them; undo reverts each step.
    void toolsAreSortedIntoLibraries() {
        WindowDriver driver(QSize(1280, 800));
        ToolController& tools = driver.window().workbench().tool;
        const std::size_t before = tools.library().size();
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            auto& list = in<RowList>(dialog, "toolList");
            QVERIFY(!in<QToolButton>(dialog, "renameLibraryButton").isEnabled());
            QTest::keyClick(&dialog, Qt::Key_M, Qt::ControlModifier);
            QTRY_VERIFY(dialog.findChild<QMenu*>("toolLibraryMenu") != nullptr);
            QTest::keyClick(&in<QMenu>(dialog, "toolLibraryMenu"), Qt::Key_Escape);
            QTRY_VERIFY(dialog.findChild<QMenu*>("toolLibraryMenu") == nullptr);
            nameNext(driver, "all"); // reserved
            click(dialog, "addLibraryButton");
            QTRY_VERIFY(in<Notice>(dialog, "toolNotice").sentence().contains("all"));
            nameNext(driver, "Wood & foam");
            click(dialog, "addLibraryButton");
            QTRY_COMPARE(in<ChoiceBox>(dialog, "toolLibrary").currentText(), QString("Wood & foam"));
            QCOMPARE(list.count(), 0);
            QVERIFY(in<Notice>(dialog, "toolNotice").sentence().contains("empty"));
            // A copy of a shipped tool.
            choose(dialog, "toolLibrary", "starter");
            QCOMPARE(static_cast<std::size_t>(list.count()), before);
            click(dialog, "placeToolButton");
            driver.shoot("tool-libraries-03-menu");
            pickEntry(dialog, "copyTool1");
            QTRY_COMPARE(in<ChoiceBox>(dialog, "toolLibrary").currentText(), QString("Wood & foam"));
            QCOMPARE(list.count(), 1);
            driver.shoot("tool-libraries-04-copied");
            // From there to the user's own.
            click(dialog, "placeToolButton");
            pickEntry(dialog, "moveTool0");
            QTRY_COMPARE(in<ChoiceBox>(dialog, "toolLibrary").currentData().toString(), QString("mine"));
            QCOMPARE(list.count(), 1);
            choose(dialog, "toolLibrary", "Wood & foam");
            QCOMPARE(list.count(), 0);
            nameNext(driver, "Foam");
            click(dialog, "renameLibraryButton");
            QTRY_COMPARE(in<ChoiceBox>(dialog, "toolLibrary").currentText(), QString("Foam"));
            QCOMPARE(cutTexts(dialog).join("\n"), QString());
            click(dialog, "closeToolsButton");
        });
        openTools(driver);
        const std::string copy = "ball-6-copy";
        QCOMPARE(tools.libraries().names, std::vector<std::string>{"Foam"});
        QCOMPARE(tools.libraries().libraryOf(copy), std::string("mine"));
        const auto undo = [&] { driver.key(Qt::Key_Z, Qt::ControlModifier); };
        undo(); // the new name
        QCOMPARE(tools.libraries().names, std::vector<std::string>{"Wood & foam"});
        undo(); // the move
        QCOMPARE(tools.libraries().libraryOf(copy), std::string("Wood & foam"));
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            choose(dialog, "toolLibrary", "Wood & foam");
            driver.whenDialogStands([&](QWidget& question) {
                driver.shoot("tool-libraries-05-question");
                QVERIFY(answer(question, "confirmButton"));
            });
            click(dialog, "deleteLibraryButton");
            QTRY_COMPARE(in<ChoiceBox>(dialog, "toolLibrary").currentData().toString(), QString("all"));
            click(dialog, "closeToolsButton");
        });
        openTools(driver);
        QVERIFY(tools.libraries().names.empty() && toolIn(tools, copy) == nullptr);
        undo(); // both come back
        QCOMPARE(tools.libraries().libraryOf(copy), std::string("Wood & foam"));
        QVERIFY(toolIn(tools, copy) != nullptr);
        undo(); // the copy
        undo(); // the library
        QCOMPARE(tools.library().size(), before);
        QVERIFY(tools.libraries().names.empty());
    }

    /// The tools of a file become a library that is called as the file; it is exported to FreeCAD and comes back.
    void aFileBecomesALibrary() {
        WindowDriver driver(QSize(1280, 800));
        ToolController& tools = driver.window().workbench().tool;
        const QString file = driver.folder().filePath("again.fctl");
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            auto& library = in<ChoiceBox>(dialog, "toolLibrary");
            chooseFile(driver, QStringLiteral(BURIN_FIXTURES "/tools/fusion.tools"));
            click(dialog, "addToolButton");
            QCOMPARE(library.currentText(), QString("fusion"));
            QCOMPARE(in<RowList>(dialog, "toolList").count(), 6);
            QVERIFY(in<Notice>(dialog, "toolNotice").sentence().contains("fusion"));
            driver.whenDialogStands([&](QWidget& asking) {
                auto* const field = asking.findChild<QLineEdit*>("fileNameEdit");
                field->setText(file);
                QTest::keyClick(field, Qt::Key_Return);
            });
            click(dialog, "exportToolButton");
            const QString told = in<Notice>(dialog, "toolNotice").sentence();
            QVERIFY2(QFile::exists(file) && told.contains("taper-3-deg"), qPrintable(told));
            driver.shoot("tool-libraries-06-exported");
            chooseFile(driver, file);
            click(dialog, "addToolButton");
            QCOMPARE(library.currentText(), QString("again"));
            QCOMPARE(in<RowList>(dialog, "toolList").count(), 5);
            click(dialog, "closeToolsButton");
        });
        openTools(driver);
        QCOMPARE(tools.libraries().names, (std::vector<std::string>{"again", "fusion"}));
        const Tool* const ball = toolIn(tools, "ball-3-mm-long");
        const Tool* const again = toolIn(tools, "ball-3-mm-long-2");
        QVERIFY(ball && again && again->cutter.diameter == 3.0 && again->number == ball->number);
        QCOMPARE(ball->presets.size(), std::size_t{1});
        QCOMPARE(again->presets.size(), std::size_t{1});
        QVERIFY(std::abs(feedOf(again->presets[0], 2) - 600.0) < 1e-6);
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(tools.libraries().names, std::vector<std::string>{"fusion"});
        QVERIFY(toolIn(tools, "ball-3-mm-long-2") == nullptr);
    }
};

BURIN_TEST(TestWindowToolLibraries, QApplication)

} // namespace burin::tst_window_tool_libraries

#include "tst_window_tool_libraries.moc"
