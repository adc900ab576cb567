// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/recorder.h"
#include "tests/core/document/processes.h"
#include "tests/core/document/sample_project.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <new>
#include <random>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace burin::tst_recorder {

namespace fs = std::filesystem;

namespace {

using namespace std::chrono_literals;

/// State that the recording child reports to the parent that kills it, in shared memory.
struct Telling {
    std::atomic<std::uint64_t> pushed{0}; ///< samples made by the hand
    std::atomic<std::uint64_t> kept{0};   ///< samples that the recorder reports as safe
    std::atomic<bool> failed{false};
};

class SharedTelling {
public:
    SharedTelling()
        : memory_(::mmap(nullptr, sizeof(Telling), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
        , telling_(new (memory_) Telling) {}
    ~SharedTelling() { ::munmap(memory_, sizeof(Telling)); }
    SharedTelling(const SharedTelling&) = delete;
    SharedTelling& operator=(const SharedTelling&) = delete;
    Telling& operator*() const { return *telling_; }

private:
    void* memory_;
    Telling* telling_;
};

/// Records at 1 kHz of wall time until it is killed.
[[noreturn]] void recordForEver(const fs::path& file, Telling& telling) {
    Result<Project> project = Project::create(file);
    Result<Project::TakeWriter> writer =
        project ? project->beginTake(fixture::takeInfo("killed")) : Result<Project::TakeWriter>(project.error());
    if (!writer) {
        telling.failed = true;
        ::_exit(1);
    }
    Ring<Sample> ring(1 << 16);
    Recorder recorder(ring, std::move(*writer));
    const std::vector<Sample> hand = fixture::handSamples(0, 4000);
    auto next = std::chrono::steady_clock::now();
    for (const Sample& sample : hand) {
        next += 1ms;
        std::this_thread::sleep_until(next);
        if (!ring.push(sample)) telling.failed = true;
        telling.pushed.fetch_add(1, std::memory_order_release);
        telling.kept.store(recorder.kept(), std::memory_order_release);
    }
    for (;;) ::pause();
}

struct Killed {
    std::uint64_t pushed = 0, kept = 0;
    bool failed = false;
};

/// Starts a recording in a child and kills it once it made `samples` samples.
Killed killAfter(const fs::path& file, std::uint64_t samples) {
    const SharedTelling shared;
    Telling& telling = *shared;
    const pid_t child = ::fork();
    if (child == 0) recordForEver(file, telling);
    bool ended = false; // ended on its own, as a sanitizer ends a process
    while (telling.pushed.load(std::memory_order_acquire) < samples && !telling.failed && !ended) {
        std::this_thread::sleep_for(500us);
        ended = ::waitpid(child, nullptr, WNOHANG) != 0;
    }
    Killed result;
    if (!ended) {
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
    }
    result.kept = telling.kept.load(std::memory_order_acquire);
    result.pushed = telling.pushed.load(std::memory_order_acquire);
    result.failed = telling.failed || ended;
    return result;
}

fs::path fileIn(const QTemporaryDir& folder, const char* name) {
    return folder.filePath(name).toStdString();
}

} // namespace

class TestRecorder : public QObject {
    Q_OBJECT
private slots:
    void keepsEverythingThatWasPushed() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder, "p.burin"));
        QVERIFY(project);
        Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("fast"));
        QVERIFY(writer);
        const std::int64_t id = writer->id();
        const std::vector<Sample> hand = fixture::handSamples(0, 50000);
        Ring<Sample> ring(4096); // far smaller than the recording
        Recorder recorder(ring, std::move(*writer));
        QCOMPARE(recorder.take(), id);
        for (const Sample& sample : hand)
            while (!ring.push(sample)) std::this_thread::sleep_for(1ms);
        const Result<std::uint64_t> kept = recorder.finish();
        QVERIFY(kept);
        QCOMPARE(*kept, hand.size());
        QVERIFY(!recorder.failing());
        const Result<Take> take = project->take(id);
        QVERIFY(take);
        QVERIFY(take->info.complete);
        QVERIFY(fixture::identical(take->samples, hand));
    }

    /// A kill at any moment costs at most the last 100 ms, and never a sample that the recorder reported as kept.
    void aKillCostsAtMostTheLastTenthOfASecond() {
        BURIN_SKIP_WHERE_FORKED_CHILDREN_HAVE_NO_THREADS();
        const QTemporaryDir folder;
        std::mt19937 random(20261121);
        std::uint64_t worst = 0;
        for (int kill = 0; kill < 12; ++kill) {
            const std::uint64_t moment = std::uniform_int_distribution<std::uint64_t>(1, 700)(random);
            std::uint64_t missing = 0;
            // A machine that stalls the disk or the thread for so long is no fault of ours; three times in a row it is.
            for (int attempt = 0; attempt < 3; ++attempt) {
                const fs::path file = fileIn(folder, ("k" + std::to_string(10 * kill + attempt)).c_str());
                const Killed killed = killAfter(file, moment);
                QVERIFY(!killed.failed);
                Result<Project> project = Project::open(file);
                QVERIFY(project);
                QVERIFY(project->recovered());
                const Result<std::vector<TakeInfo>> takes = project->takes();
                QVERIFY(takes && takes->size() == 1);
                QVERIFY(!takes->front().complete);
                const Result<Take> take = project->take(takes->front().id);
                QVERIFY(take);
                QVERIFY(take->samples.size() >= killed.kept);
                QVERIFY(fixture::identical(take->samples, fixture::handSamples(0, take->samples.size())));
                missing = killed.pushed - std::min<std::uint64_t>(killed.pushed, take->samples.size());
                if (missing <= 100) break;
            }
            worst = std::max(worst, missing);
        }
        qInfo("at most %llu ms missing", static_cast<unsigned long long>(worst));
        QVERIFY(worst <= 100);
    }

    void aWriterThatStopsEarlyLeavesAnIncompleteTake() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder, "p.burin"));
        QVERIFY(project);
        {
            Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("broken off"));
            QVERIFY(writer && writer->append(fixture::handSamples(0, 50)));
        }
        const Result<std::vector<TakeInfo>> takes = project->takes();
        QVERIFY(takes);
        QVERIFY(!takes->front().complete);
        QCOMPARE(takes->front().sampleCount, std::uint64_t{50});
    }
};

BURIN_TEST(TestRecorder, NoApplication)

} // namespace burin::tst_recorder

#include "tst_recorder.moc"
