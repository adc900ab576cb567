// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "tests/test_program.h"

#include <QtTest>

#include <thread>

namespace burin::tst_planted_races {

/// Races as a test or a parallel body would have them. That the sanitizer reports them is what is asked for.
class PlantedRacesTest : public QObject {
    Q_OBJECT

private slots:
    void betweenThreads() {
        long sum = 0;
        const auto count = [&] {
            for (int i = 0; i < 100000; ++i) ++sum;
        };
        std::jthread other(count);
        count();
        QVERIFY(sum > 0);
    }

    void withinAParallelBody() {
        long sum = 0;
        parallelFor(0, 100000, [&](int) { ++sum; });
        QVERIFY(sum > 0);
    }
};

BURIN_TEST(PlantedRacesTest, NoApplication)

} // namespace burin::tst_planted_races

#include "tst_planted_races.moc"
