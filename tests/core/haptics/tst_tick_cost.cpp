// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/loop_figures.h"
#include "core/haptics/loop/servo_tick.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/oracles/system_watch.h"
#include "tests/test_program.h"

#include <QtTest>

#include <chrono>
#include <mutex>
#include <semaphore.h>
#include <shared_mutex>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

namespace burin::tst_tick_cost {

using namespace burin::test;
using burin::tests::SystemUse;
using burin::tests::SystemWatch;

namespace {

/// Prevents the compiler from removing the allocation.
template <class T>
T* kept(T* pointer) {
    asm volatile("" : "+r"(pointer) : : "memory");
    return pointer;
}

template <class Work>
SystemUse costOf(SystemWatch& watch, Work&& work) {
    watch.begin();
    work();
    return watch.end();
}

} // namespace

/// A tick makes no allocations, locks or system calls, and the hook would report them.
class TestTickCost : public QObject {
    Q_OBJECT
private slots:
    void init() {
        if (!SystemWatch().counts()) QSKIP("neither this kernel nor a build with sanitizers can count");
    }

    void everyWayToAllocateCounts() {
        SystemWatch watch;
        const SystemUse cost = costOf(watch, [] {
            std::free(kept(std::malloc(8)));
            std::free(kept(std::realloc(kept(std::calloc(2, 4)), 64)));
            std::free(kept(std::aligned_alloc(64, 64)));
            delete kept(new int(1));
            ::operator delete(kept(static_cast<char*>(::operator new(64, std::align_val_t(64)))), std::align_val_t(64));
        });
        QCOMPARE(cost.allocations, std::uint64_t{6});
        QCOMPARE(cost.releases, std::uint64_t{5}); // realloc took over one of them
        QCOMPARE(cost.locks, std::uint64_t{0});
    }

    void everyWayToLockCounts() {
        SystemWatch watch;
        std::mutex mutex;
        std::shared_mutex shared;
        sem_t semaphore;
        QCOMPARE(sem_init(&semaphore, 0, 1), 0);
        const SystemUse cost = costOf(watch, [&] {
            { const std::lock_guard lock(mutex); }
            if (mutex.try_lock()) mutex.unlock();
            { const std::lock_guard lock(shared); }
            { const std::shared_lock lock(shared); }
            sem_wait(&semaphore);
        });
        QCOMPARE(cost.locks, std::uint64_t{5});
        QCOMPARE(cost.allocations, std::uint64_t{0});
    }

