// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/window_opening.h"

#include "tests/benchmarks/event_loop.h"
#include "tests/benchmarks/long_take.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QFileInfo>
#include <QProcess>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>
#include <vector>

namespace burin::testing {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr LongTake oneHour{3'600'000, 50, 0.002};
constexpr int runs = 5;
constexpr auto patience = 30min;

/// The times of one new process, ms after its start; empty if it failed.
std::optional<nlohmann::json> openOnce(const QString& file) {
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    const auto now = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch());
    process.start(QCoreApplication::applicationFilePath(),
                  {QStringLiteral("--open"), file, QString::number(now.count())});
    if (!runUntil([&] { return process.state() == QProcess::NotRunning; }, 120s)) return std::nullopt;
    const QByteArray said = process.readAllStandardOutput();
    const auto times = nlohmann::json::parse(said.begin(), said.end(), nullptr, false);
    return times.is_object() ? std::optional(times) : std::nullopt;
}

} // namespace

bool measureOpening(WindowDriver& driver, Report& report) {
    const QString file = driver.folder().filePath("hour.burin");
    Workbench* workbench = &driver.window().workbench();
    const std::string tool = workbench->tool.current().id;
    if (!saveAs(driver, file) || !driver.restart(true)) return false; // closed, so that another may write it
    if (!recordLong(file, tool, oneHour)) return false;
    if (!driver.restart(true) || !driver.clickOn("recentFileButton")) return false;
    workbench = &driver.window().workbench();
    const Clock::time_point begin = Clock::now();
    if (!runUntil([&] { return workbench->workpiece.ready(); }, patience)) return false;
    report.add("open_hour.replayed", 1e3 * secondsSince(begin), "ms");
    // The workpiece is kept with the project, and the state of the window stored.
    if (!runUntil([&] { return workbench->keeper.hash().has_value() && workbench->tasks().idle(); }, patience))
        return false;
    workbench->document.save();
    if (!runUntil([&] { return !workbench->document.unsaved() && workbench->tasks().idle(); }, patience)) return false;
    runFor(1s);
    if (!driver.endQuietly()) return false;
    report.add("open_hour.file", 1e-6 * static_cast<double>(QFileInfo(file).size()), "MB");
    std::vector<nlohmann::json> all;
    for (int i = 0; i < runs; ++i) {
        const std::optional<nlohmann::json> times = openOnce(file);
        if (!times) return false;
        all.push_back(*times);
    }
    for (const char* name : {"window", "opened", "embedded", "workpiece", "full_detail", "ready"}) {
        std::ranges::sort(all, {}, [name](const nlohmann::json& run) { return run.at(name).get<double>(); });
        const auto limit = std::string(name) == "workpiece" ? std::optional(1500.0) : std::nullopt;
        report.add(std::string("open_hour.") + name, all[runs / 2].at(name).get<double>(), "ms", limit);
    }
    return true;
}

int openAndMeasure(const QString& file, qint64 begun) {
    const Clock::time_point start{std::chrono::nanoseconds(begun)};
    const auto now = [&] { return 1e3 * secondsSince(start); };
    QCoreApplication::setApplicationName(QStringLiteral("Burin"));
    MainWindow window;
    window.resize(1280, 800);
    window.show();
    Workbench& workbench = window.workbench();
    Viewport& viewport = window.viewport();
    nlohmann::json times;
    const auto note = [&](const char* name) {
        if (!times.contains(name)) times[name] = now();
    };
    QObject::connect(&workbench.document, &DocumentController::opened, [&] { note("opened"); });
    std::size_t without = 0; // triangles that are drawn without the workpiece
    QObject::connect(&workbench.workpiece, &WorkpieceController::workpieceChanged, [&] {
        if (!workbench.workpiece.embedded()) return;
        note("embedded");
        without = viewport.statistics().triangles;
    });
    QObject::connect(&viewport, &Viewport::painted, [&] {
        note("window");
        if (!workbench.workpiece.embedded()) return;
        const FrameStatistics drawn = viewport.statistics();
        if (drawn.triangles != without) note("workpiece");
        if (drawn.fullDetail && !drawn.busy) note("full_detail");
    });
    window.openFile(file);
    const bool done = runUntil([&] { return workbench.workpiece.ready() && times.contains("full_detail"); }, 100s);
    note("ready");
    window.endQuietly();
    if (!done || !runUntil([&] { return !window.isVisible(); }, 20s)) return 1;
    std::cout << times << std::endl;
    return 0;
}

} // namespace burin::testing
