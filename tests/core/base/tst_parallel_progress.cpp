// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel_progress.h"
#include "tests/test_program.h"

#include <QtTest>

#include <array>

namespace burin::tst_parallel_progress {

class TestParallelProgress : public QObject {
    Q_OBJECT

private slots:
    /// Progress has one writer; only that thread may write its state.
    void othersCountAndTheWorksThreadReports() {
        Progress progress;
        {
            ParallelProgress shared(progress, 10, 0.2, 0.7);
            const auto byAnother = [&](std::size_t pieces) { std::thread([&] { shared.add(pieces); }).join(); };
            byAnother(3);
            QCOMPARE(progress.fraction(), 0.0);
            shared.add();
            QCOMPARE(progress.fraction(), 0.2 + 0.5 * 4 / 10);
            byAnother(6);
            QCOMPARE(progress.fraction(), 0.2 + 0.5 * 4 / 10);
        }
        QCOMPARE(progress.fraction(), 0.7); // every share is counted
    }

    void noPieceIsLostAmongThreads() {
        constexpr std::size_t each = 20'000;
        Progress progress;
        {
            ParallelProgress shared(progress, 5 * each);
            const auto work = [&] {
                for (std::size_t i = 0; i < each; ++i) shared.add();
            };
            std::array<std::thread, 4> threads;
            for (std::thread& thread : threads) thread = std::thread(work);
            work();
            for (std::thread& thread : threads) thread.join();
        }
        QCOMPARE(progress.fraction(), 1.0);
    }

    void aStageOfNothingReportsNothing() {
        Progress progress;
        progress.report(0.5);
        { const ParallelProgress shared(progress, 0); }
        QCOMPARE(progress.fraction(), 0.5);
    }
};

BURIN_TEST(TestParallelProgress, NoApplication)

} // namespace burin::tst_parallel_progress

#include "tst_parallel_progress.moc"
