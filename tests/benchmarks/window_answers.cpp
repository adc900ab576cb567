// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/window_answers.h"

#include "core/path/edit_values.h"
#include "tests/benchmarks/event_loop.h"
#include "tests/benchmarks/long_take.h"
#include "tests/ui/window_steps.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <optional>

namespace burin::testing {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr LongTake longTake{400'000, 20'000, 0.0};
constexpr auto patience = 300s;

double millisecondsSince(Clock::time_point begin) {
    return 1e3 * secondsSince(begin);
}

/// Waits for the answer to a change of the path. Times in ms after the last call of `begin`.
class Answers {
public:
    explicit Answers(WindowDriver& driver) : driver_(driver) {
        Workbench& workbench = driver.window().workbench();
        const auto note = [this] {
            if (!first_) first_ = millisecondsSince(begin_);
        };
        connections_ = {QObject::connect(&workbench.path, &PathController::firstResult, note),
                        QObject::connect(&workbench.path, &PathController::evaluatedAnew, note),
                        QObject::connect(&driver.window().viewport(), &Viewport::painted, [this] {
                            if (first_ && !shown_) shown_ = millisecondsSince(begin_);
                        })};
    }
    ~Answers() {
        for (const QMetaObject::Connection& connection : connections_) QObject::disconnect(connection);
    }
    Answers(const Answers&) = delete;
    Answers& operator=(const Answers&) = delete;

    void begin() {
        begin_ = Clock::now();
        first_.reset();
        shown_.reset();
    }
    bool wait() {
        PathController& path = driver_.window().workbench().path;
        const bool came = runUntil([&] { return !path.busy() && !path.outdated() && shown_; }, patience);
        whole_ = millisecondsSince(begin_);
        return came;
    }
    double first() const { return shown_.value_or(0.0); } ///< until something new was painted
    double whole() const { return whole_; }

private:
    WindowDriver& driver_;
    std::array<QMetaObject::Connection, 3> connections_;
    Clock::time_point begin_ = Clock::now();
    std::optional<double> first_, shown_;
    double whole_ = 0.0;
};

/// Types a value into a field of an edit of the given kind.
bool typeInto(WindowDriver& driver, const char* kind, const char* key, const QString& value) {
    const StoredPath* path = driver.window().workbench().path.stored();
    if (path == nullptr) return false;
    const auto edit =
        std::ranges::find(path->edits, std::string_view(kind), [](const Edit& each) { return idOf(each.parameters); });
    if (edit == path->edits.end()) return false;
    return driver.enter(qPrintable(QStringLiteral("edit%1_%2").arg(edit - path->edits.begin()).arg(QLatin1String(key))),
                        value);
}

bool changeEdits(WindowDriver& driver, Report& report) {
    struct Change {
        const char *kind, *key;
        QString value;
    };
    const Change changes[] = {{"smooth-shape", "wavelength_mm", "3.5"},
                              {"fit-arcs", "tolerance_mm", "0.012"},
                              {"set-feed", "feed_factor", "0.9"}};
    Answers answers(driver);
    for (const Change& change : changes) {
        answers.begin();
        if (!typeInto(driver, change.kind, change.key, change.value) || !answers.wait()) return false;
        const std::string name = std::string("edit.") + change.kind;
        report.add(name + ".first_result", answers.first(), "ms", 300.0);
        report.add(name + ".whole", answers.whole(), "ms", 2000.0);
    }
    // A point in the middle of the path is moved, as by a drag.
    PathController& path = driver.window().workbench().path;
    const std::vector<PathPoint>& points = path.evaluated()->path.points;
    const auto middle = std::find_if(
        points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2), points.end(),
        [](const PathPoint& point) { return point.source != 0 && point.sample >= 0 && point.kind == MoveKind::cut; });
    if (middle == points.end()) return false;
    answers.begin();
    path.movePlace({middle->source, middle->sample}, {0.0, 0.0, 0.5}, MovePoints::Along::free);
    if (!answers.wait()) return false;
    report.add("edit.move-points.first_result", answers.first(), "ms", 300.0);
    report.add("edit.move-points.whole", answers.whole(), "ms", 2000.0);
    return true;
}

/// @return ms until the program was posted and checked; empty: it was not
std::optional<double> checkProgram(WindowDriver& driver) {
    ProgramController& program = driver.window().workbench().program;
    const auto before = program.program();
    const Clock::time_point begin = Clock::now();
    if (!driver.step(JobStep::program) || !driver.clickOn("postButton")) return std::nullopt;
    if (!runUntil([&] { return program.program() != before && !program.busy(); }, patience)) return std::nullopt;
    return millisecondsSince(begin);
}

bool checkTwice(WindowDriver& driver, Report& report) {
    const std::optional<double> first = checkProgram(driver);
    if (!first || !driver.step(JobStep::path)) return false;
    PathController& path = driver.window().workbench().path;
    const StoredPath* stored = path.stored();
    const auto moved = std::ranges::find(stored->edits, std::string_view("move-points"),
                                         [](const Edit& each) { return idOf(each.parameters); });
    if (moved == stored->edits.end()) return false;
    Edit higher = *moved;
    std::get<MovePoints>(higher.parameters).by.z += 0.5;
    path.changeEdit(static_cast<std::size_t>(moved - stored->edits.begin()), higher);
    if (!runUntil([&] { return !path.busy() && !path.outdated(); }, patience)) return false;
    const std::optional<double> again = checkProgram(driver);
    if (!again) return false;
    report.add("check.first", *first, "ms");
    report.add("check.after_one_edit", *again, "ms", *first / 3.0);
    return true;
}

} // namespace

bool measureAnswers(WindowDriver& driver, Report& report) {
    const QString file = driver.folder().filePath("answers.burin");
    const std::string tool = driver.window().workbench().tool.current().id;
    if (!saveAs(driver, file) || !driver.restart(true)) return false; // closed, so that another may write it
    if (!recordLong(file, tool, longTake)) return false;
    const Clock::time_point begin = Clock::now();
    if (!driver.restart(true)) return false;
    report.add("welcome_page", millisecondsSince(begin), "ms", 500.0); // without the start of the process
    Workbench& workbench = driver.window().workbench();
    runFor(500ms);
    if (!driver.clickOn("recentFileButton")) return false;
    const Clock::time_point opened = Clock::now();
    if (!runUntil([&] { return workbench.workpiece.ready(); }, patience)) return false;
    report.add("open.workpiece", millisecondsSince(opened), "ms");
    if (!driver.step(JobStep::path) || !driver.clickOn("newPathButton")) return false;
    const Clock::time_point asked = Clock::now();
    const auto evaluated = [&] { return workbench.path.evaluated() && workbench.tasks().idle(); };
    if (!runUntil(evaluated, patience)) return false;
    report.add("path.new", millisecondsSince(asked), "ms");
    report.add("path.points", static_cast<double>(workbench.path.evaluated()->path.points.size()), "");
    return changeEdits(driver, report) && checkTwice(driver, report);
}

} // namespace burin::testing
