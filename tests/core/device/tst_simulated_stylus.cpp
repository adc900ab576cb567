// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/device/simulated_stylus.h"
#include "core/geometry/angle.h"
#include "core/haptics/reading_guard.h"
#include "tests/test_program.h"

#include <QTest>

#include <cstring>
#include <random>

namespace burin::tst_simulated_stylus {

namespace {

constexpr double period = 0.001; // s

struct Tick {
    glm::dvec3 tip{0.0};
    bool cutting = false;
};

/// Runs a stylus as the loop does.
class Hand {
public:
    explicit Hand(const glm::dvec3& start) : stylus(start) {
        (void)stylus.open();
        now();
    }
    Tick now() {
        const StylusState state = stylus.read(time);
        time += period;
        return {state.pose.position, (state.buttons & 1U) != 0};
    }
    std::vector<Tick> run(int ticks) {
        std::vector<Tick> way;
        for (int i = 0; i < ticks; ++i) way.push_back(now());
        return way;
    }
    SimulatedStylus stylus;
    double time = 0.0;
};

double aside(const glm::dvec3& a, const glm::dvec3& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// Distance to a polyline; slow and obvious.
double distanceTo(const glm::dvec3& point, const std::vector<glm::dvec3>& line) {
    double nearest = glm::distance(point, line.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
        const glm::dvec3 way = line[i] - line[i - 1];
        const double share = glm::clamp(glm::dot(point - line[i - 1], way) / glm::dot(way, way), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(point, line[i - 1] + share * way));
    }
    return nearest;
}

/// Targets of an erratic user: jumps, pauses, strokes, changing speeds, at every `n`-th tick.
std::vector<std::pair<int, StylusTarget>> wildTargets(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-80.0, 80.0), speed(1.0, 900.0);
    std::uniform_int_distribution<int> pause(1, 120), coin(0, 1);
    std::vector<std::pair<int, StylusTarget>> targets;
    for (int tick = 0; tick < 6000; tick += pause(random))
        targets.emplace_back(tick, StylusTarget{.tip = {place(random), place(random), 0.3 * place(random)},
                                                .maximumSpeed = speed(random),
                                                .cutting = coin(random) == 1});
    return targets;
}

std::vector<Tick> runWild(unsigned seed) {
    Hand hand({0.0, 0.0, 30.0});
    const auto targets = wildTargets(seed);
    std::vector<Tick> way;
    std::size_t next = 0;
    for (int tick = 0; tick < 6500; ++tick) {
        if (next < targets.size() && targets[next].first == tick) hand.stylus.request(targets[next++].second);
        way.push_back(hand.now());
    }
    return way;
}

} // namespace

class TestSimulatedStylus : public QObject {
    Q_OBJECT

private slots:
    void restsWithoutATarget() {
        Hand hand({1.0, 2.0, 3.0});
        for (const Tick& tick : hand.run(50)) {
            QCOMPARE(tick.tip, glm::dvec3(1.0, 2.0, 3.0));
            QVERIFY(!tick.cutting);
        }
    }

    void speedAndAccelerationStayBounded() {
        for (unsigned seed = 1; seed <= 5; ++seed) {
            const std::vector<Tick> way = runWild(seed);
            glm::dvec3 before(0.0), last(0.0, 0.0, 30.0);
            for (const Tick& tick : way) {
                const glm::dvec3 velocity = (tick.tip - last) / period;
                QVERIFY(glm::length(velocity) <= SimulatedStylus::maximumSpeed * 1.000001);
                // The last 0.5 µm and 0.1 mm/s may vanish at once when the tip comes to rest.
                QVERIFY(glm::length(velocity - before) <= SimulatedStylus::acceleration * period + 0.6);
                before = velocity;
                last = tick.tip;
            }
        }
    }

    void theSameTargetsAndTimesGiveTheSameWay() {
        const std::vector<Tick> first = runWild(9), second = runWild(9);
        for (std::size_t i = 0; i < first.size(); ++i)
            QVERIFY(std::memcmp(&first[i].tip, &second[i].tip, sizeof(glm::dvec3)) == 0);
    }

