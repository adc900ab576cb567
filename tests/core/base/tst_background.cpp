// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/background.h"
#include "core/base/parallel.h"
#include "tests/test_program.h"

#include <QtTest>

#include <atomic>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace burin::tst_background {

namespace {

/// Niceness of the calling thread as reported by the system.
int niceness() {
    return ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()));
}

} // namespace

/// Long computations leave the cores to what the user sees and feels.
class TestBackground : public QObject {
    Q_OBJECT
private slots:
    void onlyTheThreadThatAsksStepsBack() {
        const int before = niceness();
        int behind = 0, child = 0;
        std::thread([&] {
            workInBackground();
            behind = niceness();
            std::thread([&] { child = niceness(); }).join();
        }).join();
        QVERIFY(behind > before);
        QCOMPARE(child, behind);
        QCOMPARE(niceness(), before);
    }
    void helpersStepBackAndTheOneThatAsksStays() {
        if (std::thread::hardware_concurrency() < 2) QSKIP("one core: nobody helps");
        helpInBackground();
        const int before = niceness();
        const pid_t asking = ::gettid();
        std::atomic<int> helped{0}, inFront{0};
        for (int attempt = 0; attempt < 50 && helped == 0; ++attempt)
            parallelFor(0, 16, [&](int) {
                if (::gettid() != asking) {
                    ++helped;
                    if (niceness() <= before) ++inFront;
                }
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            });
        QVERIFY(helped > 0);
        QCOMPARE(inFront.load(), 0);
        QCOMPARE(niceness(), before);
    }
};

BURIN_TEST(TestBackground, NoApplication)

} // namespace burin::tst_background

#include "tst_background.moc"
