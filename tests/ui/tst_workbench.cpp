// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "ui/workbench/workbench.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>
#include <new>
#include <stdexcept>
#include <thread>

namespace burin::tst_workbench {

namespace {

/// Runs until it is cancelled.
Result<int> patientWork(Progress& progress) {
    while (!progress.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return Error{ErrorCode::cancelled, "work", {}, {}};
}

template <class T>
auto into(std::optional<Result<T>>& place) {
    return [&place](Result<T> outcome) { place.emplace(std::move(outcome)); };
}

} // namespace

class TestWorkbench : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        qputenv("XDG_DATA_HOME", folder_->path().toUtf8());
        QCoreApplication::setApplicationName("Burin");
    }

    void aTaskGivesItsOutcomeOnTheCallersThread() {
        TaskRunner tasks;
        std::thread::id worker, deliverer;
        std::optional<Result<int>> outcome;
        tasks.start(
            TaskKind::path, "sum",
            [&](Progress&) -> Result<int> {
                worker = std::this_thread::get_id();
                return 42;
            },
            [&](Result<int> result) {
                deliverer = std::this_thread::get_id();
                outcome.emplace(std::move(result));
            });
        QTRY_VERIFY(outcome.has_value());
        QCOMPARE(**outcome, 42);
        QVERIFY(worker != deliverer);
        QVERIFY(deliverer == std::this_thread::get_id());
        QVERIFY(tasks.idle());
    }
    void aCancelledTaskSaysSo() {
        TaskRunner tasks;
        std::optional<Result<int>> outcome;
        tasks.start(TaskKind::embedding, "patient", patientWork, into(outcome));
        QCOMPARE(tasks.rows().size(), std::size_t{1});
        tasks.cancel(TaskKind::embedding);
        QTRY_VERIFY(outcome.has_value());
        QCOMPARE(outcome->error().code, ErrorCode::cancelled);
    }
    void aTaskReplacesTheOneOfItsKindThatRuns() {
        TaskRunner tasks;
        std::optional<Result<int>> first, second, third;
        tasks.start(TaskKind::path, "first", patientWork, into(first));
        tasks.start(
            TaskKind::path, "second", [](Progress&) -> Result<int> { return 2; }, into(second));
        tasks.start(
            TaskKind::path, "third", [](Progress&) -> Result<int> { return 3; }, into(third));
        QTRY_VERIFY(third.has_value());
        QCOMPARE(**third, 3);
        QVERIFY(tasks.idle());
        QVERIFY(!first.has_value()); // the result is no longer needed
        QVERIFY(!second.has_value());
    }
    /// The caller of the newest task waits to be notified, even if that task had not begun.
    void cancellingTellsTheTaskThatWaits() {
        TaskRunner tasks;
        std::optional<Result<int>> first, second;
        bool began = false;
        tasks.start(TaskKind::path, "first", patientWork, into(first));
        tasks.start(
            TaskKind::path, "second",
            [&](Progress&) -> Result<int> {
                began = true;
                return 2;
            },
            into(second));
        tasks.cancel(TaskKind::path);
        QTRY_VERIFY(second.has_value());
        QCOMPARE(second->error().code, ErrorCode::cancelled);
        QVERIFY(!began && !first.has_value());
        QVERIFY(tasks.idle());
        tasks.start(TaskKind::path, "first", patientWork, into(first));
        tasks.start(TaskKind::path, "second", patientWork, into(second));
        second.reset();
        tasks.abandon(TaskKind::path); // the results are no longer needed
        QTRY_VERIFY(tasks.idle());
        QVERIFY(!first.has_value() && !second.has_value());
    }
    void whatReadsIsThroughBeforeItIsChanged() {
        TaskRunner tasks;
        std::atomic<bool> reading{false};
        tasks.start(
            TaskKind::program, "reader",
            [&](Progress& progress) {
                reading = true;
                const Result<int> outcome = patientWork(progress);
                std::this_thread::sleep_for(std::chrono::milliseconds(30));
                reading = false;
                return outcome;
            },
            [](const Result<int>&) { QFAIL("an abandoned task has no outcome"); });
        bool changed = false;
        QTRY_VERIFY(reading);
        tasks.abandon(TaskKind::program);
        tasks.whenIdle([&] {
            changed = true;
            QVERIFY(!reading);
        });
        QVERIFY(!changed);
        QTRY_VERIFY(changed);
    }
    void exceptionsBecomeErrors() {
        TaskRunner tasks;
        std::optional<Result<int>> memory, fault;
        tasks.start(
            TaskKind::path, "memory", [](Progress&) -> Result<int> { throw std::bad_alloc(); }, into(memory));
        tasks.start(
            TaskKind::field, "fault", [](Progress&) -> Result<int> { throw std::runtime_error("broken"); },
            into(fault));
        QTRY_VERIFY(memory.has_value() && fault.has_value());
        QCOMPARE(memory->error().code, ErrorCode::outOfMemory);
        QCOMPARE(fault->error().code, ErrorCode::internalFault);
        QCOMPARE(fault->error().detail, std::string("broken"));
    }