    void arrivesWithoutOvershoot_data() {
        QTest::addColumn<double>("distance");
        for (const double distance : {0.001, 0.05, 1.0, 7.0, 60.0, 300.0}) QTest::addRow("%g mm", distance) << distance;
    }
    void arrivesWithoutOvershoot() {
        QFETCH(double, distance);
        Hand hand({0.0, 0.0, 0.0});
        hand.stylus.request({.tip = {distance, 0.0, 0.0}});
        const std::vector<Tick> way = hand.run(1500);
        double farthest = 0.0;
        for (const Tick& tick : way) farthest = std::max(farthest, tick.tip.x);
        QVERIFY2(farthest <= distance + 0.001, qPrintable(QString::number(farthest - distance)));
        QCOMPARE(way.back().tip, glm::dvec3(distance, 0.0, 0.0));
    }

    void keepsTheSpeedThatIsAsked() {
        Hand hand({0.0, 0.0, 0.0});
        hand.stylus.request({.tip = {50.0, 0.0, 0.0}, .maximumSpeed = 60.0});
        double fastest = 0.0;
        glm::dvec3 before(0.0);
        for (const Tick& tick : hand.run(1200)) {
            fastest = std::max(fastest, glm::length(tick.tip - before) / period);
            before = tick.tip;
        }
        QVERIFY(fastest <= 60.0 * 1.000001 && fastest > 59.0);
    }

    void aStrokeGoesOverItsStartBeforeTheSpindleTurnsAndThenStraightDown() {
        const glm::dvec3 start(25.0, -10.0, 4.0);
        Hand hand({0.0, 0.0, 20.0});
        hand.stylus.request({.tip = start, .maximumSpeed = 80.0, .cutting = true});
        bool cut = false;
        for (const Tick& tick : hand.run(1500)) {
            if (!tick.cutting) {
                QVERIFY(!cut);
                QVERIFY(tick.tip.z >= 20.0 - 1e-9);
                continue;
            }
            cut = true;
            QVERIFY2(aside(tick.tip, start) <= 0.03, qPrintable(QString::number(aside(tick.tip, start))));
        }
        QVERIFY(cut);
    }

    void aStrokeFollowsThePointerFromItsStartOn() {
        const glm::dvec3 start(0.0, 0.0, 4.0), end(12.0, 5.0, 4.0);
        Hand hand({0.0, 0.0, 20.0});
        hand.stylus.request({.tip = start, .cutting = true});
        hand.now();
        hand.stylus.request({.tip = end, .cutting = true}); // the pointer is faster than the tool
        bool reachedStart = false;
        for (const Tick& tick : hand.run(1500)) {
            reachedStart = reachedStart || glm::distance(tick.tip, start) < 0.03;
            if (aside(tick.tip, start) > 0.05) QVERIFY(reachedStart);
        }
        QCOMPARE(hand.now().tip, end);
    }

    void wayToTheStartIsClearOfWhatTheTargetNames() {
        const glm::dvec3 start(40.0, 0.0, 3.0);
        Hand hand({0.0, 0.0, 5.0});
        hand.stylus.request({.tip = start, .cutting = true, .clearHeight = 30.0});
        for (const Tick& tick : hand.run(3000))
            if (tick.tip.x > 0.05 && tick.tip.x < 39.95)
                QVERIFY(tick.tip.z >= 30.0 - SimulatedStylus::clearance - 1e-6);
        QCOMPARE(hand.now().tip, start);
    }

    void liftsBeforeItMovesAside() {
        Hand hand({0.0, 0.0, 20.0});
        hand.stylus.request({.tip = {0.0, 0.0, 4.0}, .cutting = true});
        hand.run(1500);
        hand.stylus.request({.tip = {30.0, 0.0, 20.0}});
        for (const Tick& tick : hand.run(1500)) {
            QVERIFY(!tick.cutting);
            if (tick.tip.z < 20.0 - SimulatedStylus::clearance) QVERIFY(std::abs(tick.tip.x) < 1e-9);
        }
        QCOMPARE(hand.now().tip, glm::dvec3(30.0, 0.0, 20.0));
    }

