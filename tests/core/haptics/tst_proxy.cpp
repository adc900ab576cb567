// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/haptics/analytic_fields.h"
#include "tests/core/haptics/tip_proxy.h"
#include "tests/oracles/random_number.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <functional>

namespace burin::tst_proxy {

using namespace burin::test;

namespace {

constexpr double radius = 3.0;
constexpr double noLimit = 1e9;
using Nearest = std::function<glm::dvec3(const glm::dvec3&)>;

/// Nearest position of the ball's centre on a surface grown by `radius`, given as a tip.
Nearest nearestOnSphere(double solid, double allowance) {
    return [=](const glm::dvec3& tip) {
        const glm::dvec3 centre = tip + up(radius);
        return centre / glm::length(centre) * (solid + radius + allowance) - up(radius);
    };
}
Nearest nearestOnTorus(const TorusSolid& torus, double allowance) {
    return [=](const glm::dvec3& tip) {
        const glm::dvec3 centre = tip + up(radius);
        const glm::dvec3 ring = glm::dvec3(glm::normalize(glm::dvec2(centre)) * torus.major, 0.0);
        return ring + glm::normalize(centre - ring) * (torus.minor + radius + allowance) - up(radius);
    };
}

glm::dvec3 randomPoint(double half) {
    return {randomNumber(-half, half), randomNumber(-half, half), randomNumber(-half, half)};
}

/// Least clearance on the straight segment between two tips, by fine sampling.
template <class Field>
double leastClearance(const Field& field, const glm::dvec3& a, const glm::dvec3& b) {
    double least = 1e300;
    const int count = 1 + static_cast<int>(glm::length(b - a) / 0.01);
    for (int i = 0; i <= count; ++i)
        least = std::min(least, field.clearance(glm::mix(a, b, static_cast<double>(i) / count)));
    return least;
}

/// Drags the goal along `goalAt` (parameter 0 … 1) and compares the proxy with the closed formula on every tick.
template <class Field>
void dragAndCompare(const Field& field, double allowance, const std::function<glm::dvec3(double)>& goalAt,
                    const Nearest& nearest, double maximumLag) {
    TipProxy proxy(field);
    glm::dvec3 tip = nearest(goalAt(0.0));
    tip += field.at(tip).gradient * 1e-3;
    QVERIFY(proxy.feasible(tip, allowance));
    double worstGap = 0.0, worstLag = 0.0;
    constexpr int ticks = 2000;
    for (int i = 0; i <= ticks; ++i) {
        const glm::dvec3 goal = goalAt(static_cast<double>(i) / ticks);
        const TipProxy::Step step = proxy.advance(tip, goal, allowance, noLimit);
        QVERIFY(field.clearance(step.tip) >= allowance);
        QVERIFY(step.onBoundary);
        tip = step.tip;
        worstGap = std::max(worstGap, field.clearance(tip) - allowance);
        worstLag = std::max(worstLag, glm::length(tip - nearest(goal)));
    }
    QVERIFY2(worstGap <= 1e-3, qPrintable(QString::number(worstGap)));
    QVERIFY2(worstLag <= maximumLag, qPrintable(QString::number(worstLag)));
}

/// Random goals, far and near: the proxy stays in the permitted region, so does the straight segment, and the distance
/// from the goal never grows.
template <class Field>
bool neverEnters(const Field& field, const glm::dvec3& start, double extent) {
    return rc::check([&] {
        const double allowance = randomNumber(0.0, 0.5);
        TipProxy proxy(field);
        glm::dvec3 tip = start;
        RC_PRE(proxy.feasible(tip, allowance));
        for (int i = 0; i < 60; ++i) {
            glm::dvec3 goal = randomPoint(extent);
            if (*rc::gen::arbitrary<bool>()) goal = tip + randomPoint(1.0);
            const double travel = randomNumber(0.05, 6.0);
            for (int tick = 0; tick < 4; ++tick) {
                const TipProxy::Step step = proxy.advance(tip, goal, allowance, travel);
                RC_ASSERT(field.clearance(step.tip) >= allowance);
                RC_ASSERT(leastClearance(field, tip, step.tip) >= allowance - proxy.chordTolerance());
                RC_ASSERT(glm::length(step.tip - tip) <= travel + 1e-9);
                RC_ASSERT(glm::length(goal - step.tip) <= glm::length(goal - tip));
                RC_ASSERT(step.iterations <= Proxy::maximumIterations);
                tip = step.tip;
            }
        }
    });
}

/// A field that is as expensive to query as a fine mesh near a long tool.
class DearBoundary final : public PoseBoundary {
public:
    static constexpr int price = 500; ///< units of work
    DearBoundary(const ClearanceField& field, double overlap) : field_(field), overlap_(overlap) {}
    PoseSample at(const ToolPose& pose, double enough) noexcept override {
        ++looks;
        return field_.at(pose, enough);
    }
    double errorBound() const noexcept override { return field_.errorBound(); }
    double spacing() const noexcept override { return 1.0; }
    double overlap() const noexcept override { return overlap_; }
    double reach() const noexcept override { return 0.0; }
    std::uint64_t work() const noexcept override { return static_cast<std::uint64_t>(looks) * price; }