    void aLentProjectIsUsedByOneThreadAtATime() {
        ProjectThread thread;
        const std::filesystem::path file = folder_->filePath("p.burin").toStdString();
        std::vector<int> order; // written by both threads in turn, which the thread sanitizer checks
        thread.postToPlace(
            [&](std::optional<Project>& place) -> Result<void> {
                order.push_back(1);
                Result<Project> project = Project::create(file);
                if (!project) return std::move(project).error();
                place.emplace(std::move(*project));
                return {};
            },
            [](const Result<void>& outcome) { QVERIFY(outcome); });
        bool lent = false;
        thread.lend([&](Project* project) {
            QVERIFY(project != nullptr);
            order.push_back(2);
            lent = true;
        });
        thread.ask(
            [&](Project& project) {
                order.push_back(3);
                return project.unsaved();
            },
            [](const Result<bool>& unsaved) { QVERIFY(unsaved && !*unsaved); });
        QVERIFY(order.size() < 3 || !lent); // nothing of it blocked this thread
        thread.finish();
        QVERIFY(lent);
        QCOMPARE(order, (std::vector<int>{1, 2, 3}));
    }
    void withoutAProjectThereIsAnError() {
        ProjectThread thread;
        std::optional<Result<bool>> outcome;
        thread.ask([](Project& project) { return project.unsaved(); }, into(outcome));
        bool asked = false;
        thread.lend([&](Project* project) { asked = project == nullptr; });
        thread.finish();
        QVERIFY(asked);
        QCOMPARE(outcome->error().code, ErrorCode::internalFault);
    }