    /// A pointer that jumps from goal to goal, faster than the tool: the tool follows the entire trail without
    /// shortcuts.
    void aStrokeGoesAlongThePointersTrailToItsEnd() {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> place(-30.0, 30.0), small(-2.0, 2.0);
            std::uniform_int_distribution<int> pause(1, 30), coin(0, 3);
            std::vector<glm::dvec3> trail{{0.0, 0.0, -2.0}};
            Hand hand({0.0, 0.0, 20.0});
            hand.stylus.request({.tip = trail.back(), .maximumSpeed = 150.0, .cutting = true});
            std::vector<Tick> way = hand.run(1200);
            for (int goal = 0; goal < 25; ++goal) {
                trail.push_back(coin(random) == 0 ? glm::dvec3(place(random), place(random), -2.0)
                                                  : trail.back() + glm::dvec3(small(random), small(random), 0.0));
                hand.stylus.request({.tip = trail.back(), .maximumSpeed = 150.0, .cutting = true});
                const std::vector<Tick> more = hand.run(pause(random));
                way.insert(way.end(), more.begin(), more.end());
            }
            hand.stylus.request({.tip = {0.0, 0.0, 20.0}, .finishStroke = true}); // released long before its end
            const std::vector<Tick> rest = hand.run(8000);
            way.insert(way.end(), rest.begin(), rest.end());
            std::vector<glm::dvec3> cut;
            for (const Tick& tick : way)
                if (tick.cutting && tick.tip.z < -1.97) cut.push_back(tick.tip);
            QVERIFY(glm::distance(cut.back(), trail.back()) < 1e-9 && !way.back().cutting);
            double farthest = 0.0;
            for (const glm::dvec3& tip : cut) farthest = std::max(farthest, distanceTo(tip, trail));
            QVERIFY2(farthest <= TrailFollower::tolerance + 0.005, qPrintable(QString::number(farthest)));
            for (const glm::dvec3& corner : trail) {
                double nearest = 1e9;
                for (const glm::dvec3& tip : cut) nearest = std::min(nearest, glm::distance(tip, corner));
                QVERIFY(nearest <= 0.15 + TrailFollower::tolerance); // a tick at 150 mm/s, and the corner cut
            }
        }
    }

    /// Sixty jumps a second become one even motion: a sweep at constant speed is recorded with constant speed.
    void evenlySpacedGoalsBecomeAnEvenMotion() {
        Hand hand({0.0, 0.0, 20.0});
        hand.stylus.request({.tip = {0.0, 0.0, 0.0}, .cutting = true});
        hand.run(1500);
        std::vector<Tick> way;
        for (int event = 1; event <= 60; ++event) { // 100 mm/s
            hand.stylus.request({.tip = {100.0 / 60.0 * event, 0.0, 0.0}, .cutting = true});
            const std::vector<Tick> more = hand.run(event % 3 == 0 ? 16 : 17);
            way.insert(way.end(), more.begin(), more.end());
        }
        double slowest = 1e9, fastest = 0.0;
        for (std::size_t i = 301; i < way.size(); ++i) {
            const double speed = (way[i].tip.x - way[i - 1].tip.x) / period;
            slowest = std::min(slowest, speed);
            fastest = std::max(fastest, speed);
        }
        QVERIFY2(slowest > 85.0 && fastest < 115.0, qPrintable(QStringLiteral("%1 %2").arg(slowest).arg(fastest)));
    }

    /// The next stroke begins at its requested position once the trail of the previous one is finished.
    void aPressDuringTheTailWaits() {
        Hand hand({0.0, 0.0, 20.0});
        hand.stylus.request({.tip = {0.0, 0.0, 0.0}, .maximumSpeed = 50.0, .cutting = true});
        hand.run(1200);
        hand.stylus.request({.tip = {40.0, 0.0, 0.0}, .maximumSpeed = 50.0, .cutting = true});
        hand.stylus.request({.tip = {40.0, 0.0, 20.0}, .finishStroke = true});
        hand.stylus.request({.tip = {0.0, 30.0, 0.0}, .maximumSpeed = 50.0, .cutting = true, .clearHeight = 20.0});
        bool reachedEnd = false, reachedNext = false;
        for (const Tick& tick : hand.run(6000)) {
            reachedEnd = reachedEnd || glm::distance(tick.tip, {40.0, 0.0, 0.0}) < 1e-6;
            if (tick.tip.y > 0.01) QVERIFY(reachedEnd);
            if (tick.tip.y > 0.01 && tick.tip.y < 29.9) QVERIFY(!tick.cutting);
            reachedNext = reachedNext || glm::distance(tick.tip, {0.0, 30.0, 0.0}) < 1e-6;
        }
        QVERIFY(reachedNext);
    }

