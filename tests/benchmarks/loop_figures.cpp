// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/meshing_view.h"
#include "tests/benchmarks/measure/milling.h"
#include "tests/benchmarks/scenes/cutting_scene.h"
#include "tests/benchmarks/scenes/tool_paths.h"

#include <cerrno>
#include <cstdint>
#include <ctime>
#include <pthread.h>
#include <thread>

namespace burin::benchmarks {

namespace {

constexpr std::size_t ticks = 10'000, ticksAtOnce = 1000; // the other loops alternate with it
constexpr long period = 1'000'000;                        // ns
constexpr double periodMicroseconds = 1e-3 * period;

/// The times of each tick, µs: wall clock and processor time.
struct Spent {
    std::vector<double> wall = std::vector<double>(ticks), processor = std::vector<double>(ticks);
};

/// Calls `work(i)` at absolute times a period apart. @return  ticks that were not finished when the next one was due
template <class Work>
std::size_t atEachPeriod(std::size_t first, std::size_t count, const Work& work, Spent& spent) {
    std::size_t missed = 0;
    timespec due{};
    ::clock_gettime(CLOCK_MONOTONIC, &due);
    const auto later = [](timespec time) {
        time.tv_nsec += period;
        if (time.tv_nsec >= 1'000'000'000) {
            time.tv_nsec -= 1'000'000'000;
            ++time.tv_sec;
        }
        return time;
    };
    for (std::size_t i = first; i < first + count; ++i) {
        due = later(due);
        while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) == EINTR) {
        }
        const double processor = processorMicroseconds();
        const Clock::time_point start = Clock::now();
        work(i);
        spent.wall[i] = microseconds(Clock::now() - start);
        spent.processor[i] = processorMicroseconds() - processor;
        timespec now{};
        ::clock_gettime(CLOCK_MONOTONIC, &now);
        const double since =
            1e6 * static_cast<double>(now.tv_sec - due.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec - due.tv_nsec);
        if (since <= periodMicroseconds) continue;
        ++missed;
        due = now; // a late loop does not catch up lost time
    }
    return missed;
}

/// Prevents any tick from being the first to use a page of a new thread's stack.
void touchStack() {
    constexpr std::size_t bytes = 256 * 1024, page = 4096;
    volatile char stack[bytes]; // NOLINT: nothing but its pages is used
    for (std::size_t i = 0; i < bytes; i += page) stack[i] = 0;
    (void)stack[0];
}

/// A constant amount of arithmetic without memory access that takes about as long as a tick: any additional time was
/// taken by the machine.
void calculate() noexcept {
    std::uint64_t number = 1;
    for (int i = 0; i < 50'000; ++i) number = number * 6364136223846793005U + 1442695040888963407U;
    volatile std::uint64_t kept = number;
    (void)kept;
}

/// Runs in a thread of its own, with real-time priority if the system allows it.
struct Loop {
    Spent work, empty, steady;
    std::size_t missed = 0, missedEmpty = 0;
    bool realTime = false;
    bool cancelled = false;

    template <class Tick>
    void run(const Tick& tick) {
        sched_param priority{};
        priority.sched_priority = 60;
        realTime = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &priority) == 0;
        for (std::size_t first = 0; first < ticks && !cancelled; first += ticksAtOnce) {
            missed += atEachPeriod(first, ticksAtOnce, tick, work);
            missedEmpty += atEachPeriod(
                first, ticksAtOnce, [](std::size_t) {}, empty);
            (void)atEachPeriod(
                first, ticksAtOnce, [](std::size_t) { calculate(); }, steady);
            cancelled = Session::cancelled();
        }
    }
};

} // namespace

