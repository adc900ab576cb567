// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/scale/scale.h"

#include "tests/benchmarks/scale/exponent.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <limits>
#include <malloc.h>

namespace burin::benchmarks {

namespace {

constexpr int runs = 3, sizes = 3;

/// CPU time of all threads, s.
double cpuTime() {
    timespec spent{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
    return static_cast<double>(spent.tv_sec) + 1e-9 * static_cast<double>(spent.tv_nsec);
}

/// The value of a line of /proc/self/status (proc(5)), B.
double statusBytes(const std::string& line) {
    std::ifstream status("/proc/self/status");
    for (std::string name; status >> name;) {
        double kibibytes = 0.0;
        if (name == line && status >> kibibytes) return 1024.0 * kibibytes;
        status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return 0.0;
}

struct Cost {
    double cpu = std::numeric_limits<double>::infinity();  ///< s
    double peak = std::numeric_limits<double>::infinity(); ///< B
};

Cost costOf(const ScaledWork& work, int step) {
    Cost least;
    for (int run = 0; run < runs; ++run) {
        Session::throwIfCancelled();
        if (work.prepare) work.prepare(step);
        malloc_trim(0);                              // memory left by earlier works would hide what this one takes
        std::ofstream("/proc/self/clear_refs") << 5; // resets the peak resident size
        const double before = statusBytes("VmRSS:"), start = cpuTime();
        work.work(step);
        least.cpu = std::min(least.cpu, cpuTime() - start);
        least.peak = std::min(least.peak, std::max(statusBytes("VmHWM:") - before, 0.0));
    }
    return least;
}

} // namespace

void scaleFigures(Session& session, const ScaledWork& work) {
    const std::string name = "scale." + work.name;
    if (!session.wants(name)) return;
    std::array<double, sizes> size{}, cpu{};
    for (int step = 0; step < sizes; ++step) {
        const auto at = static_cast<std::size_t>(step);
        session.stage(name + ", size " + std::to_string(step + 1) + " of " + std::to_string(sizes));
        const Cost cost = costOf(work, step);
        size[at] = work.size(step);
        const std::string one = name + "." + std::to_string(static_cast<std::int64_t>(size[at]));
        cpu[at] = session.least(one + ".cpu", cost.cpu);
        session.add(figure(one + ".cpu", cpu[at], "s"));
        session.add(figure(one + ".peak", 1e-6 * session.least(one + ".peak", cost.peak), "MB"));
    }
    session.check(size[0] < size[1] && size[1] < size[2], name + " has sizes that rise");
    session.add(figure(name + ".exponent", exponentBetween(size[0], cpu[0], size[2], cpu[2]), "1", work.limit));
    session.add(figure(name + ".exponent.lower", exponentBetween(size[0], cpu[0], size[1], cpu[1]), "1"));
    session.add(figure(name + ".exponent.upper", exponentBetween(size[1], cpu[1], size[2], cpu[2]), "1"));
}

} // namespace burin::benchmarks
