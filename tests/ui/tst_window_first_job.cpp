// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The first job, done by following only what the coach points at.
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/visible_texts.h"
#include "tests/ui/window_steps.h"
#include "ui/coach/target_outline.h"
#include "ui/messages/messages.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTimer>
#include <QtTest>

#include <vector>

namespace burin::tst_window_first_job {

using namespace burin::testing;

namespace {

enum Step : std::size_t { part, voxel, embed, tool, mill, stroke, stop, path, edit, post, exporting, all };

CoachPanel& panelOf(WindowDriver& driver) {
    return *driver.window().findChild<CoachPanel*>("coachPanel");
}

/// Returns the visible outline, over the window or over an open menu; null if the coach points at nothing.
TargetOutline* outline() {
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* found = qobject_cast<TargetOutline*>(widget); found != nullptr && found->isVisible()) return found;
    return nullptr;
}

QString noteOf(WindowDriver& driver) {
    return driver.window().findChild<QLabel*>("coachNote")->text().remove(QChar(0x200B));
}

QString nameOf(const Pointed& pointed) {
    return pointed.widget ? pointed.widget->objectName() : QString();
}

/// Presses one after the other the widgets that the coach points at, like a user who does not know Burin.
class Follower : public QObject {
public:
    explicit Follower(WindowDriver& driver) : driver_(driver) { goOn(); }
    bool reach(std::size_t step) {
        until_ = step;
        const bool reached = driver_.waitFor([&] { return coach().job().at() >= step; }, 60000);
        until_ = 0;
        return reached;
    }
    QStringList faults;  ///< faults found on the way
    int menuEntries = 0; ///< number of entries pressed in menus

private:
    const Coach& coach() const { return driver_.window().coach(); }
    void goOn() { // a new timer each time: an open menu blocks the call that opened it
        QTimer::singleShot(50, this, [this] {
            goOn();
            act();
        });
    }
    void act() {
        const Pointed pointed = coach().pointed();
        if (coach().job().at() >= until_ || !pointed.widget || !pointed.widget->isEnabled()) return;
        const std::pair now{coach().job().at(), pointed.rectIn(driver_.window())};
        if (now == acted_ && since_.elapsed() < 4000) return; // the last press may still take effect
        if (now != seen_) {                                   // wait until panels and images stop moving
            seen_ = now;
            return;
        }
        acted_ = now;
        since_.start();
        look(pointed);
        press(pointed);
    }
    /// Checks that the frame surrounds the target, and that the panel does not cover it unless it is the view.
    void look(const Pointed& pointed) {
        QWidget& over = *pointed.widget->window();
        const TargetOutline* frame = outline();
        if (frame == nullptr || frame->window() != &over || !frame->geometry().contains(pointed.rectIn(over)))
            faults << "no frame around " + nameOf(pointed);
        const bool view = pointed.widget == &driver_.window().viewport();
        if (!view && panelOf(driver_).geometry().intersects(pointed.rectIn(driver_.window())))
            faults << "the panel covers " + nameOf(pointed);
    }
    void press(const Pointed& pointed) {
        const QPoint middle = pointed.rect.center();
        if (qobject_cast<QAbstractSpinBox*>(pointed.widget)) {
            driver_.enter(pointed.widget->objectName().toUtf8(), "1");
        } else if (pointed.widget == &driver_.window().viewport()) {
            drag(middle);
        } else {
            menuEntries += qobject_cast<QMenu*>(pointed.widget) != nullptr ? 1 : 0;
            QTest::mouseClick(pointed.widget, Qt::LeftButton, Qt::NoModifier, middle);
        }
    }
    void drag(const QPoint& middle) {
        Viewport& view = driver_.window().viewport();
        const auto at = [&](int i) { return middle + QPoint(3 * (i - 10), 0); };
        QTest::mouseMove(&view, at(0));
        QTest::qWait(300);
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, at(0));
        for (int i = 0; i <= 20; ++i) {
            QTest::mouseMove(&view, at(i));
            QTest::qWait(20);
        }
        QTest::qWait(400);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, at(20));
    }

    WindowDriver& driver_;
    std::size_t until_ = 0;
    std::pair<std::size_t, QRect> acted_, seen_;
    QElapsedTimer since_;
};