    /// Esc cancels everything that is pending: a tail, a stroke that was pressed during it, and more points than the
    /// tool keeps.
    void givingUpOvertakesWhatWaits() {
        Hand hand({0.0, 0.0, 20.0});
        hand.stylus.request({.tip = {0.0, 0.0, 0.0}, .maximumSpeed = 20.0, .cutting = true});
        hand.run(1200);
        for (int i = 1; i <= 3000; ++i)
            hand.stylus.request({.tip = {0.1 * i, i % 2 == 0 ? 0.0 : 0.5, 0.0}, .maximumSpeed = 20.0, .cutting = true});
        hand.stylus.request({.tip = {0.0, 0.0, 20.0}, .finishStroke = true});
        hand.stylus.request({.tip = {0.0, 30.0, 0.0}, .maximumSpeed = 20.0, .cutting = true});
        hand.run(100);
        QVERIFY(hand.now().cutting);
        hand.stylus.request({.tip = {0.0, 0.0, 20.0}});
        for (const Tick& tick : hand.run(2000)) QVERIFY(!tick.cutting);
        QCOMPARE(hand.now().tip, glm::dvec3(0.0, 0.0, 20.0));
    }

    /// However many points are pending, and even if nobody reads meanwhile: the end of a stroke is never lost.
    void theEndOfAStrokeAlwaysHasRoom() {
        Hand hand({0.0, 0.0, 20.0});
        bool full = false;
        for (int i = 0; i < 10000; ++i)
            full = !hand.stylus.request({.tip = {0.001 * i, 0.0, 0.0}, .maximumSpeed = 400.0, .cutting = true}) || full;
        QVERIFY(full);
        QVERIFY(hand.stylus.request({.tip = {0.0, 0.0, 20.0}, .finishStroke = true}));
        const std::vector<Tick> way = hand.run(8000);
        QVERIFY(std::ranges::any_of(way, &Tick::cutting) && !way.back().cutting);
    }

    void aStrokeTakenBackNeverTurnsTheSpindle() {
        Hand hand({0.0, 0.0, 20.0});
        hand.stylus.request({.tip = {100.0, 0.0, 4.0}, .cutting = true});
        for (const Tick& tick : hand.run(100)) QVERIFY(!tick.cutting);
        hand.stylus.request({.tip = {0.0, 0.0, 20.0}});
        for (const Tick& tick : hand.run(1500)) QVERIFY(!tick.cutting);
    }

    /// The guard that judges every reading must never take this stylus for faulty, not even with late ticks.
    void theReadingGuardTrustsIt() {
        SimulatedStylus stylus({0.0, 0.0, 30.0});
        ReadingGuard guard(stylus.description(), period);
        const auto targets = wildTargets(4);
        double time = 0.0;
        std::size_t next = 0;
        for (int tick = 0; tick < 6500; ++tick) {
            if (next < targets.size() && targets[next].first == tick) stylus.request(targets[next++].second);
            const double late = tick % 97 == 0 ? 8.0 * period : period;
            time += late;
            QVERIFY(guard.check(stylus.read(time), late) != Reading::fault);
        }
    }

    void aLongPauseIsNoJump() {
        Hand hand({0.0, 0.0, 0.0});
        hand.stylus.request({.tip = {100.0, 0.0, 0.0}});
        const glm::dvec3 before = hand.now().tip;
        hand.time += 5.0;
        QVERIFY(glm::distance(before, hand.now().tip) < ReadingGuard::largestJump);
    }

