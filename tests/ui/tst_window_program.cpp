// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/machine_library.h"
#include "core/nc/parser.h"
#include "core/nc/program_lines.h"
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/notice.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/row_list.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QTextBlock>
#include <QtTest>

#include <algorithm>

namespace burin::tst_window_program {

using namespace burin::testing;

namespace {

bool mill(WindowDriver& driver) {
    return makeReady(driver) && recordLine(driver, {-15, 0}, {15, 0});
}

bool post(WindowDriver& driver) {
    Workbench& workbench = driver.window().workbench();
    if (!driver.step(JobStep::path)) return false;
    if (!workbench.path.stored() && !driver.clickOn("newPathButton")) return false;
    if (workbench.path.stored() && workbench.path.outdated() && !driver.clickOn("updatePathButton")) return false;
    if (!driver.waitFor(
            [&] { return workbench.path.evaluated() && !workbench.path.outdated() && !workbench.path.busy(); }))
        return false;
    return postProgram(driver);
}

/// The text of a posted program, ready to be edited; null if that fails.
QPlainTextEdit* textToEdit(WindowDriver& driver) {
    if (!mill(driver) || !post(driver) || !driver.clickOn("editTextButton")) return nullptr;
    auto* text = driver.visible<QPlainTextEdit>("programText");
    if (text != nullptr) text->setFocus();
    return text;
}

/// The longest cutting move at one height: a line, or an arc where the pointer swayed by a pixel.
const NcMotion* longestCut(const ParsedProgram& program) {
    const NcMotion* longest = nullptr;
    for (const NcMotion& motion : program.motions)
        if (const bool cuts = motion.kind == NcMotionKind::line || motion.kind == NcMotionKind::arc;
            cuts && motion.from[Axis::z] == motion.to[Axis::z] &&
            (longest == nullptr || glm::distance(motion.from.linear(), motion.to.linear()) >
                                       glm::distance(longest->from.linear(), longest->to.linear())))
            longest = &motion;
    return longest;
}

} // namespace

class TestWindowProgram : public QObject {
    Q_OBJECT
private slots:
    void aMoveAndItsLineLeadToEachOther();
    BURIN_ONLY_IN_LONG_RUNS void textThatWasNotCheckedSurvivesAnEndFromOutside();
    BURIN_ONLY_IN_LONG_RUNS void textThatTheCheckRefusedSurvives();
    BURIN_ONLY_IN_LONG_RUNS void whatIsTypedWhileItIsCheckedStays();
    BURIN_ONLY_IN_LONG_RUNS void aNewTextToolAndValuesStandOnOneLine();
    BURIN_ONLY_IN_LONG_RUNS void theTextOpensNextToTheView();
    void findingsStandBesideTheText();
    BURIN_ONLY_IN_LONG_RUNS void theRestIsExportedFromTheSelectedLine();
    BURIN_ONLY_IN_LONG_RUNS void aRefusedRestIsExportedWithAReason();
    BURIN_ONLY_IN_LONG_RUNS void aMachineIsCopiedChangedUsedAndDeleted();
    BURIN_ONLY_IN_LONG_RUNS void aMachineThatIsGoneHasAStandIn();
    BURIN_ONLY_IN_LONG_RUNS void aPostOutlastsAChangeOfTheMachine();
    BURIN_ONLY_IN_LONG_RUNS void aCheckOutlastsAChangeOfTheMachine();
    void lettersInTheTextAreNoShortcuts_data();
    BURIN_ONLY_IN_LONG_RUNS void lettersInTheTextAreNoShortcuts();
};

/// After a broken tool: the shortcut of the action, a file name, and the file resumes with the cut of that line.
void TestWindowProgram::theRestIsExportedFromTheSelectedLine() {
    WindowDriver driver;
    QVERIFY(!menuAction(driver, "restartAction")->isEnabled());
    QVERIFY(mill(driver) && post(driver));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return driver.visible("programText") != nullptr; }));
    auto* text = driver.visible<QPlainTextEdit>("programText");
    const std::string whole = workbench.program.program()->text;
    const NcMotion* longest = longestCut(workbench.program.program()->parsed);
    QVERIFY(longest != nullptr);
    const NcMotion cut = *longest;
    text->setTextCursor(QTextCursor(text->document()->findBlockByNumber(static_cast<int>(cut.line) - 1)));
    text->setFocus();
    const QString file = driver.folder().filePath("rest.ngc");
    // The effect is shown before the file is written; Esc writes nothing.
    QString facts, shown;
    bool writable = false;
    driver.whenDialogStands([&](QWidget& dialog) {
        facts = dialog.findChild<QLabel*>("restartFacts")->text();
        shown = dialog.findChild<QPlainTextEdit*>("restartText")->toPlainText();
        writable = dialog.findChild<QPushButton*>("exportRestartButton")->isEnabled();
        driver.shoot("47-restart");
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    driver.key(Qt::Key_F8);
    QVERIFY(driver.waitFor([&] { return !facts.isEmpty() && QApplication::activeModalWidget() == nullptr; }));
    QVERIFY(writable && shown.contains(QString("RESTART at line %1").arg(cut.line)));
    QVERIFY2(facts.contains(QString("line %1 ").arg(cut.line)), qPrintable(facts));
    QVERIFY2(facts.contains(QString("Tool %1").arg(cut.tool)), qPrintable(facts));
    QVERIFY(!QFile::exists(file));

    const auto exportRest = [&](const QString& to) {
        driver.whenDialogStands([&driver, to](QWidget& dialog) {
            chooseFile(driver, to);
            QTest::keyClick(&dialog, Qt::Key_Return);
        });
        driver.key(Qt::Key_F8);
    };
    exportRest(file);
    QVERIFY(driver.waitFor([&] { return driver.message().contains("rest.ngc"); }));
    QVERIFY2(driver.message().contains(QString::number(cut.line)), qPrintable(driver.message()));
    driver.shoot("47-rest-of-the-program");
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const Result<ParsedProgram> rest = parseProgram(written.readAll().toStdString(), "rest.ngc");
    QVERIFY(rest);
    const NcMotion* again = longestCut(*rest);
    QVERIFY(again != nullptr && again->to == cut.to && again->feed == cut.feed);
    QVERIFY(again->tool == cut.tool && again->spindleSpeed == cut.spindleSpeed);
    QVERIFY(workbench.program.program()->text == whole); // the program of the project is unchanged
    QVERIFY(workbench.program.exportable());

    // A file of the project cannot be overwritten.
    const QString project = driver.folder().filePath("kept.burin");
    QVERIFY(saveAs(driver, project));
    text->setFocus();
    exportRest(project + "-wal");
    QVERIFY(driver.waitFor([&] { return driver.message().contains("a file other than"); }));
    QVERIFY(!QFile::exists(project + "-wal"));

    // After the last cut there is nothing to restart, which one sentence says.
    text->setTextCursor(QTextCursor(text->document()->findBlockByNumber(text->document()->blockCount() - 2)));
    driver.key(Qt::Key_F8);
    QVERIFY(driver.waitFor([&] { return driver.message().contains("the line of the last cut"); }));
}

/// With a reason, like a refused program, and only then: the rest, in which a later line goes through the part.
void TestWindowProgram::aRefusedRestIsExportedWithAReason() {
    WindowDriver driver;
    QPlainTextEdit* text = textToEdit(driver);
    QVERIFY(text != nullptr);
    Workbench& workbench = driver.window().workbench();
    const NcMotion* longest = longestCut(workbench.program.program()->parsed);
    QVERIFY(longest != nullptr);
    const NcMotion cut = *longest;
    const auto line = [&](std::uint32_t number) {
        return QTextCursor(text->document()->findBlockByNumber(static_cast<int>(number) - 1));
    };
    // Inserted where the next line states its own motion word: between arcs, the line after a G1 could not be read.
    const auto& motions = workbench.program.program()->parsed.motions;
    const auto leaves = std::find_if(motions.begin(), motions.end(),
                                     [&](const NcMotion& motion) { return motion.rapid() && motion.line > cut.line; });
    QVERIFY(leaves != motions.end());
    text->setTextCursor(line(leaves->line));
    QTest::keyClicks(text, "G1 Z-50 F100");
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(driver.waitFor([&] { return workbench.program.edited() && driver.visible("checkTextButton") != nullptr; }));
    QVERIFY(driver.clickOn("checkTextButton"));
    QVERIFY(driver.settle());
    QVERIFY(driver.waitFor([&] { return workbench.program.refused(); }));

    const QString file = driver.folder().filePath("rest.ngc");
    bool locked = false, asked = false;
    const auto openDialog = [&](const QString& reason) {
        driver.whenDialogStands([&, reason](QWidget& dialog) {
            locked = !dialog.findChild<QPushButton*>("exportRestartButton")->isEnabled();
            driver.shoot("48-refused-restart");
            driver.whenDialogStands([&, reason](QWidget& question) {
                asked = question.objectName() == "reasonDialog";
                QTest::keyClicks(question.findChild<QLineEdit*>("reasonField"), reason);
                if (reason.isEmpty()) {
                    QTest::keyClick(&question, Qt::Key_Escape);
                    return;
                }
                driver.whenDialogStands([&](QWidget&) { chooseFile(driver, file); });
                QTest::keyClick(question.findChild<QLineEdit*>("reasonField"), Qt::Key_Return);
            });
            QTest::mouseClick(dialog.findChild<QPushButton*>("overrideRestartButton"), Qt::LeftButton);
            if (reason.isEmpty()) QTest::keyClick(&dialog, Qt::Key_Escape);
        });
        text->setTextCursor(line(cut.line));
        text->setFocus();
        driver.key(Qt::Key_F8);
    };
    openDialog({}); // without a reason nothing is written
    QVERIFY(driver.waitFor([&] { return asked && QApplication::activeModalWidget() == nullptr; }));
    QVERIFY(locked && !QFile::exists(file));
    openDialog("the part is scrap, it shows the clamps");
    QVERIFY(driver.waitFor([&] { return driver.message().contains("rest.ngc"); }));
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QString rest = QString::fromUtf8(written.readAll());
    QVERIFY2(rest.contains("REFUSED BY THE CHECK AND EXPORTED ALL THE SAME"), qPrintable(rest.left(800)));
    QVERIFY(rest.contains("(Reason: the part is scrap, it shows the clamps)"));
    QVERIFY(rest.contains(QString("RESTART at line %1").arg(cut.line)) && rest.contains("Z-50"));
    QVERIFY(workbench.program.refused()); // the program itself stays as it is
}

/// By mouse and keys, with undo; a program keeps the verdict for the machine as it was.
void TestWindowProgram::aMachineIsCopiedChangedUsedAndDeleted() {
    WindowDriver driver;
    QVERIFY(mill(driver) && post(driver));
    Workbench& workbench = driver.window().workbench();
    const QString own = driver.folder().filePath("data/burin/machines/linuxcnc-mill-copy.json");
    QVERIFY(driver.visible<QLabel>("machineNote")->accessibleName().startsWith("Typical values"));
    bool typicalIsLocked = false, tooLittleIsRefused = false, isSaved = false;
    bool samePointIsRefused = false, homeIsLocked = false;
    driver.whenDialogStands([&](QWidget& dialog) {
        const auto field = [&](const char* name) { return dialog.findChild<QuantityField*>(name); };
        const auto enter = [&](const char* name, const char* value) {
            QTest::mouseClick(field(name), Qt::LeftButton);
            field(name)->selectAll();
            QTest::keyClicks(field(name), value);
            QTest::keyClick(field(name), Qt::Key_Return);
        };
        QApplication::setActiveWindow(&dialog); // its keys hold, as under a window manager
        typicalIsLocked = field("maximum_feed_mm_per_min")->isReadOnly() &&
                          !dialog.findChild<QPushButton*>("deleteMachineButton")->isEnabled();
        QTest::keyClick(&dialog, Qt::Key_D, Qt::ControlModifier); // copies, and its name is chosen then
        if (!driver.waitFor([&] { return dialog.focusWidget()->objectName() == "name"; })) return;
        QTest::keyClicks(dialog.focusWidget(), "Mill in the shop");
        enter("tool_change_height_mm", "400"); // more than the travel of Z
        QTest::keyClick(&dialog, Qt::Key_S, Qt::ControlModifier);
        const auto* notice = dialog.findChild<Notice*>("machineNotice");
        tooLittleIsRefused = driver.waitFor([&] { return notice->sentence().contains("tool_change_height_mm"); });
        enter("tool_change_height_mm", "60");
        enter("maximum_feed_mm_per_min", "3500");
        // Three points of torque in any order, one of them entered twice and one invalid; one is deleted again.
        const auto addPoint = [&](const char* speed, const char* torque) {
            enter("newTorqueSpeed", speed);
            enter("newTorqueValue", torque); // Enter adds it
            QTest::qWait(20);
        };
        addPoint("8000", "2.5");
        addPoint("12000", "1.6");
        const auto* message = dialog.findChild<QLabel*>("torqueMessage");
        addPoint("8000", "9");
        samePointIsRefused = message->isVisible() && message->text().contains("8000");
        addPoint("3000", "350 Ncm"); // the lowest speed, so it becomes the first
        answer(dialog, "removeTorque2");
        enter("torqueValue1", "2.25");
        dialog.findChild<QScrollArea*>()->ensureWidgetVisible(field("newTorqueSpeed"));
        driver.shoot("48-torque");
        // A park position.
        auto* home = dialog.findChild<QComboBox*>("home_mm");
        homeIsLocked = field("home_mm0")->isReadOnly();
        home->setFocus();
        QTest::keyClick(home, Qt::Key_Down);
        enter("home_mm0", "-10");
        enter("home_mm1", "-20.5");
        auto* source = dialog.findChild<QLineEdit*>("spindle_power_wSource");
        source->selectAll();
        QTest::keyClicks(source, "nameplate");
        isSaved = answer(dialog, "saveMachineButton");
        driver.shoot("48-machines");
        answer(dialog, "useMachineButton");
        answer(dialog, "closeMachinesButton");
    });
    QVERIFY(driver.clickOn("machinesButton"));
    QVERIFY(typicalIsLocked && tooLittleIsRefused && isSaved);
    QVERIFY(samePointIsRefused && homeIsLocked);
    QCOMPARE(workbench.target.target().machine, std::string("linuxcnc-mill-copy"));
    Result<MachineProfile> kept = loadMachine("linuxcnc-mill-copy");
    QVERIFY(kept && kept->name == "Mill in the shop" && kept->maximumFeed == 3500.0);
    QCOMPARE(kept->sources.at("spindle_power_w"), std::string("nameplate"));
    QCOMPARE(kept->spindleTorque.size(), std::size_t{2});
    QCOMPARE(kept->spindleTorque[0].speed, 3000.0);
    QCOMPARE(kept->spindleTorque[0].torque, 3.5);
    QCOMPARE(kept->spindleTorque[1].speed, 8000.0);
    QCOMPARE(kept->spindleTorque[1].torque, 2.25);
    QVERIFY(kept->home == glm::dvec3(-10.0, -20.5, 0.0));
    QVERIFY(kept->sources.contains("maximum_feed_mm_per_min")); // it is the user's own value now
    QVERIFY(
        driver.waitFor([&] { return driver.visible<QLabel>("machineNote")->accessibleName() == "Your own machine."; }));
    QVERIFY(workbench.program.outdated());

    // Undo restores the values: use, values, copy.
    for (int i = 0; i < 2; ++i) driver.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(workbench.target.target().machine, std::string("linuxcnc-mill"));
    kept = loadMachine("linuxcnc-mill-copy");
    QVERIFY(kept && kept->maximumFeed != 3500.0);
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!QFile::exists(own));
    driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(QFile::exists(own));

    driver.whenDialogStands([&](QWidget& dialog) {
        QApplication::setActiveWindow(&dialog);
        auto* list = dialog.findChild<RowList*>("machineList");
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Down); // from the machine in use to its copy
        QTest::keyClick(list, Qt::Key_Delete);
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    driver.key(Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!QFile::exists(own));
    QVERIFY(driver.settle());
}

/// One sentence says which machine is missing and which one is used instead; work goes on.
void TestWindowProgram::aMachineThatIsGoneHasAStandIn() {
    WindowDriver driver;
    QVERIFY(saveMachine(copyOf(*loadMachine("haas-mill"), "gone", "Gone"), false));
    QVERIFY(mill(driver));
    Workbench& workbench = driver.window().workbench();
    workbench.target.load({"gone", {}, NcUnits::millimetre});
    QCOMPARE(workbench.target.machine().id, std::string("gone"));
    workbench.target.deleteMachine("gone");
    QVERIFY(post(driver));
    const QString note = driver.visible<QLabel>("machineNote")->accessibleName();
    QVERIFY2(note.contains("gone") && note.contains("LinuxCNC"), qPrintable(note));
    QVERIFY(workbench.program.exportable());
    driver.shoot("49-machine-that-is-gone");
}

/// Posting that is interrupted by a change of the machine, and then of its limits, is repeated automatically, for the
/// machine that is then in force.
void TestWindowProgram::aPostOutlastsAChangeOfTheMachine() {
    WindowDriver driver;
    QVERIFY(mill(driver) && post(driver));
    Workbench& workbench = driver.window().workbench();
    const auto before = workbench.program.program();
    QVERIFY(workbench.target.machine().id != "haas-mill");
    QVERIFY(driver.clickOn("postButton") && workbench.program.busy());
    workbench.target.chooseMachine("haas-mill");
    QVERIFY(workbench.program.busy()); // without another click
    QVERIFY(driver.waitFor([&] { return !workbench.program.busy(); }));
    QVERIFY(!workbench.program.problem());
    QVERIFY(workbench.program.program() != before && workbench.program.exportable());
    QCOMPARE(workbench.program.program()->dialect, workbench.target.dialect());
    QVERIFY(driver.settle() && workbench.program.exportable());
    // The file extension is that of the control.
    QString proposed;
    driver.whenDialogStands([&](QWidget& dialog) {
        proposed = dialog.findChild<QLineEdit*>("fileNameEdit")->text();
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    QVERIFY(driver.clickOn("exportButton"));
    QVERIFY2(proposed.endsWith(".nc"), qPrintable(proposed));
    // Typing meanwhile cancels the post, as the text has changed.
    QVERIFY(driver.clickOn("postButton") && workbench.program.busy());
    workbench.target.chooseMachine("linuxcnc-mill");
    workbench.program.editText(workbench.program.storedText() + "(mine)\n");
    QVERIFY(driver.settle());
    QVERIFY(workbench.program.edited() && !workbench.program.busy());
    QVERIFY(workbench.program.storedText().endsWith("(mine)\n"));
}

void TestWindowProgram::aCheckOutlastsAChangeOfTheMachine() {
    WindowDriver driver;
    QPlainTextEdit* text = textToEdit(driver);
    QVERIFY(text != nullptr);
    Workbench& workbench = driver.window().workbench();
    QTest::keyClick(text, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClicks(text, "(mine)");
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(driver.waitFor([&] { return workbench.program.edited(); }));
    QVERIFY(driver.waitFor([&] { return driver.visible("checkTextButton") != nullptr; }));
    auto* check = driver.visible<QPushButton>("checkTextButton");
    QVERIFY(driver.waitFor([&] { return check->isEnabled(); }));
    QVERIFY(driver.clickOn("checkTextButton") && workbench.program.busy());
    const MachineProfile other = copyOf(workbench.target.machine(), "slower", "Slower");
    QVERIFY(saveMachine(other, false));
    workbench.target.chooseMachine("slower");
    QVERIFY(workbench.program.busy());
    QVERIFY(driver.waitFor([&] { return !workbench.program.busy(); }) && driver.settle());
    QVERIFY(!workbench.program.problem() && !workbench.program.edited() && workbench.program.exportable());
    QVERIFY(workbench.program.program()->text.find("(mine)") != std::string::npos);
}

/// Opened by a key, as a separate window, after a restart, and back in the panel.
void TestWindowProgram::theTextOpensNextToTheView() {
    WindowDriver driver;
    QVERIFY(mill(driver) && post(driver));
    QVERIFY(driver.waitFor([&] { return driver.visible("programText") != nullptr; }));
    auto* text = driver.visible<QPlainTextEdit>("programText");
    const QPointer<QWidget> panel = driver.visible("programPage");
    QVERIFY(panel->isAncestorOf(text));
    text->setFocus();
    driver.key(Qt::Key_F7);
    auto* dock = driver.visible<QDockWidget>("programDock");
    QVERIFY(dock != nullptr && dock->isAncestorOf(text) && !panel->isAncestorOf(text));
    QVERIFY(text->hasFocus());
    QVERIFY(driver.waitFor([&] { return text->width() > 600; }));
    QVERIFY(text->viewport()->width() >= 80 * text->fontMetrics().horizontalAdvance(QLatin1Char('0')));
    auto* viewport = driver.visible<Viewport>("viewport");
    QVERIFY(viewport->height() > dock->height()); // the view keeps the larger share
    driver.shoot("46-text-below-the-view");

    // Esc leaves the text and closes nothing; other steps give the view all the room.
    driver.key(Qt::Key_Escape);
    QVERIFY(viewport->hasFocus() && dock->isVisible());
    QVERIFY(driver.step(JobStep::path) && !dock->isVisible());
    QVERIFY(driver.step(JobStep::program) && dock->isVisible());

    QVERIFY(driver.clickOn("floatProgramDock"));
    QVERIFY(dock->isFloating());
    dock->resize(900, 500);
    QApplication::setActiveWindow(dock);
    text->setFocus();
    QTest::keyClick(text, Qt::Key_F, Qt::ControlModifier); // the shortcuts of the main window work there as well
    QVERIFY(driver.visible<QLineEdit>("programSearch")->hasFocus());
    text->setFocus();
    QTest::keyClick(text, Qt::Key_F1, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.visible("welcomePage") != nullptr && !dock->isVisible());
    driver.key(Qt::Key_F1, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(dock->isVisible());
    QVERIFY(driver.waitFor([&] { return text->hasFocus(); })); // the focus is where it was before

    QVERIFY(saveAs(driver, driver.folder().filePath("docked.burin")));
    QVERIFY(driver.restart() && driver.clickOn("recentFileButton"));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.ready() && workbench.path.evaluated(); }) &&
            driver.settle());
    QVERIFY(driver.step(JobStep::program));
    QVERIFY(driver.waitFor([&] { return driver.visible("programText") != nullptr; }));
    dock = driver.visible<QDockWidget>("programDock");
    QVERIFY(dock != nullptr && dock->isFloating() && dock->isAncestorOf(driver.visible("programText")));
    QCOMPARE(dock->size(), QSize(900, 500));

    QVERIFY(driver.clickOn("closeProgramDock"));
    QVERIFY(!dock->isVisible() && driver.visible("programPage")->isAncestorOf(driver.visible("programText")));
    QVERIFY(!menuAction(driver, "programDockAction")->isChecked());
    QVERIFY(driver.clickOn("moveTextButton"));
    QVERIFY(driver.visible("programDock") != nullptr);
}

/// In a wide dock; in the panel they are below the text.
void TestWindowProgram::findingsStandBesideTheText() {
    WindowDriver driver;
    QPlainTextEdit* text = textToEdit(driver);
    QVERIFY(text != nullptr);
    QTest::keyClick(text, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClicks(text, "G999");
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(driver.waitFor([&] { return driver.visible("findingList") != nullptr; }));
    QTest::keyClick(text, Qt::Key_End, Qt::ControlModifier);
    const auto lies = [&](const char* name) {
        return QRect(driver.visible(name)->mapTo(&driver.window(), QPoint(0, 0)), driver.visible(name)->size());
    };
    QVERIFY(lies("findingList").top() > lies("programText").bottom());
    driver.key(Qt::Key_F7);
    QVERIFY(driver.waitFor([&] { return lies("findingList").left() > lies("programText").right(); }));
    QVERIFY(lies("checkTextButton").top() > lies("findingList").bottom());
    QTest::mouseClick(driver.visible<QAbstractScrollArea>("findingList")->viewport(), Qt::LeftButton, {}, {20, 10});
    QCOMPARE(text->textCursor().blockNumber(), 0);
    driver.shoot("47-findings-beside-the-text");
    driver.key(Qt::Key_F9); // without the timeline the dock is higher than wide
    auto* docks = driver.window().findChild<QMainWindow*>("viewDocks");
    docks->addDockWidget(Qt::LeftDockWidgetArea, driver.visible<QDockWidget>("programDock"));
    QVERIFY(driver.waitFor([&] { return lies("findingList").top() > lies("programText").bottom(); }));
    driver.shoot("47-text-left-of-the-view");
}

void TestWindowProgram::lettersInTheTextAreNoShortcuts_data() {
    QTest::addColumn<bool>("docked");
    QTest::addColumn<bool>("editable");
    for (const bool docked : {false, true})
        for (const bool editable : {false, true})
            if (longRun() || docked != editable)
                QTest::addRow("%s, %s", docked ? "in the dock" : "in the panel", editable ? "editable" : "locked")
                    << docked << editable;
}

/// "G", "M", "S", "P", "I", "F", "1" and "4" are shortcuts of the view elsewhere.
void TestWindowProgram::lettersInTheTextAreNoShortcuts() {
    QFETCH(bool, docked);
    QFETCH(bool, editable);
    WindowDriver driver;
    QVERIFY(mill(driver) && post(driver));
    if (docked) driver.key(Qt::Key_F7);
    QVERIFY(!editable || driver.clickOn("editTextButton"));
    QVERIFY(driver.waitFor([&] { return driver.visible("programText") != nullptr; }));
    auto* text = driver.visible<QPlainTextEdit>("programText");
    auto* viewport = driver.visible<Viewport>("viewport");
    const QString before = text->toPlainText();
    const auto state = [&] {
        QString on;
        for (const QAction* action : driver.window().actions())
            if (action->isCheckable()) on += QLatin1Char(action->isChecked() ? '1' : '0');
        const QPointF seen = viewport->project({30, 20, 10});
        return on + QStringLiteral(" %1 %2").arg(seen.x()).arg(seen.y());
    };
    QTest::qWait(200);
    const QString shown = state();
    QTest::mouseClick(text->viewport(), Qt::LeftButton, {}, {60, 8});
    QTest::keyClick(text, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClicks(text, "g1m4spif");
    QTest::qWait(100);
    QCOMPARE(state(), shown);
    QCOMPARE(text->toPlainText(), (editable ? QStringLiteral("g1m4spif") : QString()) + before);
    QCOMPARE(driver.window().workbench().mill.active(), false);
}

/// A line is selected, the path changes and the program is posted again: the values next to the text belong to the
/// selected line.
void TestWindowProgram::aNewTextToolAndValuesStandOnOneLine() {
    WindowDriver driver;
    const ProgramController& program = driver.window().workbench().program;
    QVERIFY(mill(driver) && post(driver));
    QVERIFY(driver.waitFor([&] { return driver.visible("programText") != nullptr; }));
    const auto* text = driver.visible<QPlainTextEdit>("programText");
    auto* viewport = driver.visible<Viewport>("viewport");
    const glm::dvec3 zero = driver.window().workbench().workpiece.milling()->setup.workOffset;
    const NcMotion* cut = longestCut(program.program()->parsed);
    QVERIFY(cut != nullptr);
    QTest::mouseClick(viewport, Qt::LeftButton, {},
                      viewport->project(zero + 0.5 * (cut->from.linear() + cut->to.linear())).toPoint());
    QCOMPARE(text->textCursor().blockNumber() + 1, static_cast<int>(cut->line));
    QVERIFY(driver.visible<QLabel>("programState") != nullptr);

    QVERIFY(recordLine(driver, {-15, 8}, {15, 8}) && driver.settle() && post(driver) && driver.settle());
    QTest::qWait(300);
    const NcMotion* now =
        lastMotion(program.program()->parsed.motions, static_cast<std::uint32_t>(text->textCursor().blockNumber() + 1));
    const auto* state = driver.visible<QLabel>("programState");
    if (now == nullptr)
        QVERIFY2(state == nullptr, qPrintable(state != nullptr ? state->text() : QString()));
    else
        QVERIFY(state != nullptr && state->text().contains(QLocale().toString(now->to[Axis::x], 'f', 3)));
    driver.shoot("45-posted-anew");
}

/// Typed by keys; the window has not yet received the latest ones when the check ends.
void TestWindowProgram::whatIsTypedWhileItIsCheckedStays() {
    WindowDriver driver;
    QVERIFY(mill(driver));
    QVERIFY(post(driver));
    const ProgramController& program = driver.window().workbench().program;
    QVERIFY(driver.clickOn("editTextButton"));
    auto* text = driver.visible<QPlainTextEdit>("programText");
    QVERIFY(text != nullptr);
    text->setFocus();
    QTest::keyClick(text, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClicks(text, "(first)");
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(driver.waitFor([&] { return driver.visible("checkTextButton") != nullptr; }));

    const auto typeWhile = [&](const char* button, const QString& words) {
        if (!driver.clickOn(button) || !program.busy()) return false;
        text->setFocus();
        QTest::keyClick(text, Qt::Key_Home, Qt::ControlModifier);
        QTest::keyClicks(text, words);
        QTest::keyClick(text, Qt::Key_Return);
        return program.busy() && driver.waitFor([&] { return !program.busy(); }) && driver.settle();
    };
    QVERIFY(typeWhile("checkTextButton", "(second)"));
    QVERIFY(text->toPlainText().startsWith("(second)\n(first)\n"));
    QVERIFY(program.storedText().startsWith("(second)\n(first)\n"));
    QVERIFY(program.edited() && !program.exportable());
    QVERIFY(driver.waitFor([&] { return driver.visible("checkTextButton") != nullptr; }));
    auto* check = driver.visible<QPushButton>("checkTextButton");
    QVERIFY(driver.waitFor([&] { return check->isEnabled(); })); // the window knows that the text is not checked
    driver.shoot("33-typed-while-checked");

    // While it is posted, too.
    QVERIFY(typeWhile("postButton", "(third)"));
    QVERIFY(text->toPlainText().startsWith("(third)\n(second)\n(first)\n"));
    QVERIFY(program.edited() && !program.exportable());

    // Text typed immediately before the click on the button counts as well.
    text->setFocus();
    QTest::keyClick(text, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClicks(text, "(fourth) ");
    QVERIFY(driver.clickOn("checkTextButton"));
    QVERIFY(driver.waitFor([&] { return program.exportable(); }));
    QVERIFY(program.program()->text.starts_with("(fourth) (third)"));
    QVERIFY(text->toPlainText().startsWith("(fourth) (third)\n"));
}

/// Text written by hand is kept in the project, whatever its check says.
void TestWindowProgram::textThatTheCheckRefusedSurvives() {
    WindowDriver driver;
    QPlainTextEdit* text = textToEdit(driver);
    QVERIFY(text != nullptr);
    const int cut = int(text->toPlainText().indexOf("\nG1"));
    QVERIFY(cut > 0);
    QTextCursor cursor = text->textCursor();
    cursor.setPosition(cut + 1);
    text->setTextCursor(cursor);
    QTest::keyClicks(text, "G1 Z-50 F100"); // through the part and everything below
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(driver.waitFor([&] { return driver.window().workbench().program.edited(); }));
    QVERIFY(driver.waitFor([&] { return driver.visible("checkTextButton") != nullptr; }));
    QVERIFY(driver.clickOn("checkTextButton"));
    QVERIFY(driver.settle());
    QVERIFY(driver.waitFor([&] { return driver.window().workbench().program.refused(); }));
    const QString file = driver.folder().filePath("refused.burin");
    QVERIFY(saveAs(driver, file));
    QVERIFY(driver.restart());
    QVERIFY(driver.clickOn("recentFileButton"));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.ready() && workbench.path.evaluated(); }));
    QVERIFY(driver.settle());
    QVERIFY(workbench.program.refused() && !workbench.program.exportable()); // the result of the check is restored
    QVERIFY(workbench.program.storedText().contains("\nG1 Z-50 F100\n"));
}

void TestWindowProgram::textThatWasNotCheckedSurvivesAnEndFromOutside() {
    WindowDriver driver;
    QPlainTextEdit* text = textToEdit(driver);
    QVERIFY(text != nullptr);
    QTest::keyClick(text, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClicks(text, "(half a thought)");
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(driver.waitFor([&] { return driver.window().workbench().program.edited(); }));
    QVERIFY(driver.restart(true));
    QVERIFY(driver.clickOn("recoverButton"));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.ready() && workbench.path.evaluated(); }));
    QVERIFY(driver.settle());
    QVERIFY(workbench.program.edited() && !workbench.program.exportable());
    QVERIFY(workbench.program.storedText().startsWith("(half a thought)\n"));
    QVERIFY(driver.step(JobStep::program));
    QVERIFY(driver.waitFor([&] { return driver.visible("checkTextButton") != nullptr; }));
    QVERIFY(driver.clickOn("checkTextButton"));
    QVERIFY(driver.waitFor([&] { return workbench.program.exportable(); }));
}

void TestWindowProgram::aMoveAndItsLineLeadToEachOther() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(mill(driver));
    QVERIFY(post(driver));
    QVERIFY(workbench.program.exportable());
    QVERIFY(driver.waitFor([&] { return driver.visible("programText") != nullptr; }));
    auto* text = driver.visible<QPlainTextEdit>("programText");
    auto* viewport = driver.visible<Viewport>("viewport");
    QVERIFY(text && viewport);
    const ParsedProgram& program = workbench.program.program()->parsed;
    const glm::dvec3 zero = workbench.workpiece.milling()->setup.workOffset;

    // A click on a move in the viewport selects its line.
    const NcMotion* cut = longestCut(program);
    QVERIFY(cut != nullptr);
    QTest::mouseClick(viewport, Qt::LeftButton, {},
                      viewport->project(zero + 0.5 * (cut->from.linear() + cut->to.linear())).toPoint());
    QCOMPARE(text->textCursor().blockNumber() + 1, static_cast<int>(cut->line));
    const auto* state = driver.visible<QLabel>("programState");
    QVERIFY(state != nullptr);
    const auto told = [&](double value) { return state->text().contains(QLocale().toString(value, 'f', 3)); };
    QVERIFY2(told(cut->to[Axis::x]) && told(cut->to[Axis::z]) && state->text().contains("spindle "),
             qPrintable(state->text()));
    driver.shoot("20-move-and-line");
    // And back: the cursor keys step through the moves, with the tool at their ends.
    text->setFocus();
    QTest::keyClick(text, Qt::Key_Down);
    const NcMotion* next = lastMotion(program.motions, cut->line + 1);
    QVERIFY(next != nullptr && next->to != cut->to);
    QVERIFY2(told(next->to[Axis::x]), qPrintable(state->text()));
    // A click that hits no move is left to the camera.
    const int line = text->textCursor().blockNumber();
    QTest::mouseClick(viewport, Qt::LeftButton, {}, QPoint(40, viewport->height() - 80));
    QCOMPARE(text->textCursor().blockNumber(), line);

    // Searching.
    driver.key(Qt::Key_F, Qt::ControlModifier);
    auto* search = driver.visible<QLineEdit>("programSearch");
    QVERIFY(search != nullptr && search->hasFocus());
    QTest::keyClicks(search, "m3");
    QTest::keyClick(search, Qt::Key_Return);
    QVERIFY(text->textCursor().block().text().contains("M3"));
    QCOMPARE(text->textCursor().selectedText(), QString("M3"));
    QTest::keyClicks(search, "nowhere");
    QCOMPARE(driver.visible<QLabel>("searchFound")->text(), QString("none"));
    search->clear();

    // The deviation map on the bare part, with the value under the pointer.
    auto* page8 = driver.visible<QScrollArea>("programPage");
    QVERIFY(page8 != nullptr);
    auto* deviation = driver.visible<QCheckBox>("deviationSwitch");
    QVERIFY(deviation != nullptr);
    page8->ensureWidgetVisible(deviation);
    QTest::mouseClick(deviation, Qt::LeftButton, {}, {10, 10});
    QVERIFY(driver.waitFor([&] { return deviation->isChecked(); }));
    QTest::qWait(200);
    const Box part = workbench.model.model()->box();
    QTest::mouseMove(viewport, viewport->project({part.centre().x, part.centre().y, part.high.z}).toPoint());
    QVERIFY(driver.waitFor(
        [&] { return driver.visible<QLabel>("deviationUnderPointer")->text().contains(QStringLiteral("left")); }));
    // The legend is visible, below the last element of the page's former content.
    auto* legend = driver.visible<QWidget>("deviationLegend");
    QVERIFY(legend != nullptr);
    QVERIFY(
        QTest::qWaitFor([&] { return legend->visibleRegion().boundingRect().height() == legend->height(); }, 30000));
    driver.shoot("20-deviation");
    QTest::mouseClick(deviation, Qt::LeftButton, {}, {10, 10});

    // The text is edited: what the control would reject is marked at once, and the edit is checked like a posted text.
    const QString posted = text->toPlainText();
    QVERIFY(driver.clickOn("editTextButton"));
    text->setFocus();
    QTest::keyClick(text, Qt::Key_End, Qt::ControlModifier);
    QTest::keyClick(text, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClicks(text, "G999");
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(driver.waitFor([&] { return workbench.program.edited(); }));
    QVERIFY(!workbench.program.lint().empty() && workbench.program.lint().front().line == 1);
    QVERIFY(!workbench.program.exportable());
    driver.shoot("20-lint");
    while (text->toPlainText() != posted)
        QTest::keyClick(text, Qt::Key_Z, Qt::ControlModifier); // the editor's own undo
    QTest::keyClick(text, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClicks(text, "(a word of mine)");
    QTest::keyClick(text, Qt::Key_Return);
    QVERIFY(driver.waitFor([&] { return driver.visible("checkTextButton") != nullptr; }));
    page8->ensureWidgetVisible(driver.visible("checkTextButton"));
    QCoreApplication::processEvents();
    QVERIFY(driver.waitFor([&] { return workbench.program.lint().empty(); }));
    QVERIFY(driver.clickOn("checkTextButton"));
    QVERIFY(driver.settle());
    QVERIFY(driver.waitFor([&] { return workbench.program.exportable(); }));
    QVERIFY(workbench.program.program()->text.find("(a word of mine)") != std::string::npos);
    QVERIFY(driver.clickOn("editTextButton"));

    // A clamp across the groove: the program is refused until a reason is given.
    QVERIFY(driver.step(JobStep::stock));
    auto* page = driver.visible<QScrollArea>("stockPage");
    page->ensureWidgetVisible(driver.window().findChild<QWidget*>("addObstacleButton"));
    QVERIFY(driver.clickOn("addObstacleButton"));
    QVERIFY(driver.waitFor([&] { return workbench.surroundings.obstacles().size() == 1; }));
    for (const auto& [field, value] :
         {std::pair{"obstacle0PlaceX", "5"}, {"obstacle0PlaceZ", "-1"}, {"obstacle0SizeZ", "8"}})
        QVERIFY2(driver.enter(field, value), field);
    QVERIFY(driver.waitFor([&] { return boundAlike(workbench.workpiece.bound(), workbench.surroundings.wanted()); }));
    QVERIFY(driver.settle());
    QVERIFY(post(driver));
    QVERIFY(workbench.program.refused() && !workbench.program.exportable());
    driver.shoot("21-refused");
    driver.whenDialogStands([](QWidget& dialog) {
        auto* reason = dialog.findChild<QLineEdit*>("reasonField");
        auto* yes = dialog.findChild<QPushButton*>("confirmButton");
        QVERIFY(reason && yes && !yes->isEnabled());
        QTest::keyClicks(reason, "the clamp is moved by hand");
        dialog.grab();
        QVERIFY(answer(dialog, "confirmButton"));
    });
    QVERIFY(driver.clickOn("overrideButton"));
    QVERIFY(driver.settle());
    QVERIFY(workbench.program.exportable());
    QVERIFY(driver.waitFor([&] { return text->toPlainText().contains("(Reason: the clamp is moved by hand)"); }));
    driver.shoot("22-wanted-all-the-same");
    // A reason does not turn a failed check into a passed one.
    const QString spoken = driver.visible<QWidget>("stepProgram")->accessibleDescription();
    QVERIFY2(spoken.startsWith("has a problem"), qPrintable(spoken));
}

BURIN_TEST(TestWindowProgram, QApplication)

} // namespace burin::tst_window_program

#include "tst_window_program.moc"