    int looks = 0;

private:
    FixedAxisBoundary field_;
    double overlap_;
};

} // namespace

class TestProxy : public QObject {
    Q_OBJECT
private slots:
    void isAtTheGoalWhereNothingIsInTheWay() {
        const BallField field(PlaneSolid{}, radius, 0.25, 1.0);
        TipProxy proxy(field);
        const TipProxy::Step step = proxy.advance({0, 0, 20}, {15, -3, 4}, 0.2, noLimit);
        QCOMPARE(step.tip, glm::dvec3(15, -3, 4));
        QVERIFY(!step.onBoundary);
        QCOMPARE(step.normal, glm::dvec3(0.0));
    }

    void pressedTwoMillimetresDeepItSlidesOnAPlane() {
        const double allowance = 0.3;
        const BallField field(PlaneSolid{}, radius);
        dragAndCompare(
            field, allowance, [](double t) { return glm::dvec3(100.0 * t, 10.0 * std::sin(9.0 * t), -1.7); },
            [&](const glm::dvec3& goal) { return glm::dvec3(goal.x, goal.y, allowance); }, 1e-3);
    }

    void pressedTwoMillimetresDeepItSlidesOnASphere() {
        const double allowance = 0.1, reach = 10.0 + radius + allowance - 2.0;
        const BallField field(SphereSolid{10.0}, radius);
        dragAndCompare(
            field, allowance,
            [&](double t) {
                const double a = 6.0 * t, b = 1.2 * std::cos(4.0 * t);
                return reach * glm::dvec3(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)) -
                       up(radius);
            },
            nearestOnSphere(10.0, allowance), 0.01);
    }

    void pressedTwoMillimetresDeepItSlidesAroundATorus() {
        const TorusSolid torus;
        const double grown = torus.minor + radius - 2.0;
        const BallField field(torus, radius);
        dragAndCompare(
            field, 0.0,
            [&](double t) {
                const double around = 3.0 * t, about = 20.0 * t; // outside, top, inside of the ring, bottom, …
                const double r = torus.major + grown * std::cos(about);
                return glm::dvec3(r * std::cos(around), r * std::sin(around), grown * std::sin(about)) - up(radius);
            },
            nearestOnTorus(torus, 0.0), 0.02);
    }

    void settlesInTheCornersOfAPocket() {
        const PocketSolid pocket;
        const BallField field(pocket, radius);
        TipProxy proxy(field);
        const double allowance = 0.2;
        const glm::dvec3 limit(pocket.half.x - radius - allowance, pocket.half.y - radius - allowance,
                               -pocket.depth + allowance);
        for (const glm::dvec3& goal : {glm::dvec3(20, 20, -30), glm::dvec3(-20, 15, -12), glm::dvec3(7, -30, -11),
                                       glm::dvec3(-9, -7, -10.5), glm::dvec3(1, 9, -14), glm::dvec3(8, 1, -5)}) {
            const glm::dvec3 expected(std::clamp(goal.x, -limit.x, limit.x), std::clamp(goal.y, -limit.y, limit.y),
                                      std::max(goal.z, limit.z));
            glm::dvec3 tip(0, 0, -4);
            for (int tick = 0; tick < 10; ++tick) tip = proxy.advance(tip, goal, allowance, noLimit).tip;
            QVERIFY2(glm::length(tip - expected) < 1e-3, qPrintable(QString::number(glm::length(tip - expected))));
            // Steady contact: the result is constant to the last bit.
            for (int tick = 0; tick < 100; ++tick) {
                const TipProxy::Step step = proxy.advance(tip, goal, allowance, noLimit);
                QCOMPARE(step.tip, tip);
                QVERIFY(step.onBoundary);
            }
        }
    }

    void handTremorInSteadyContactGivesNoMoreThanItself() {
        const BallField field(TorusSolid{}, radius);
        TipProxy proxy(field);
        glm::dvec3 tip(12, 0, 10);
        const glm::dvec3 goal(12.5, 0.5, 1.0);
        for (int tick = 0; tick < 20; ++tick) tip = proxy.advance(tip, goal, 0.0, noLimit).tip;
        const glm::dvec3 rest = tip;
        for (int tick = 0; tick < 1000; ++tick) {
            const glm::dvec3 tremor =
                0.01 * glm::dvec3(std::sin(0.7 * tick), std::cos(1.1 * tick), std::sin(2.3 * tick));
            tip = proxy.advance(tip, goal + tremor, 0.0, noLimit).tip;
            QVERIFY(glm::length(tip - rest) < 0.05);
        }
        for (int tick = 0; tick < 20; ++tick) tip = proxy.advance(tip, goal, 0.0, noLimit).tip;
        QVERIFY(glm::length(tip - rest) < 1e-3);
    }