bool begin(WindowDriver& driver) {
    driver.key(Qt::Key_J, Qt::ControlModifier | Qt::AltModifier);
    return driver.waitFor([&] { return driver.window().coach().running() && outline() != nullptr; });
}

} // namespace

class TestWindowFirstJob : public QObject {
    Q_OBJECT
private slots:
    void whoFollowsItGetsToAProgram();
    BURIN_ONLY_IN_LONG_RUNS void whatIsDoneAnotherWayCounts();
    void itSaysWhereToReturn();
    BURIN_ONLY_IN_LONG_RUNS void itAsksAboutUnsavedWork();
    void itIsWorkedByKeys();
    void textsFit_data();
    void textsFit();
};

void TestWindowFirstJob::whoFollowsItGetsToAProgram() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    const Coach& coach = driver.window().coach();
    auto* offer = driver.visible<QPushButton>("firstJobButton");
    QVERIFY(offer && offer->property("look").toString() == "primary");
    QVERIFY(driver.clickOn("firstJobButton"));
    QVERIFY(driver.waitFor([&] { return nameOf(coach.pointed()) == "samplePartButton"; }));
    QVERIFY(!workbench.document.isOpen()); // the coach does nothing by itself
    driver.shoot("first-job-1");
    Follower follower(driver);
    QVERIFY(follower.reach(voxel));
    QVERIFY(driver.waitFor([&] { return nameOf(coach.pointed()) == "voxelField"; }));
    driver.shoot("first-job-2");
    QVERIFY(follower.reach(embed));
    QCOMPARE(workbench.setup.setup().voxel, 1.0);
    QVERIFY(!workbench.workpiece.embedded());
    for (const QSize& size : {QSize(1024, 680), QSize(1400, 900)}) { // the frame follows the target
        driver.window().resize(size);
        QVERIFY(driver.waitFor([&] { return driver.window().size() == size; }));
        QTest::qWait(100);
        const auto* button = driver.visible<QPushButton>("embedButton");
        const QRect meant(button->mapTo(&driver.window(), QPoint(0, 0)), button->size());
        QVERIFY(outline() && outline()->geometry().contains(meant));
        QVERIFY(outline()->geometry().width() <= meant.width() + 20);
        QVERIFY(driver.window().rect().contains(panelOf(driver).geometry()));
        driver.shoot(QStringLiteral("first-job-3-%1").arg(size.width()));
    }
    QVERIFY(follower.reach(tool));
    QVERIFY(workbench.workpiece.embedded());
    QVERIFY(driver.waitFor([&] { return nameOf(coach.pointed()) == "stepTool"; }));
    driver.shoot("first-job-4-way");
    QVERIFY(follower.reach(mill));
    QCOMPARE(workbench.tool.current().id, std::string("ball-10"));
    driver.shoot("first-job-5");
    QVERIFY(follower.reach(stroke));
    QVERIFY(workbench.mill.active());
    QTest::qWait(300);
    driver.shoot("first-job-6");
    QVERIFY(follower.reach(stop));
    QVERIFY(follower.reach(path));
    QCOMPARE(workbench.mill.takes().size(), std::size_t{1});
    QVERIFY(follower.reach(edit));
    QVERIFY(workbench.path.evaluated() != nullptr);
    const std::size_t edits = workbench.path.stored()->edits.size();
    QVERIFY(driver.waitFor([&] { return nameOf(coach.pointed()) == "addEditButton"; }));
    driver.shoot("first-job-9");
    QVERIFY(follower.reach(post));
    QCOMPARE(workbench.path.stored()->edits.size(), edits + 1);
    QCOMPARE(follower.menuEntries, 2); // a group and the edit
    QVERIFY(follower.reach(exporting));
    QVERIFY(workbench.program.exportable());
    QVERIFY(driver.waitFor([&] { return nameOf(coach.pointed()) == "exportButton"; }));
    driver.shoot("first-job-11");
    QVERIFY(!UserSettings().firstJobFinished());
    const QString program = driver.folder().filePath("first.ngc");
    chooseFile(driver, program);
    QVERIFY(follower.reach(all));
    QVERIFY(QFile::exists(program));
    QVERIFY2(follower.faults.isEmpty(), qPrintable(follower.faults.join('\n')));
    QTRY_VERIFY(outline() == nullptr);
    driver.shoot("first-job-done");
    QVERIFY(driver.clickOn("coachEndButton"));
    QVERIFY(!coach.running() && !panelOf(driver).isVisible());
    // From now on the first job is no longer the primary action of the welcome page.
    QVERIFY(driver.restart(true));
    offer = driver.visible<QPushButton>("firstJobButton");
    QVERIFY(offer && offer->property("look").toString().isEmpty());
}

