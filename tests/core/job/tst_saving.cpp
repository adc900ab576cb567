// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/job/recorder.h"
#include "tests/core/document/processes.h"
#include "tests/core/document/sample_project.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>
#include <chrono>
#include <filesystem>
#include <random>
#include <thread>

namespace burin::tst_saving {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using fixture::modelNamed, fixture::nameIn;

namespace {

enum Outcome : int { saved = 0, fullDisk = 1, noRights = 2, other = 3 };

Outcome outcomeOf(const Result<void>& result) {
    if (result) return saved;
    if (result.error().code == ErrorCode::diskFull) return fullDisk;
    return result.error().code == ErrorCode::fileNotWritable ? noRights : other;
}

/// A saved project whose model is "old", closed again.
fs::path savedProject(const QTemporaryDir& folder) {
    fs::path file = folder.filePath("p.burin").toStdString();
    Result<Project> project = Project::create(file);
    if (!project || !project->setModel(modelNamed("old")) || !project->save()) return {};
    return file;
}

std::size_t filesIn(const QTemporaryDir& folder) {
    return static_cast<std::size_t>(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size());
}

} // namespace

class TestSaving : public QObject {
    Q_OBJECT
private slots:
    void leavesOneFileBehind() {
        const QTemporaryDir folder;
        QVERIFY(!savedProject(folder).empty());
        QCOMPARE(filesIn(folder), std::size_t{1});
    }

    void aFileCanBeReadWithoutTheRightToWriteBesideIt() {
        const QTemporaryDir folder;
        const fs::path file = savedProject(folder);
        const std::string content = *readFile(file);
        // Bytes 18 and 19 of an SQLite file are 1, so that reading needs no journal file.
        QCOMPARE(content.substr(18, 2), std::string("\1\1"));
        const int outcome = fixture::inAnotherProcess([&] {
            fixture::loseRights(folder.path().toLocal8Bit().constData());
            ::chmod(folder.path().toLocal8Bit().constData(), 0555);
            Result<Project> project = Project::open(file);
            if (!project) return 10 + static_cast<int>(project.error().code);
            if (!project->readOnly() || nameIn(*project) != "old") return 4;
            if (outcomeOf(project->setModel(modelNamed("new"))) != noRights) return 5;
            if (outcomeOf(project->save()) != noRights) return 6;
            return project->beginTake(fixture::takeInfo("t")) ? 7 : 0;
        });
        QCOMPARE(outcome, 0);
        QCOMPARE(*readFile(file), content);
        QCOMPARE(filesIn(folder), std::size_t{1});
    }

    void keepsTheOldFileWhenTheFolderIsProtected() {
        const QTemporaryDir folder;
        const fs::path file = savedProject(folder);
        const std::string content = *readFile(file);
        const QByteArray place = folder.path().toLocal8Bit();
        const int outcome = fixture::inAnotherProcess([&] {
            fixture::loseRights(place.constData());
            Result<Project> project = Project::open(file);
            if (!project || !project->setModel(modelNamed("new"))) return 4;
            ::chmod(place.constData(), 0555);
            const Outcome result = outcomeOf(project->save());
            ::chmod(place.constData(), 0755);
            return static_cast<int>(result);
        });
        QCOMPARE(outcome, int{noRights});
        QCOMPARE(*readFile(file), content);
        Result<Project> again = Project::open(file);
        QVERIFY(again && again->recovered());
        QCOMPARE(nameIn(*again), std::string("new"));
    }

    /// The disk becomes full at every point of a save in turn, until one save fits.
    void keepsTheOldFileWhereverTheDiskIsFull() {
        const QTemporaryDir folder;
        const fs::path file = savedProject(folder);
        const std::string content = *readFile(file);
        int failures = 0;
        for (rlim_t allowed = 0;; allowed += 4096, ++failures) {
            const int outcome = fixture::inAnotherProcess([&] {
                Result<Project> project = Project::open(file);
                if (!project || (nameIn(*project) != "new" && !project->setModel(modelNamed("new")))) return int{other};
                fixture::limitFileSize(allowed);
                return static_cast<int>(outcomeOf(project->save()));
            });
            if (outcome == saved) break;
            QCOMPARE(outcome, int{fullDisk});
            QCOMPARE(*readFile(file), content);
        }
        QVERIFY(failures > 10);
        Result<Project> again = Project::open(file);
        QVERIFY(again);
        QCOMPARE(nameIn(*again), std::string("new"));
        QCOMPARE(filesIn(folder), std::size_t{1 + 2 + 2}); // file; copy and its journal; lock
    }

    /// Kills a program that saves continuously, at random moments.
    void aKillWhileSavingLosesNothing() {
        const QTemporaryDir folder;
        const fs::path file = savedProject(folder);
        std::mt19937 random(7);
        int last = 0;
        for (int kill = 0; kill < 25; ++kill) {
            const unsigned moment = std::uniform_int_distribution<unsigned>(1000, 60000)(random);
            fixture::killedAfter(moment, [&] {
                Result<Project> project = Project::open(file);
                for (int i = last + 1; project && i < last + 1000; ++i)
                    if (!project->setModel(modelNamed(std::to_string(i))) || !project->save()) return 1;
                return 0;
            });
            Result<Project> project = Project::open(file);
            QVERIFY(project);
            QVERIFY(project->keptAside().empty());
            const std::string name = nameIn(*project);
            QVERIFY(name == "old" ? last == 0 : std::stoi(name) >= last);
            if (name != "old") last = std::stoi(name);
            Model expected = modelNamed(name);
            QVERIFY(fixture::identical(*project->model(), expected));
        }
        QVERIFY(last > 0);
    }