    /// A tablet's pen leans from 0° to 40° along a line of 40 mm: a degree per millimetre, at every point of it,
    /// however far the tool is behind the pen. Before and after the stroke the tool is upright.
    void theAxisLeansWhereItWasDrawnLeaning() {
        SimulatedStylus stylus({0.0, 0.0, 20.0});
        QVERIFY(stylus.open().hasValue());
        const auto leaning = [](double degrees) {
            return glm::dvec3(std::sin(glm::radians(degrees)), 0.0, std::cos(glm::radians(degrees)));
        };
        for (int i = 0; i <= 20; ++i)
            stylus.request(
                {.tip = {2.0 * i, 0.0, 4.0}, .maximumSpeed = 40.0, .cutting = true, .axis = leaning(2.0 * i)});
        stylus.request({.tip = {40.0, 0.0, 20.0}, .finishStroke = true});
        glm::dvec3 before(0.0, 0.0, 1.0);
        double mostTurn = 0.0, worst = 0.0, largest = 0.0;
        for (int tick = 1; tick <= 4000; ++tick) {
            const StylusState state = stylus.read(period * tick);
            const glm::dvec3 axis = state.pose.rotation * glm::dvec3(0.0, 0.0, 1.0);
            mostTurn = std::max(mostTurn, angleBetween(before, axis));
            before = axis;
            const double degrees = glm::degrees(angleBetween(axis, {0.0, 0.0, 1.0}));
            const double x = state.pose.position.x;
            if ((state.buttons & 1U) == 0) {
                if (x == 0.0) QCOMPARE(degrees, 0.0);
                continue;
            }
            largest = std::max(largest, degrees);
            // The axis is 20 ms behind the trail, the position 8 ms: together 1.12 mm at 40 mm/s.
            worst = std::max(worst, std::abs(degrees - x));
        }
        QVERIFY2(worst < 1.2, qPrintable(QString::number(worst)));
        QVERIFY(largest > 38.5 && largest <= 40.0 + 1e-9);
        QVERIFY(mostTurn <= SimulatedStylus::turnSpeed * period + 1e-9);
        QVERIFY(angleBetween(before, {0.0, 0.0, 1.0}) < 1e-9); // upright again
    }

    /// A pen that is tilted in place, the tool at rest under it.
    void theAxisTurnsInPlaceAtLimitedSpeed() {
        SimulatedStylus stylus({0.0, 0.0, 20.0});
        QVERIFY(stylus.open().hasValue());
        stylus.request({.tip = {0.0, 0.0, 4.0}, .cutting = true});
        double time = 0.0;
        for (int i = 0; i < 2000; ++i) static_cast<void>(stylus.read(time += period));
        const glm::dvec3 wanted = glm::normalize(glm::dvec3(0.0, 1.0, 1.0)); // 45°
        stylus.request({.tip = {0.0, 0.0, 4.0}, .cutting = true, .axis = wanted});
        glm::dvec3 before(0.0, 0.0, 1.0);
        int ticks = 0;
        for (; ticks < 2000 && angleBetween(before, wanted) > 1e-3; ++ticks) {
            const StylusState state = stylus.read(time += period);
            QCOMPARE(state.pose.position, glm::dvec3(0.0, 0.0, 4.0));
            const glm::dvec3 axis = state.pose.rotation * glm::dvec3(0.0, 0.0, 1.0);
            QVERIFY(angleBetween(before, axis) <= SimulatedStylus::turnSpeed * period + 1e-9);
            before = axis;
        }
        QVERIFY(ticks > 1000.0 * 0.25 * pi / SimulatedStylus::turnSpeed - 1.0 && ticks < 600);
    }

    void tellsTheUserInterfaceWhereItIs() {
        Hand hand({1.0, 1.0, 1.0});
        hand.stylus.request({.tip = {2.0, 1.0, 1.0}});
        const Tick last = hand.run(37).back();
        QCOMPARE(hand.stylus.tip(), last.tip);
    }
};

BURIN_TEST(TestSimulatedStylus, NoApplication)

} // namespace burin::tst_simulated_stylus

#include "tst_simulated_stylus.moc"
