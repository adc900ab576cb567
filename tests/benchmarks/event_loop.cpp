// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/event_loop.h"

#include <QEventLoop>
#include <QTimer>

namespace burin::testing {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

} // namespace

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

bool runUntil(const std::function<bool()>& what, Clock::duration limit) {
    QEventLoop loop;
    QTimer look;
    const Clock::time_point end = Clock::now() + limit;
    bool happened = false;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        happened = what();
        if (happened || Clock::now() >= end) loop.quit();
    });
    look.start(5ms);
    loop.exec();
    return happened;
}

void runFor(Clock::duration time) {
    runUntil([] { return false; }, time);
}

} // namespace burin::testing