/// Steps also count if done by keys or with the user's own file; a step that is undone is asked for again.
void TestWindowFirstJob::whatIsDoneAnotherWayCounts() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    const Coach& coach = driver.window().coach();
    const auto at = [&](std::size_t step) { return driver.waitFor([&] { return coach.job().at() == step; }); };
    QVERIFY(begin(driver));
    drop(driver.window(), writeBlock(driver));
    QVERIFY(at(voxel));
    QVERIFY(driver.waitFor([&] { return driver.visible("embedButton") != nullptr; }));
    driver.key(Qt::Key_B, Qt::ControlModifier); // with the present voxel: choosing it is optional
    QVERIFY(at(tool));
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.ready(); }) && driver.settle());
    driver.key(Qt::Key_M); // with the tool that is in the spindle
    QVERIFY(at(stroke));
    driver.key(Qt::Key_M); // stops without a stroke
    QVERIFY(at(mill));
    QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));
    QTest::qWait(300); // panels follow
    QVERIFY(recordLine(driver, {-15, 0}, {15, 0}));
    QVERIFY(at(path));
    bool asked = false; // a dialog on top changes nothing
    driver.whenDialogStands([&](QWidget& dialog) { asked = answer(dialog, "cancelButton"); });
    driver.key(Qt::Key_N, Qt::ControlModifier);
    QVERIFY(asked && coach.running() && panelOf(driver).isVisible());
    QCOMPARE(coach.job().at(), std::size_t{path});
}

void TestWindowFirstJob::itSaysWhereToReturn() {
    WindowDriver driver;
    const Coach& coach = driver.window().coach();
    const auto points = [&](const char* name) {
        return driver.waitFor([&] { return nameOf(coach.pointed()) == name && outline() != nullptr; });
    };
    QVERIFY(begin(driver));
    drop(driver.window(), writeBlock(driver));
    QVERIFY(driver.waitFor([&] { return coach.job().at() == voxel; }));
    QVERIFY(points("voxelField"));
    QVERIFY(noteOf(driver).isEmpty());
    QVERIFY(driver.step(JobStep::program));
    QVERIFY(points("stepStock"));
    QTRY_COMPARE(noteOf(driver), QString("Click “Stock” at the top of the window."));
    driver.key(Qt::Key_F1, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(points("backButton"));
    QTRY_COMPARE(noteOf(driver), QString("Return to the project."));
    QVERIFY(driver.clickOn("backButton") && driver.clickOn("stepStock"));
    QVERIFY(points("voxelField"));
    // Back shows a completed step, which does not end at once because it is completed; Next continues.
    QVERIFY(driver.clickOn("coachBackButton"));
    QCOMPARE(coach.job().at(), std::size_t{part});
    QTRY_COMPARE(driver.visible<QPushButton>("coachSkipButton")->text(), QString("Next"));
    QTest::qWait(300);
    QCOMPARE(coach.job().at(), std::size_t{part});
    QVERIFY(!driver.visible<QWidget>("coachBackButton")->isEnabled());
    QVERIFY(driver.clickOn("coachSkipButton"));
    QCOMPARE(coach.job().at(), std::size_t{voxel});
    QVERIFY(driver.clickOn("coachSkipButton"));
    QCOMPARE(coach.job().at(), std::size_t{embed});
    QVERIFY(points("embedButton"));
}

void TestWindowFirstJob::itAsksAboutUnsavedWork() {
    WindowDriver driver;
    const Coach& coach = driver.window().coach();
    QVERIFY(makeReady(driver, 1.0));
    QTRY_VERIFY(driver.window().workbench().document.unsaved());
    bool asked = false;
    driver.whenDialogStands([&](QWidget& dialog) { asked = answer(dialog, "cancelButton"); });
    driver.key(Qt::Key_J, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(asked);
    QTest::qWait(200);
    QVERIFY(!coach.running() && driver.window().workbench().model.model() != nullptr);
    driver.whenDialogStands([&](QWidget& dialog) { answer(dialog, "discardButton"); });
    QVERIFY(begin(driver));
    QVERIFY(driver.window().workbench().model.model() == nullptr);
    QCOMPARE(nameOf(coach.pointed()), QString("samplePartButton"));
    QVERIFY(driver.visible("backButton") == nullptr);
    // With an empty project, the sample part is opened from the menu.
    driver.key(Qt::Key_N, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return qobject_cast<QMenuBar*>(coach.pointed().widget) != nullptr; }));
    Follower follower(driver);
    QVERIFY(follower.reach(voxel));
    QCOMPARE(follower.menuEntries, 1);
    QVERIFY2(follower.faults.isEmpty(), qPrintable(follower.faults.join('\n')));
}

