// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/spindle_schedule.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin::tst_spindle_schedule {

namespace {

constexpr double startTime = 3.0; // s
constexpr double inf = std::numeric_limits<double>::infinity();

std::vector<SpindleInterval> randomIntervals() {
    std::vector<SpindleInterval> intervals;
    const int count = *rc::gen::inRange(1, 60);
    double fastest = 12000.0;
    for (int i = 0; i < count; ++i) {
        if (*rc::gen::inRange(0, 4) == 0) fastest = *rc::gen::element(3000.0, 6000.0, 12000.0, 18000.0, inf);
        intervals.push_back({fastest, *rc::gen::inRange(1, 3000) * 1e-3, i > 0 && *rc::gen::inRange(0, 12) != 0});
    }
    return intervals;
}

/// The oracle: a spindle that approaches its commanded speed evenly, in `time` seconds from the command. Calls
/// `look(interval, speed)` a hundred times per interval. Between cuts it has enough time.
template <class Look>
void turn(const std::vector<SpindleInterval>& intervals, const std::vector<double>& told, double time, Look look) {
    double speed = 0.0, from = 0.0, to = 0.0, since = 0.0;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        if (!intervals[i].joined) speed = from = to = told[i];
        if (told[i] != to) {
            from = speed;
            to = told[i];
            since = 0.0;
        }
        for (int k = 0; k < 100; ++k) {
            speed = time > 0.0 ? from + (to - from) * std::min(1.0, since / time) : to;
            look(i, speed);
            since += intervals[i].seconds / 100.0;
        }
        speed = time > 0.0 ? from + (to - from) * std::min(1.0, since / time) : to;
    }
}

} // namespace

/// The moments at which a spindle is commanded to change its speed during a cut.
class TestSpindleSchedule : public QObject {
    Q_OBJECT
private slots:
    /// However quick the spindle is, it is never faster than the material permits, and never slower than the feed
    /// assumes: chips are no thicker than requested.
    void noMaterialIsCutTooFastAndNoChipIsTooThick() {
        QVERIFY(rc::check([] {
            const std::vector<SpindleInterval> intervals = randomIntervals();
            RC_PRE(
                std::ranges::any_of(intervals, [](const SpindleInterval& one) { return std::isfinite(one.fastest); }));
            const SpindleSpeeds speeds = spindleSchedule(intervals, startTime);
            RC_ASSERT(speeds.told.size() == intervals.size() && speeds.sureOf.size() == intervals.size());
            for (const double time : {0.0, 0.4 * startTime, startTime})
                turn(intervals, speeds.told, time, [&](std::size_t i, double speed) {
                    RC_ASSERT(speed <= intervals[i].fastest + 1e-6);
                    RC_ASSERT(speed >= speeds.sureOf[i] - 1e-6);
                });
        }));
    }

    void aSpeedThatIsRaisedLasts() {
        QVERIFY(rc::check([] {
            const std::vector<SpindleInterval> intervals = randomIntervals();
            const std::vector<double> told = spindleSchedule(intervals, startTime).told;
            for (std::size_t i = 1; i < told.size(); ++i) {
                if (!intervals[i].joined || told[i] <= told[i - 1]) continue;
                double seconds = 0.0;
                std::size_t end = i;
                for (; end < told.size() && (end == i || intervals[end].joined) && told[end] >= told[i]; ++end)
                    seconds += intervals[end].seconds;
                RC_ASSERT(seconds >= startTime - 1e-9);
            }
        }));
    }

    /// 10 s in wood, 10 s in steel, 10 s in wood, half a second per interval.
    void theSpeedIsThatOfTheMaterial() {
        std::vector<SpindleInterval> intervals;
        for (int i = 0; i < 60; ++i) intervals.push_back({i / 20 == 1 ? 3000.0 : 18000.0, 0.5, i > 0});
        const SpindleSpeeds speeds = spindleSchedule(intervals, startTime);
        for (int i = 0; i < 60; ++i) {
            // The lower speed is commanded 3 s before the steel; the feed is raised 3 s after it.
            QCOMPARE(speeds.told[static_cast<std::size_t>(i)], i >= 14 && i < 40 ? 3000.0 : 18000.0);
            QCOMPARE(speeds.sureOf[static_cast<std::size_t>(i)], i >= 14 && i < 46 ? 3000.0 : 18000.0);
        }
        // A rib of wood of 2 s in the steel does not justify a change.
        for (int i = 28; i < 32; ++i) intervals[static_cast<std::size_t>(i)].fastest = 18000.0;
        QVERIFY(spindleSchedule(intervals, startTime).told == speeds.told);
    }
};

BURIN_TEST(TestSpindleSchedule, NoApplication)

} // namespace burin::tst_spindle_schedule

#include "tst_spindle_schedule.moc"
