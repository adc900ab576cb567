// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/recorded_cuts.h"
#include "tests/core/document/processes.h"
#include "tests/core/job/session_stage.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <new>
#include <sys/mman.h>

namespace burin::tst_session_faults {

using namespace burin::test;
namespace fs = std::filesystem;

namespace {

using namespace std::chrono_literals;

fs::path fileIn(const QTemporaryDir& folder) {
    return folder.filePath("p.burin").toStdString();
}

/// State that the milling child reports to the parent that kills it, in shared memory.
struct Telling {
    std::atomic<double> seconds{0.0}; ///< of the recording, as reported by the session
    std::atomic<int> undone{0};
};

/// Mills until it is killed; undoes a stroke on the way.
[[noreturn]] void millForEver(const fs::path& file, Telling& telling) {
    Stage stage(file);
    const auto session = stage.begin(handRequest());
    if (!session || !session->startRecording("killed")) ::_exit(1);
    stage.hand.mill(1000);
    for (SessionState state;;) {
        if (session->newest(state)) telling.seconds = state.recordedSeconds;
        if (stage.strokes.count() == 2 && telling.undone == 0 && session->undoStroke()) telling.undone = 1;
        std::this_thread::sleep_for(1ms);
    }
}

/// Kills a milling child once it recorded for so long. @return s that it had reported
double killAfter(const fs::path& file, double seconds, Telling& telling) {
    new (&telling) Telling;
    const pid_t child = ::fork();
    if (child == 0) millForEver(file, telling);
    const bool reached = await([&] { return telling.seconds >= seconds && telling.undone == 1; });
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    return reached ? telling.seconds.load() : -1.0;
}

} // namespace

/// Sessions that end with a fault. Each runs in a process of its own, started while this one has no other thread.
class TestSessionFaults : public QObject {
    Q_OBJECT
private slots:
    /// A disk that refuses writes ends the session with its error; everything recorded until then is kept.
    void aFullDiskEndsTheSession() {
        BURIN_SKIP_WHERE_FORKED_CHILDREN_HAVE_NO_THREADS();
        const QTemporaryDir folder;
        const int outcome = fixture::inAnotherProcess([&] {
            Stage stage(fileIn(folder));
            const auto session = stage.begin(handRequest());
            if (!session->startRecording("full") || !millStrokes(stage, *session, 2)) return 2;
            fixture::limitFileSize(200 * 1024);
            stage.hand.mill(1000);
            SessionState state;
            if (!await([&] { return session->newest(state), session->ended(); })) return 3;
            const Result<LoopStatistics> end = session->end();
            return !end && end.error().code == ErrorCode::diskFull ? 0 : 4;
        });
        QCOMPARE(outcome, 0);
        Result<Project> project = Project::open(fileIn(folder));
        QVERIFY(project);
        const Result<Take> take = project->take(1);
        QVERIFY(take && !take->info.complete && contiguous(*take));
        QVERIFY(take->samples.size() > 100);
    }

    /// Killed in the middle of a session with strokes, one undone: no more than the last 100 ms are missing.
    void aKillCostsAtMostTheLastTenthOfASecond() {
        BURIN_SKIP_WHERE_FORKED_CHILDREN_HAVE_NO_THREADS();
        void* const memory =
            ::mmap(nullptr, sizeof(Telling), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        QVERIFY(memory != MAP_FAILED);
        const QTemporaryDir folder;
        std::vector<Take> takes;
        fs::path file;
        double worst = 0.0;
        for (const double moment : {0.35, 0.8, 1.3}) {
            double missing = 1.0;
            // A machine that stalls the disk or the thread for so long is no fault of ours; three times in a row it is.
            for (int attempt = 0; attempt < 3 && missing > 0.1; ++attempt) {
                file = folder.filePath(QString("%1-%2.burin").arg(moment).arg(attempt)).toStdString();
                const double told = killAfter(file, moment, *static_cast<Telling*>(memory));
                QVERIFY(told >= moment);
                Result<Project> project = Project::open(file);
                QVERIFY(project && project->recovered());
                const Result<Take> take = project->take(project->takes()->front().id);
                QVERIFY(take && !take->info.complete && contiguous(*take));
                QCOMPARE(take->undone.size(), std::size_t{1});
                missing = told - take->samples.back().time;
                takes.push_back(*take);
            }
            worst = std::max(worst, missing);
        }
        ::munmap(memory, sizeof(Telling));
        qInfo("at most %.0f ms missing", worst * 1e3);
        QVERIFY(worst <= 0.1);
        // The work continues where it was left: with the strokes in effect, without the undone one.
        for (const Take& take : takes) {
            MillingContext milling = blockMilling();
            const RunVolume& workpiece = milling.embedded.workpiece;
            const std::uint64_t whole = workpiece.amounts().units[milling.embedded.stockProperty];
            QVERIFY(replayTake(take, sessionTool(), milling, Progress()));
            QCOMPARE(whole - workpiece.amounts().units[milling.embedded.stockProperty], removedUnits(take));
        }
    }
};

BURIN_TEST(TestSessionFaults, NoApplication)

} // namespace burin::tst_session_faults

#include "tst_session_faults.moc"
