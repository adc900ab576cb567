// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/window_phases.h"

#include "tests/benchmarks/event_loop.h"
#include "tests/ui/window_steps.h"
#include "ui/theme/theme.h"

#include <QtTest>

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
           measured("gui_stall_max_path",
                    [&] {
                        return driver.step(JobStep::path) && driver.clickOn("newPathButton") &&
                               runUntil([&] { return workbench.path.evaluated() && workbench.tasks().idle(); });
                    }) &&
           measured("gui_stall_max_posting",
                    [&] {
                        return driver.step(JobStep::program) && driver.clickOn("postButton") &&
                               runUntil([&] { return workbench.program.program() && !workbench.program.busy(); });
                    }) &&
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