    void aRecordingGoesOnWhileTheProjectIsSaved() {
        const QTemporaryDir folder;
        const fs::path file = savedProject(folder);
        Result<Project> project = Project::open(file);
        QVERIFY(project);
        Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("meanwhile"));
        QVERIFY(writer);
        const std::vector<Sample> hand = fixture::handSamples(0, 40000);
        Ring<Sample> ring(hand.size());
        Recorder recorder(ring, std::move(*writer));
        for (std::size_t i = 0; i < hand.size(); ++i) {
            QVERIFY(ring.push(hand[i]));
            if (i % 10000 == 0) QVERIFY(project->save());
        }
        QVERIFY(recorder.finish());
        QVERIFY(*project->unsaved());
        QVERIFY(project->save());
        QVERIFY(!*project->unsaved());
        QVERIFY(fixture::identical(project->take(recorder.take())->samples, hand));
    }

    /// A full disk stops nothing for good: the hand's samples wait and are written once there is room.
    void aFullDiskPausesARecording() {
        BURIN_SKIP_WHERE_FORKED_CHILDREN_HAVE_NO_THREADS();
        const QTemporaryDir folder;
        const fs::path file = savedProject(folder);
        const std::vector<Sample> hand = fixture::handSamples(0, 20000);
        const int outcome = fixture::inAnotherProcess([&] {
            Result<Project> project = Project::open(file);
            if (!project) return 2;
            Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("full"));
            if (!writer) return 3;
            Ring<Sample> ring(hand.size());
            fixture::limitFileSize(100 * 1024);
            Recorder recorder(ring, std::move(*writer));
            for (const Sample& sample : hand) ring.push(sample);
            while (!recorder.failing()) std::this_thread::sleep_for(1ms);
            fixture::limitFileSize(RLIM_INFINITY);
            const Result<std::uint64_t> kept = recorder.finish();
            return kept && *kept == hand.size() && !recorder.failing() ? 0 : 4;
        });
        QCOMPARE(outcome, 0);
        Result<Project> again = Project::open(file);
        QVERIFY(again);
        QVERIFY(fixture::identical(again->take(again->takes()->back().id)->samples, hand));
    }

    void aFullDiskAtTheEndIsReported() {
        BURIN_SKIP_WHERE_FORKED_CHILDREN_HAVE_NO_THREADS();
        const QTemporaryDir folder;
        const fs::path file = savedProject(folder);
        const int outcome = fixture::inAnotherProcess([&] {
            Result<Project> project = Project::open(file);
            Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("full"));
            const std::vector<Sample> hand = fixture::handSamples(0, 20000);
            Ring<Sample> ring(hand.size());
            fixture::limitFileSize(100 * 1024);
            Recorder recorder(ring, std::move(*writer));
            for (const Sample& sample : hand) ring.push(sample);
            const Result<std::uint64_t> kept = recorder.finish();
            return static_cast<int>(kept ? saved : outcomeOf(kept.error()));
        });
        QCOMPARE(outcome, int{fullDisk});
        Result<Project> again = Project::open(file);
        QVERIFY(again);
        QCOMPARE(nameIn(*again), std::string("old"));
        QVERIFY(!again->takes()->back().complete);
    }

    void aRemovedRecordingFreesItsSpace() {
        const QTemporaryDir folder;
        const fs::path file = savedProject(folder);
        const auto sizeBefore = fs::file_size(file);
        Result<Project> project = Project::open(file);
        QVERIFY(project);
        const std::size_t others = project->takes()->size();
        Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("long"));
        QVERIFY(writer && writer->append(fixture::handSamples(0, 20000)) && writer->finish());
        QVERIFY(project->save());
        QVERIFY(fs::file_size(file) > 4 * sizeBefore);
        const std::int64_t take = writer->id();
        {
            const Project::TakeWriter gone = std::move(*writer); // it has a connection of its own
            QVERIFY(project->removeTake(take) && project->takes()->size() == others);
            QVERIFY(!project->take(take) && !project->visitSamples(take, {}));
            QVERIFY(project->restoreTake(take) && project->takes()->size() == others + 1 && project->take(take));
            QVERIFY(!project->restoreTake(take));
            QVERIFY(project->removeTake(take) && project->save());
        }
        // As long as the project is open the take can be restored.
        project = Error{ErrorCode::internalFault, {}, {}, {}};
        Result<Project> again = Project::open(file);
        QVERIFY(again && !again->restoreTake(take) && !*again->unsaved());
        QVERIFY(again->save());
        QVERIFY(fs::file_size(file) <= sizeBefore + 4096);
    }

    void theRightsOfTheFileStay() {
        const QTemporaryDir folder;
        const fs::path file = savedProject(folder);
        fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
        Result<Project> project = Project::open(file);
        QVERIFY(project && project->setModel(modelNamed("new")) && project->save());
        QCOMPARE(fs::status(file).permissions(),
                 fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
    }
};

BURIN_TEST(TestSaving, NoApplication)

} // namespace burin::tst_saving

#include "tst_saving.moc"