    void neverPassesAThinWall() {
        for (double spacing : {0.05, 0.25, 0.5}) {
            const BallField field(WallSolid{1.0}, 0.0, spacing);
            QVERIFY(rc::check([&] {
                TipProxy proxy(field);
                glm::dvec3 tip(randomNumber(0.5, 15.0), 0, 0);
                for (int tick = 0; tick < 200; ++tick) {
                    const glm::dvec3 goal =
                        tip + glm::dvec3(randomNumber(-20.0, 5.0), randomNumber(-9.0, 9.0), randomNumber(-9.0, 9.0));
                    tip = proxy.advance(tip, goal, 0.0, noLimit).tip;
                    RC_ASSERT(tip.x >= 0.5);
                }
            }));
        }
    }

    void neverEntersAPlane() {
        QVERIFY(neverEnters(BallField(PlaneSolid{glm::normalize(glm::dvec3(1, 2, 3))}, radius, 0.25, 1.0), {0, 0, 9},
                            12.0));
    }
    void neverEntersASphere() { QVERIFY(neverEnters(BallField(SphereSolid{}, 0.5, 0.25, 1.0), {0, 0, 14}, 16.0)); }
    void neverEntersATorus() { QVERIFY(neverEnters(BallField(TorusSolid{}, 0.5, 0.25, 1.0), {0, 0, 0}, 18.0)); }
    void neverEntersABox() { QVERIFY(neverEnters(BallField(BoxSolid{{6, 5, 4}}, 0.5, 0.25, 1.0), {0, 0, 9}, 10.0)); }
    void neverEntersThePocketsWalls() {
        QVERIFY(neverEnters(BallField(PocketSolid{}, 0.5, 0.25, 1.0), {0, 0, 5}, 12.0));
    }

    void reachesTheOtherSideAroundAConvexPart() {
        const BallField field(SphereSolid{10.0}, radius, 0.25, 1.0);
        TipProxy proxy(field);
        glm::dvec3 tip(20, 0, 0);
        // A goal on the other side, off the line through the centre: no local minimum holds the tool.
        for (int tick = 0; tick < 200; ++tick) tip = proxy.advance(tip, {-20, 6, 0}, 0.0, noLimit).tip;
        QVERIFY(glm::length(tip - glm::dvec3(-20, 6, 0)) < 1e-6);
    }

    void aTickLooksNoMoreThanItCanAfford_data() {
        QTest::addColumn<double>("overlap");
        QTest::newRow("every step looked along") << 0.0;
        QTest::newRow("the whole way looked along at the end") << 2.0;
    }
    void aTickLooksNoMoreThanItCanAfford() {
        QFETCH(double, overlap);
        const BallField field(SphereSolid{}, radius, 0.25);
        const Nearest nearest = nearestOnSphere(10.0, 0.0);
        DearBoundary dear(field, overlap);
        const Proxy proxy(dear);
        ProxyStride stride;
        stride.travel = 3.0;
        ToolPose tool{{0, 0, 12}};
        // The straight line leads through the part: the tool has to go round it.
        const glm::dvec3 hand{7.0, 1.0, -2.0};
        for (int tick = 0; tick < 60; ++tick) {
            const double before = glm::length(tool.tip - hand);
            const int looksBefore = dear.looks;
            tool = proxy.advance(tool, {hand}, stride).pose;
            // The affordable queries, those already started by then, and the two that every tick may make whatever they
            // cost.
            QVERIFY2(dear.looks - looksBefore <= 4000 / DearBoundary::price + 6,
                     qPrintable(QString::number(dear.looks - looksBefore)));
            QVERIFY(field.clearance(tool.tip) >= 0.0);
            QVERIFY(glm::length(tool.tip - hand) <= before);
        }
        QVERIFY(glm::length(tool.tip - nearest(hand)) < 0.01);
    }

    void retreatsUntilTheAllowanceIsKept() {
        const BallField field(SphereSolid{10.0}, radius);
        TipProxy proxy(field);
        const glm::dvec3 touching = glm::normalize(glm::dvec3(1, 2, 3)) * 13.0 - up(radius);
        const glm::dvec3 a = proxy.retreat(touching, 0.5, 0.1);
        QVERIFY(std::abs(glm::length(a - touching) - 0.1) < 1e-9);
        const glm::dvec3 b = proxy.retreat(a, 0.5, noLimit);
        QVERIFY(proxy.feasible(b, 0.5));
        QVERIFY(field.clearance(b) < 0.5 + 1e-3);
    }
    void retreatInANarrowPocketStaysInTheMiddle() {
        const PocketSolid narrow{{8.0, 3.2}, 10.0};
        const BallField field(narrow, radius);
        TipProxy proxy(field);
        glm::dvec3 tip(0, -0.1, -5);
        for (int tick = 0; tick < 100; ++tick) tip = proxy.retreat(tip, 0.5, 0.01);
        QVERIFY(field.clearance(tip) >= 0.1);
        QVERIFY(std::abs(tip.y) < 0.05);
    }
};

BURIN_TEST(TestProxy, NoApplication)

} // namespace burin::tst_proxy

#include "tst_proxy.moc"