void loopFigures(Session& session) {
    const std::string name = "loop.r100.2048";
    if (!session.wants(name)) return;
    session.stage(name + " (30 s)");
    constexpr double side = 2048.0, radius = 100.0;
    RunVolume workpiece = halfBlock(static_cast<std::int32_t>(side));
    const std::vector<ToolPose> path = upright(walkFromAbove(side, radius, 1.0, ticks));
    MaterialRemoval removal(cutterOf(CutterType::ball, radius, fluteLengthFromAbove), workpiece.grid(),
                            Writing::deferred);
    const RunAmounts before = workpiece.amounts();
    RunAmounts removed;
    const auto count = [&](const CutResult& cut) {
        for (const MaterialVolume& material : cut.removed) removed.units[material.property] += material.units;
    };
    do count(removal.cut(workpiece, path.front(), path.front()));
    while (!removal.settled() && (count(removal.settle(workpiece)), true));
    count(removal.settle(workpiece));

    Loop loop;
    MeshingView view;
    TickWatch watch;
    std::thread thread([&] {
        touchStack();
        VolumeSnapshot waiting;
        bool offered = true;
        watch.begin();
        loop.run([&](std::size_t i) {
            count(removal.cut(workpiece, path[i], path[i + 1]));
            if (i % 16 == 0) {
                waiting = workpiece.snapshot();
                offered = false;
            }
            if (!offered && (offered = view.offer(waiting))) view.wake();
        });
        watch.end();
    });
    thread.join();
    view.finish();
    if (loop.cancelled) throw Cancelled();
    count(removal.settle(workpiece));
    removed.units[airProperty] = 0;
    std::size_t mismatches = 0;
    const RunAmounts recount = workpiece.snapshot().amounts();
    for (std::size_t i = 1; i < recount.units.size(); ++i)
        mismatches += before.units[i] - removed.units[i] == recount.units[i] ? 0U : 1U;
    session.countMismatches(mismatches);
    session.countInterruptions(watch.allocations(), watch.pageFaults());
    if (!loop.realTime)
        session.note("The system allows no real-time thread (SCHED_FIFO): loop figures are of a normal one.");

    // Raw times: of several rounds the quietest one is kept as a whole.
    const double worstButTen = percentile(loop.work.wall, 0.999);
    if (session.least(name, worstButTen) < worstButTen) return;
    const double beyond = static_cast<double>(loop.missed) - static_cast<double>(loop.missedEmpty);
    session.add(figure(name + ".p50", percentile(loop.work.wall, 0.5), "us"));
    session.add(figure(name + ".p999", worstButTen, "us", 200.0));
    session.add(figure(name + ".worst", percentile(loop.work.wall, 1.0), "us", 400.0));
    session.add(figure(name + ".cpu_p999", percentile(loop.work.processor, 0.999), "us", 200.0));
    session.add(figure(name + ".cpu_worst", percentile(loop.work.processor, 1.0), "us", 400.0));
    session.add(figure(name + ".steady_p50", percentile(loop.steady.wall, 0.5), "us"));
    session.add(figure(name + ".steady_p999", percentile(loop.steady.wall, 0.999), "us"));
    session.add(figure(name + ".steady_worst", percentile(loop.steady.wall, 1.0), "us"));
    session.add(against(figure(name + ".misses", static_cast<double>(loop.missed), "ticks"), "empty loop, in turn",
                        static_cast<double>(loop.missedEmpty)));
    session.add(figure(name + ".misses_beyond_empty", std::max(0.0, beyond), "ticks", 0.0));
    Figure pictures =
        figure(name + ".pictures_per_s", 1e3 * static_cast<double>(view.pictures().size()) / static_cast<double>(ticks),
               "1/s", 60.0);
    pictures.atLeast = true;
    session.add(std::move(pictures));
    session.add(figure(name + ".picture_p50", 1e-3 * percentile(view.pictures(), 0.5), "ms"));
    session.add(figure(name + ".picture_p99", 1e-3 * percentile(view.pictures(), 0.99), "ms", 10.0));
    session.add(figure(name + ".bricks_per_picture",
                       static_cast<double>(view.bricks()) /
                           static_cast<double>(std::max<std::size_t>(view.pictures().size(), 1)),
                       "1"));
    session.add(figure(name + ".real_time", loop.realTime ? 1.0 : 0.0, "1"));
}

} // namespace burin::benchmarks