    /// The hooked functions still work, with all their arguments.
    void everySystemCallCounts() {
        SystemWatch watch;
        std::array<int, 2> ends{};
        QCOMPARE(pipe(ends.data()), 0);
        std::array<char, 4> read{};
        long process = 0;
        ssize_t written = 0, got = 0;
        void* pages = nullptr;
        const SystemUse cost = costOf(watch, [&] {
            process = syscall(SYS_getpid);
            written = ::write(ends[1], "abc", 3);
            got = ::read(ends[0], read.data(), read.size());
            pages = mmap(nullptr, 8192, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        });
        QCOMPARE(cost.systemCalls, std::uint64_t{4});
        QCOMPARE(process, long{getpid()});
        QCOMPARE(written, ssize_t{3});
        QCOMPARE(got, ssize_t{3});
        QCOMPARE(std::string(read.data()), std::string("abc"));
        QVERIFY(pages != MAP_FAILED);
        const SystemUse touched = costOf(watch, [&] { *kept(static_cast<char*>(pages)) = 1; });
        QCOMPARE(touched.pageFaults, std::uint64_t{1});
        QCOMPARE(touched.systemCalls, std::uint64_t{0});
        const SystemUse failed = costOf(watch, [&] { written = ::write(-1, "a", 1); });
        QCOMPARE(failed.systemCalls, std::uint64_t{1});
        QCOMPARE(written, ssize_t{-1});
        munmap(pages, 8192);
        for (const int end : ends) close(end);
    }

    /// Calls of another thread, and calls before and after, are not counted.
    void onlyTheWatchedIntervalCounts() {
        SystemWatch watch;
        std::free(kept(std::malloc(8)));
        const SystemUse cost = costOf(watch, [] {});
        std::free(kept(std::malloc(8)));
        QCOMPARE(cost.allocations + cost.releases + cost.locks + cost.systemCalls, std::uint64_t{0});
    }

    /// Covers gaps, heartbeat, timing, figures and a late force as well.
    void whatTheLoopAddsAsksNothingEither() {
        struct Figures final : TickSink {
            AtEdge edge() noexcept override { return AtEdge::tick; }
            void tick(const Sample&, const TickTiming& timing) noexcept override { figures.add(timing); }
            LoopFigures figures;
        };
        SystemWatch watch;
        Rig rig;
        const auto sink = std::make_unique<Figures>();
        const auto tick = std::make_unique<ServoTick>(rig.step, *sink, period, true);
        SystemUse sum;
        for (int i = 0; i < 600; ++i) {
            StylusState state;
            state.pose.position = {0.0, 0.0, 2.0 - 0.03 * i};
            state.valid = i != 300;
            if (i == 400) std::this_thread::sleep_for(std::chrono::milliseconds(5));
            watch.begin();
            if (tick->edge() != AtEdge::tick) QFAIL("no tick");
            tick->begin();
            static_cast<void>(tick->serve(state, period));
            tick->sent();
            const SystemUse cost = watch.end();
            sum.allocations += cost.allocations + cost.releases;
            sum.locks += cost.locks;
            sum.systemCalls += cost.systemCalls;
        }
        QVERIFY(tick->timing().late > 0);
        QCOMPARE(sum.allocations, std::uint64_t{0});
        QCOMPARE(sum.locks, std::uint64_t{0});
        QCOMPARE(sum.systemCalls, std::uint64_t{0});
    }

    void aTickAsksNothingOfTheSystem_data() {
        QTest::addColumn<double>("fluteLength");
        QTest::addColumn<int>("happens"); // SampleFlag
        QTest::newRow("pressed on the part") << 20.0 << int(sampleOnBoundary);
        QTest::newRow("stopped by its shank") << 5.0 << int(sampleShankContact);
    }
    void aTickAsksNothingOfTheSystem() {
        QFETCH(double, fluteLength);
        QFETCH(int, happens);
        SystemWatch watch;
        Rig rig(Rig::settings(), ballTool(fluteLength, fluteLength < 10.0 ? 12.0 : 6.0));
        rig.begin({-12, 0, 2});
        std::uint64_t cut = 0, happened = 0, faults = 0;
        SystemUse sum;
        const auto go = [&](const glm::dvec3& target, double speed) {
            const auto count = static_cast<int>(std::ceil(glm::length(target - rig.hand) / (speed * period)));
            const glm::dvec3 from = std::exchange(rig.hand, target);
            for (int i = 1; i <= count; ++i) {
                StylusState state;
                state.pose.position = glm::mix(from, target, static_cast<double>(i) / count);
                state.valid = i != 7; // including a fault
                watch.begin();
                const Sample sample = rig.step.advance(state, i == 9 ? 0.005 : period); // including one that is late
                const SystemUse cost = watch.end();
                sum.allocations += cost.allocations + cost.releases;
                sum.locks += cost.locks;
                sum.systemCalls += cost.systemCalls;
                cut += sample.removed[0].units > 0 ? 1u : 0u;
                faults += (sample.flags & sampleStylusInvalid) != 0 ? 1u : 0u;
                happened += (sample.flags & static_cast<std::uint32_t>(happens)) != 0 ? 1u : 0u;
            }
        };
        go({-12, 0, -4}, 30.0);
        go({12, 3, -4}, 40.0);
        go({10, -3, -14}, 40.0);
        rig.step.setAllowance(0.3);
        go({-12, -3, -14}, 60.0);
        go({-12, -3, 5}, 60.0);
        QVERIFY(cut > 100 && happened > 50 && faults == 5); // otherwise nothing was measured
        QCOMPARE(sum.allocations, std::uint64_t{0});
        QCOMPARE(sum.locks, std::uint64_t{0});
        QCOMPARE(sum.systemCalls, std::uint64_t{0});
    }
};

BURIN_TEST(TestTickCost, NoApplication)

} // namespace burin::tst_tick_cost

#include "tst_tick_cost.moc"