void TestWindowFirstJob::itIsWorkedByKeys() {
    WindowDriver driver;
    const Coach& coach = driver.window().coach();
    QVERIFY(begin(driver));
    CoachPanel& panel = panelOf(driver);
    QVERIFY(coach.hasKeyboard());
    QCOMPARE(QApplication::focusWidget(), &panel);
    QCOMPARE(panel.accessibleName(), QString("First job: step 1 of 11: Open the sample part"));
    QVERIFY(panel.accessibleDescription().startsWith("Press “Try the sample part”."));
    const auto focus = [] { return QApplication::focusWidget() ? QApplication::focusWidget()->objectName() : ""; };
    driver.key(Qt::Key_Tab);
    QCOMPARE(focus(), QString("coachSkipButton")); // there is no previous step
    driver.key(Qt::Key_Space);
    QTRY_VERIFY(panel.accessibleName().contains("step 2 of 11"));
    driver.key(Qt::Key_Tab);
    QCOMPARE(focus(), QString("coachEndButton"));
    driver.key(Qt::Key_Backtab);
    driver.key(Qt::Key_Backtab);
    QCOMPARE(focus(), QString("coachBackButton"));
    for (const QPushButton* button : panel.findChildren<QPushButton*>())
        QVERIFY2(!button->text().isEmpty() && !button->toolTip().isEmpty(), qPrintable(button->objectName()));
    // Outside the panel, Esc keeps its usual meaning; the same shortcut returns the focus to the panel.
    driver.visible<QWidget>("samplePartButton")->setFocus();
    driver.key(Qt::Key_Escape);
    QVERIFY(coach.running());
    driver.key(Qt::Key_J, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(coach.hasKeyboard());
    QCOMPARE(coach.job().at(), std::size_t{voxel}); // the step is unchanged
    driver.key(Qt::Key_Escape);
    QVERIFY(!coach.running() && !panel.isVisible() && outline() == nullptr);
    QVERIFY(!UserSettings().firstJobFinished());
}

void TestWindowFirstJob::textsFit_data() {
    QTest::addColumn<QString>("language");
    std::vector<const char*> languages{"de"};         // the longest words
    if (longRun()) languages = {"en", "zh_CN", "de"}; // an installed translation stays installed
    for (const char* language : languages) QTest::newRow(language) << QString::fromLatin1(language);
}

void TestWindowFirstJob::textsFit() {
    QFETCH(QString, language);
    const bool translated = language != "en";
    if (translated) QVERIFY(Messages::install(QLocale(language)));
    WindowDriver driver({1024, 680}, translated ? QLocale(language) : QLocale::c());
    const Coach& coach = driver.window().coach();
    QVERIFY(begin(driver));
    QStringList cut;
    const CoachPanel& panel = panelOf(driver);
    for (std::size_t step = 0; step <= firstJobSteps().size(); ++step) {
        QCOMPARE(coach.job().at(), step);
        QTest::qWait(50);
        driver.shoot(QStringLiteral("first-job-%1-%2").arg(language).arg(step + 1));
        for (const VisibleText& text : clippedTexts(panelOf(driver))) cut << text.where + ": " + text.text;
        QVERIFY(driver.window().rect().contains(panel.geometry()));
        const QString title = driver.window().findChild<QLabel*>("coachTitle")->accessibleName();
        if (step < firstJobSteps().size()) {
            QCOMPARE(title == QString::fromUtf8(firstJobSteps()[step].title), !translated);
            QVERIFY(driver.clickOn("coachSkipButton"));
        }
    }
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join('\n')));
}

BURIN_TEST(TestWindowFirstJob, QApplication)

} // namespace burin::tst_window_first_job

#include "tst_window_first_job.moc"
