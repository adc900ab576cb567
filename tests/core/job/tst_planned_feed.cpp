// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/computed_pass.h"
#include "tests/test_program.h"

#include <QTest>

namespace burin::tst_planned_feed {

class TestPlannedFeed : public QObject {
    Q_OBJECT
private slots:
    /// Into a hole through air, along a helix at three tenths of the cutting feed, and out again.
    void theToolGoesDownAtThePlungeFeed() {
        PlannedPass planned;
        planned.strokes = {{{0, 0, 5}, {0, 0, -10}, {1, 0, -9}, {0, 0, -8}, {0, 0, 5}}};
        planned.feedShares = {{0.0, 0.0, 0.3, 0.3, 0.0}};
        const std::vector<double> expected{600.0, 150.0, 180.0, 180.0, 600.0}; // mm/min
        for (std::size_t i = 0; i < expected.size(); ++i)
            QCOMPARE(plannedFeed(planned, 0, i, conditions()), expected[i]);
    }
    void withoutSharesAllIsTheCuttingFeed() {
        PlannedPass planned;
        planned.strokes = {{{0, 0, 5}, {0, 0, -10}, {1, 0, -9}}};
        for (std::size_t i = 0; i < 3; ++i) QCOMPARE(plannedFeed(planned, 0, i, conditions()), 600.0);
    }

private:
    static CuttingConditions conditions() {
        CuttingConditions conditions;
        conditions.feed = 600.0;
        conditions.plungeFeed = 150.0;
        return conditions;
    }
};

BURIN_TEST(TestPlannedFeed, NoApplication)

} // namespace burin::tst_planned_feed

#include "tst_planned_feed.moc"