    void anStlFileIsReadInItsUnit() {
        Workbench workbench;
        const std::filesystem::path file = BURIN_FIXTURES "/models/pocket-test.stl";
        workbench.importPart(file, false);
        QTRY_VERIFY_WITH_TIMEOUT(workbench.model.model() && !workbench.model.importing(), 20000);
        const auto before = workbench.model.model();
        ImportOptions inches;
        inches.unitInstead = 25.4;
        workbench.model.read(file, inches, [&](const auto& part) { QVERIFY(workbench.changeUnit(before, part)); });
        QTRY_VERIFY_WITH_TIMEOUT(workbench.model.model() != before && !workbench.model.importing(), 20000);
        QCOMPARE(workbench.model.model()->unitScale, 25.4);
        QVERIFY(std::abs(workbench.model.model()->volume() / before->volume() - 25.4 * 25.4 * 25.4) < 1.0);
        workbench.surroundings.importFile(file, 25.4); // a fixture
        QTRY_COMPARE_WITH_TIMEOUT(workbench.surroundings.obstacles().size(), std::size_t{1}, 20000);
        const Box fixture = boundsOf(*workbench.surroundings.obstacles().front().obstacle);
        QVERIFY(glm::distance(fixture.size(), 25.4 * before->box().size()) < 1e-3);
    }
    void anImportCanBeStopped() {
        Workbench workbench;
        std::optional<Error> error;
        connect(&workbench, &Workbench::failed, this, [&](const Error& told) { error = told; });
        workbench.importPart(resourceDirectory() / "samples/mouse.step", false);
        QTRY_VERIFY(workbench.model.importing());
        workbench.tasks().cancelAll();
        QTRY_VERIFY(error.has_value());
        QCOMPARE(error->code, ErrorCode::cancelled);
        QVERIFY(workbench.model.model() == nullptr);
    }
    void theVoxelSuitsThePartsSize() {
        const auto box = [](double length) { return Box{glm::dvec3(0.0), glm::dvec3(length, 1.0, 1.0)}; };
        QCOMPARE(suitableVoxel(box(110.0)), 0.5); // the sample part
        QCOMPARE(suitableVoxel(box(20.0)), 0.1);
        QCOMPARE(suitableVoxel(box(400.0)), 2.0);
        QCOMPARE(suitableVoxel(box(1.3)), 0.02); // the stock around it is eight times as long
    }
    void aNewProjectIsOnTheDiskFromTheStart() {
        std::filesystem::path file;
        {
            Workbench workbench;
            workbench.document.createNew(false);
            QTRY_VERIFY(workbench.document.isOpen());
            QVERIFY(workbench.document.isUnnamed());
            file = workbench.document.file();
            workbench.tool.choose("flat-6");
            QTRY_VERIFY(workbench.document.unsaved());
            QVERIFY(workbench.document.leftWork().left.empty()); // the project itself is in use
        }
        Workbench next;
        const std::vector<LeftWork> left = next.document.leftWork().left;
        QCOMPARE(left.size(), std::size_t{1});
        QCOMPARE(left.front().file, file);
        next.document.openFile(file, false);
        QTRY_VERIFY(next.document.isOpen());
        QVERIFY(next.document.recovered());
        QCOMPARE(next.tool.current().id, std::string("flat-6"));
        bool closed = false;
        next.document.close(true, [&](bool) { closed = true; });
        QTRY_VERIFY(closed);
        QVERIFY(next.document.leftWork().left.empty()); // the recovered work was declined
    }
    /// What a user enters while an undo reads the project again is refused, and fields show the former value again.
    void aChangeDuringAnUndoIsRefused() {
        Workbench workbench;
        workbench.document.createNew(false);
        QTRY_VERIFY(workbench.document.isOpen());
        History& history = workbench.undo();
        history.pushStep(QStringLiteral("step"), {}, history.present());
        const std::string before = workbench.tool.current().id;
        QVERIFY(before != "flat-6");
        history.undo();
        QVERIFY(history.busy());
        QSignalSpy failed(&workbench, &Workbench::failed), tool(&workbench.tool, &Controller::changed),
            setup(&workbench.setup, &Controller::changed);
        workbench.tool.choose("flat-6");
        QCOMPARE(failed.size(), 1);
        QVERIFY(!tool.isEmpty() && workbench.tool.current().id == before);
        setup.clear();
        workbench.setup.setRegions({MaterialRegion{}});
        QCOMPARE(failed.size(), 2);
        QVERIFY(!setup.isEmpty() && workbench.setup.setup().regions.empty());
        QTRY_VERIFY(!history.busy());
        workbench.tool.choose("flat-6");
        QCOMPARE(failed.size(), 2);
        QCOMPARE(workbench.tool.current().id, std::string("flat-6"));
    }
    void aFailedOpenLeavesWhatIsOpen() {
        Workbench workbench;
        workbench.document.createNew(false);
        QTRY_VERIFY(workbench.document.isOpen());
        const std::filesystem::path file = workbench.document.file();
        std::optional<Error> error;
        connect(&workbench, &Workbench::failed, this, [&](const Error& told) { error = told; });
        workbench.document.openFile(folder_->filePath("none.burin").toStdString(), true);
        QTRY_VERIFY(error.has_value());
        QCOMPARE(error->code, ErrorCode::fileNotFound);
        QCOMPARE(workbench.document.file(), file);
    }

private:
    std::unique_ptr<QTemporaryDir> folder_;
};

BURIN_TEST(TestWorkbench, QCoreApplication)

} // namespace burin::tst_workbench

#include "tst_workbench.moc"
