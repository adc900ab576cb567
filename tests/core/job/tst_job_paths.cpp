// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/job_paths.h"
#include "tests/core/document/sample_project.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_job_paths {

namespace {

/// A take of some tool, complete. @return its id
std::int64_t record(Project& project, const char* toolId) {
    TakeInfo info = fixture::takeInfo("take");
    info.toolId = toolId;
    auto writer = project.beginTake(info);
    if (!writer || !writer->append(fixture::handSamples(0, 20)) || !writer->finish()) return 0;
    return writer->id();
}

std::vector<std::int64_t> takesIn(const Result<std::vector<StoredPath>>& paths, std::size_t place) {
    return paths && place < paths->size() ? takesOf((*paths)[place].sources) : std::vector<std::int64_t>{};
}

} // namespace

class TestJobPaths : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        Result<Project> made = Project::create(folder_->filePath("p.burin").toStdString());
        QVERIFY(made);
        project_.emplace(std::move(*made));
    }

    void aJobWithoutRecordingsHasNone() {
        QCOMPARE(jobPaths(*project_).error().code, ErrorCode::projectIncomplete);
        QCOMPARE(standardPath(*project_, "ball-6").error().code, ErrorCode::projectIncomplete);
    }

    void eachToolThatMilledGetsAPathOfItsOwn() {
        const std::int64_t first = record(*project_, "flat-10"), second = record(*project_, "ball-6"),
                           third = record(*project_, "flat-10");
        QVERIFY(first != 0 && second != 0 && third != 0);
        const auto paths = jobPaths(*project_);
        QVERIFY(paths);
        QCOMPARE(paths->size(), std::size_t{2});
        QCOMPARE(takesIn(paths, 0), (std::vector{first, third}));
        QCOMPARE(takesIn(paths, 1), std::vector{second});
        QCOMPARE(project_->paths()->size(), std::size_t{2}); // kept
        const auto again = jobPaths(*project_);
        QVERIFY(again && (*again)[0].id == (*paths)[0].id && (*again)[1].id == (*paths)[1].id);
        QCOMPARE(project_->paths()->size(), std::size_t{2});
    }

    void theFirstPathOfAToolIsTheJobs() {
        const std::int64_t take = record(*project_, "ball-6");
        StoredPath one = *standardPath(*project_, "ball-6"), variant = one;
        one.id = *project_->addPath(one);
        variant.id = *project_->addPath(variant);
        const auto takes = *project_->takes();
        const std::vector<SourceInfo> sources = sourcesOf(takes, {});
        const auto all = *project_->paths();
        QCOMPARE(toolOf(one, sources), std::string("ball-6"));
        QVERIFY(isFirstOfItsTool(one, all, sources) && !isFirstOfItsTool(variant, all, sources));
        const auto paths = jobPaths(*project_);
        QVERIFY(paths && paths->size() == 1 && paths->front().id == one.id &&
                paths->front().sources.front() == PathSource{take});
    }

    /// A job has a single order, whoever requests it: larger tools first, equal ones in the order in which they first
    /// milled, whenever their paths were made.
    void theOrderOfMillingIsOne() {
        const std::int64_t small = record(*project_, "ball-6"), one = record(*project_, "flat-10"),
                           other = record(*project_, "ball-10");
        for (const char* tool : {"ball-10", "ball-6", "flat-10"})
            QVERIFY(project_->addPath(*standardPath(*project_, tool)));
        const auto takes = *project_->takes();
        const std::vector<SourceInfo> sources = sourcesOf(takes, {});
        std::vector<Tool> tools;
        for (const char* id : {"ball-10", "flat-10", "ball-6"}) tools.push_back(*loadTool(id));
        const auto inOrder = [&](const std::vector<StoredPath>& paths) {
            std::vector<std::int64_t> first;
            for (const StoredPath& path : inMillingOrder(paths, sources, toolsOf(sources), tools))
                first.push_back(path.sources.front().id);
            return first;
        };
        const std::vector wanted{one, other, small};
        QCOMPARE(inOrder(*project_->paths()), wanted);
        QCOMPARE(inOrder(*jobPaths(*project_)), wanted);
        // A tool that is no longer in the list comes last.
        tools.erase(tools.begin());
        QCOMPARE(inOrder(*project_->paths()), (std::vector{one, small, other}));
    }

    /// Takes that the user left out stay out; those recorded later are included.
    void aPathTakesNewerRecordingsOfItsToolAlone() {
        const std::int64_t left = record(*project_, "ball-6"), used = record(*project_, "ball-6");
        StoredPath path;
        path.sources = {{used}};
        record(*project_, "flat-10");
        const std::int64_t newer = record(*project_, "ball-6");
        addNewerTakes(path, *sourcesOf(*project_));
        QCOMPARE(takesOf(path.sources), (std::vector{used, newer}));
        QVERIFY(std::ranges::find(path.sources, PathSource{left}) == path.sources.end());
    }

    /// A take whose strokes were all undone mills nothing: its tool does not belong to the job, and no other tool's
    /// path is changed by it. Redone, it is included again.
    void aTakeThatWasTakenBackIsNone() {
        const std::int64_t stands = record(*project_, "ball-6"), gone = record(*project_, "flat-10");
        const SampleRange all{0, 20};
        QVERIFY(project_->undoInterval(gone, all));
        const auto standing = standingTakes(*project_);
        QVERIFY(standing && standing->size() == 1 && standing->front().id == stands);
        QCOMPARE(standardPath(*project_, "flat-10").error().code, ErrorCode::projectIncomplete);
        const auto paths = jobPaths(*project_);
        QVERIFY(paths && paths->size() == 1);
        QCOMPARE(takesIn(paths, 0), std::vector{stands});
        QVERIFY(project_->redoInterval(gone, all));
        QCOMPARE(jobPaths(*project_)->size(), std::size_t{2});
        QVERIFY(project_->undoInterval(gone, {0, 5})); // part of it
        QCOMPARE(standingTakes(*project_)->size(), std::size_t{2});
        QVERIFY(project_->undoInterval(stands, all) && project_->undoInterval(gone, {5, 15}));
        QCOMPARE(jobPaths(*project_).error().code, ErrorCode::projectIncomplete);
    }

    void cleanup() { project_.reset(); }

private:
    std::unique_ptr<QTemporaryDir> folder_;
    std::optional<Project> project_;
};

BURIN_TEST(TestJobPaths, QCoreApplication)

} // namespace burin::tst_job_paths

#include "tst_job_paths.moc"
