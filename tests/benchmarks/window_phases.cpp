// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/window_phases.h"

#include "tests/benchmarks/event_loop.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/project_tree.h"
#include "ui/panels/timeline_view.h"
#include "ui/theme/theme.h"

#include <QDialog>
#include <QPushButton>
#include <QScrollArea>
#include <QtTest>

#include <chrono>
#include <cmath>
#include <functional>

namespace burin::testing {

namespace {

using namespace std::chrono_literals;

bool phase(const char* name, StallWatch& watch, Report& report, const std::function<bool()>& what) {
    watch.beginPhase();
    const bool done = what();
    runFor(500ms); // for deferred work, such as the view at rest
    report.addStalls(name, watch);
    return done;
}

bool inFullDetail(const Viewport& viewport) {
    return runUntil([&] { return viewport.statistics().fullDetail && !viewport.statistics().busy; }, 10s);
}

bool undoStrokes(WindowDriver& driver, std::size_t count) {
    Workbench& workbench = driver.window().workbench();
    for (std::size_t left = workbench.workpiece.strokes().count(); count > 0; --count) {
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        --left;
        if (!runUntil([&] { return workbench.workpiece.strokes().count() == left; }, 10s)) return false;
        if (!inFullDetail(driver.window().viewport())) return false;
    }
    return true;
}

/// Changes a choice in the preferences by key.
void choose(WindowDriver& driver, const char* choice, Qt::Key key) {
    driver.whenDialogStands([=](QWidget& dialog) {
        auto* box = dialog.findChild<QWidget*>(choice);
        if (box != nullptr) QTest::keyClick(box, key);
        runFor(500ms);
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    driver.key(Qt::Key_Comma, Qt::ControlModifier);
    runFor(500ms);
}

/// Drags along the timeline to its start and back, in steps as a mouse reports them, then waits for the picture.
bool scrub(WindowDriver& driver) {
    TimeController& time = driver.window().workbench().time;
    if (!runUntil([&] { return time.possible() && time.recorded() != nullptr && !time.reading(); }, 30s)) return false;
    auto* view = driver.visible<TimelineView>("timelineView");
    if (view == nullptr) return false;
    const double all = time.recorded()->seconds();
    const auto place = [&](double share) {
        return QPoint(static_cast<int>(std::lround(view->placeOf(share * all))), view->height() - 16);
    };
    QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, place(0.95));
    constexpr int steps = 60;
    for (int i = -steps; i <= steps; ++i) {
        QTest::mouseMove(view, place(0.05 + 0.9 * std::abs(i) / steps));
        runFor(16ms);
    }
    QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, place(0.5));
    return runUntil([&] { return time.shown() && !time.arriving(); }, 30s) && inFullDetail(driver.window().viewport());
}

/// Plays the second half, four times as fast as it was milled, for as long as given, and returns to the present.
bool play(WindowDriver& driver, std::chrono::milliseconds length) {
    TimeController& time = driver.window().workbench().time;
    time.goTo(0.5 * time.recorded()->seconds());
    time.setSpeed(4.0);
    if (!driver.clickOn("playButton")) return false;
    const double from = time.seconds();
    runFor(length);
    const bool went = time.seconds() > from;
    time.pause();
    driver.window().viewport().setFocus();
    driver.key(Qt::Key_Escape);
    return went && runUntil([&] { return !time.away(); }, 10s) && inFullDetail(driver.window().viewport());
}

/// Opens the tree, hides the part and shows it again.
bool useTree(WindowDriver& driver) {
    driver.key(Qt::Key_F10, Qt::ControlModifier);
    if (!runUntil([&] { return driver.visible<ProjectTree>("projectTree") != nullptr; }, 5s)) return false;
    auto* tree = driver.visible<ProjectTree>("projectTree");
    const QList<QTreeWidgetItem*> part = tree->findItems(QStringLiteral("Part"), Qt::MatchExactly);
    if (part.isEmpty()) return false;
    for (int i = 0; i < 2; ++i) {
        tree->setFocus();
        const QList<QTreeWidgetItem*> now = tree->findItems(QStringLiteral("Part"), Qt::MatchExactly);
        tree->setCurrentItem(now.front()->child(0));
        QTest::keyClick(tree, Qt::Key_Space);
        runFor(500ms);
    }
    driver.key(Qt::Key_F10, Qt::ControlModifier);
    return runUntil([&] { return driver.visible<ProjectTree>("projectTree") == nullptr; }, 5s);
}

/// The section plane, the excess colours and a glass workpiece, each on and off.
bool changeView(WindowDriver& driver) {
    for (const char* name : {"sectionPlaneAction", "excessAction", "seeThroughAction"})
        for (int i = 0; i < 2; ++i) {
            QAction* action = menuAction(driver, QLatin1String(name));
            if (action == nullptr) return false;
            action->trigger();
            runFor(300ms);
            if (!inFullDetail(driver.window().viewport())) return false;
        }
    return true;
}

/// Changes an edit of the path, as entering another feed does, and undoes it.
bool editPath(WindowDriver& driver) {
    PathController& path = driver.window().workbench().path;
    const auto ready = [&] { return path.evaluated() && !path.outdated() && !path.busy(); };
    path.addEdit({SetFeed{}});
    if (!runUntil(ready, 60s)) return false;
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    return runUntil(ready, 60s) && inFullDetail(driver.window().viewport());
}

bool comparePaths(WindowDriver& driver) {
    PathComparer& comparer = driver.window().workbench().pathComparer;
    driver.key(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
    if (!runUntil([&] { return comparer.compared() != nullptr && !comparer.busy(); }, 60s)) return false;
    runFor(500ms);
    auto* dialog = driver.visible<QDialog>("comparisonDialog");
    if (dialog == nullptr) return false;
    dialog->close();
    return runUntil([&] { return !comparer.isOpen(); }, 5s);
}

bool lookAtFaces(WindowDriver& driver) {
    auto* page = driver.visible<QScrollArea>("programPage");
    auto* button = driver.visible<QPushButton>("facesButton");
    if (page == nullptr || button == nullptr) return false;
    page->ensureWidgetVisible(button);
    QTest::mouseClick(button, Qt::LeftButton);
    const auto dialog = [&] { return driver.window().findChild<QDialog*>(QStringLiteral("faceDialog")); };
    if (!runUntil([&] { return dialog() != nullptr && dialog()->isVisible(); }, 10s)) return false;
    const bool measured = runUntil([&] { return driver.window().workbench().tasks().idle(); }, 60s);
    runFor(500ms);
    dialog()->close();
    return measured;
}

bool writeSheet(WindowDriver& driver) {
    const QString file = driver.folder().filePath("sheet.html");
    chooseFile(driver, file);
    driver.key(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    return runUntil([&] { return QFile::exists(file) && !driver.window().workbench().sheet.writing(); }, 60s);
}

bool otherTheme(WindowDriver& driver) {
    const QColor before = activePalette().window;
    choose(driver, "themeChoice", Qt::Key_Down);
    const bool other = activePalette().window != before;
    choose(driver, "themeChoice", Qt::Key_Up);
    return other && activePalette().window == before;
}

bool otherChoice(WindowDriver& driver, const char* choice) {
    choose(driver, choice, Qt::Key_Down);
    choose(driver, choice, Qt::Key_Up);
    return true;
}

} // namespace

bool importSample(WindowDriver& driver, StallWatch& watch, Report& report) {
    return phase("gui_stall_max_importing", watch, report, [&] {
        return driver.clickOn("samplePartButton") &&
               runUntil([&] { return driver.window().workbench().model.model() != nullptr; });
    });
}

bool embedSample(WindowDriver& driver, StallWatch& watch, Report& report) {
    return phase("gui_stall_max_embedding", watch, report, [&] {
        Workbench& workbench = driver.window().workbench();
        if (!driver.step(JobStep::stock)) return false;
        auto* voxel = driver.visible<QWidget>("voxelField");
        if (voxel == nullptr) return false;
        voxel->setFocus();
        QTest::keyClick(voxel, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(voxel, "0.25");
        QTest::keyClick(voxel, Qt::Key_Return);
        if (!runUntil([&] { return workbench.setup.setup().voxel == 0.25; }, 3s) || !driver.clickOn("embedButton"))
            return false;
        return runUntil([&] { return workbench.workpiece.ready() && workbench.tasks().idle(); }) &&
               inFullDetail(driver.window().viewport());
    });
}

bool workOn(WindowDriver& driver, StallWatch& watch, Report& report) {
    Workbench& workbench = driver.window().workbench();
    const auto measured = [&](const char* name, const std::function<bool()>& what) {
        return phase(name, watch, report, what);
    };
    return measured("gui_stall_max_undo", [&] { return undoStrokes(driver, 3); }) &&
           measured("gui_stall_max_stopping",
                    [&] {
                        driver.key(Qt::Key_Escape);
                        return runUntil([&] { return !workbench.session.running() && workbench.tasks().idle(); }, 10s);
                    }) &&
           measured("gui_stall_max_scrubbing", [&] { return scrub(driver); }) &&
           measured("gui_stall_max_playing", [&] { return play(driver, 3s); }) &&
           measured("gui_stall_max_tree", [&] { return useTree(driver); }) &&
           measured("gui_stall_max_view", [&] { return changeView(driver); }) &&
           measured("gui_stall_max_path",
                    [&] {
                        return driver.step(JobStep::path) && driver.clickOn("newPathButton") &&
                               runUntil([&] { return workbench.path.evaluated() && workbench.tasks().idle(); });
                    }) &&
           measured("gui_stall_max_editing", [&] { return editPath(driver); }) &&
           measured("gui_stall_max_comparing", [&] { return comparePaths(driver); }) &&
           measured("gui_stall_max_posting",
                    [&] {
                        return driver.step(JobStep::program) && driver.clickOn("postButton") &&
                               runUntil([&] { return workbench.program.program() && !workbench.program.busy(); });
                    }) &&
           measured("gui_stall_max_playing_program", [&] { return play(driver, 3s); }) &&
           measured("gui_stall_max_faces", [&] { return lookAtFaces(driver); }) &&
           measured("gui_stall_max_sheet", [&] { return writeSheet(driver); }) &&
           measured("gui_stall_max_theme", [&] { return otherTheme(driver); }) &&
           measured("gui_stall_max_language", [&] { return otherChoice(driver, "languageChoice"); }) &&
           measured("gui_stall_max_unit", [&] { return otherChoice(driver, "unitChoice"); }) &&
           measured("gui_stall_max_saving", [&] { return saveAs(driver, driver.folder().filePath("bench.burin")); });
}

bool openAgain(WindowDriver& driver, StallWatch& watch, Report& report) {
    if (!driver.restart()) return false;
    Workbench& workbench = driver.window().workbench();
    runFor(500ms);
    return phase("gui_stall_max_opening", watch, report, [&] {
        return driver.clickOn("recentFileButton") && runUntil([&] {
                   return workbench.workpiece.ready() && workbench.tasks().idle() && workbench.path.evaluated();
               }) &&
               inFullDetail(driver.window().viewport());
    });
}

} // namespace burin::testing
