// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/haptics/guide_rig.h"

#include "core/base/units.h"
#include "tests/oracles/random_number.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_guides {

using namespace burin::test;

namespace {

glm::dvec3 randomPoint(double half) {
    return {randomNumber(-half, half), randomNumber(-half, half), randomNumber(-half, half)};
}
glm::dvec3 randomDirection() {
    for (;;) {
        const glm::dvec3 way = randomPoint(1.0);
        if (glm::length(way) > 0.1) return glm::normalize(way);
    }
}

/// A circle of radius 20 about z, at a height, in many segments.
GuideCurve circle(double height, int segments = 4000) {
    std::vector<glm::dvec3> points, tangents;
    for (int i = 0; i <= segments; ++i) {
        const double angle = 2.0 * pi * i / segments;
        points.emplace_back(20.0 * std::cos(angle), 20.0 * std::sin(angle), height);
        tangents.emplace_back(-std::sin(angle), std::cos(angle), 0.0);
    }
    return *GuideCurve::make(points, tangents);
}

} // namespace

class TestGuides : public QObject {
    Q_OBJECT
private slots:
    void aPlaneTakesTheHandNearItAndKeepsTheToolOnIt() {
        GuideRig<> rig(PlaneSolid{}, 1.0);
        rig.use({planeGuide(up(50), up(1))});
        rig.feed({0, 0, 52.5});
        QCOMPARE(rig.rest(settled).held, 0U);
        QCOMPARE(rig.last.goal.tip, rig.hand); // not near enough: the hand is free
        rig.moveTo({10, 5, 51.9});
        QCOMPARE(rig.rest(settled).held, 1U);
        QVERIFY(glm::length(rig.last.goal.tip - glm::dvec3(10, 5, 50)) < 1e-9);
        rig.moveTo({20, 5, 52.9}); // farther away than where it was engaged, but not pushed off
        QVERIFY(std::abs(rig.rest(settled).goal.tip.z - 50.0) < 1e-9);
        rig.moveTo({20, 5, 53.1});
        QCOMPARE(rig.rest(settled).held, 0U);
        QVERIFY(glm::length(rig.last.goal.tip - rig.hand) < 1e-12);
    }

    void distancesAreTheHandsOwnWhateverTheScale() {
        GuideRig<> rig(PlaneSolid{}, 4.0); // 4 mm of the setup correspond to one of the hand
        rig.use({planeGuide(up(50), up(1))});
        rig.feed(up(57));
        QCOMPARE(rig.rest(settled).held, 1U);
        rig.moveTo(up(61.5), 100.0);
        QCOMPARE(rig.last.held, 1U);
        rig.moveTo(up(62.5), 100.0);
        QCOMPARE(rig.last.held, 0U);
    }

    void noGuideEverMakesGoalOrPullJump() {
        QVERIFY(rc::check("they run no faster than the hand and guides that fade", [] {
            GuideRig<> rig;
            const GuideCurve curve = circle(50.0, 200);
            Guide edge = guideOf(GuideKind::curve);
            edge.curve = &curve;
            rig.use({guideOf(GuideKind::levels, randomNumber(0.5, 8.0)), edge,
                     planeGuide(randomPoint(10.0) + up(50), randomDirection()),
                     planeGuide(randomPoint(10.0) + up(50), randomDirection())});
            rig.feed(randomPoint(10.0) + up(50));
            glm::dvec3 goal = rig.last.goal.tip, pull = rig.last.pull;
            for (int leg = 0; leg < 12; ++leg) {
                if (leg == 5) rig.guides.step(-1);
                if (leg == 7) rig.use({edge, guideOf(GuideKind::levels, 2.0)});
                const glm::dvec3 from = rig.hand, target = from + randomPoint(4.0);
                for (int i = 1; i <= 100; ++i) {
                    rig.feed(glm::mix(from, target, i / 100.0));
                    const double moved = glm::length(target - from) / 100.0;
                    // Own motion across guides that meet at sin 0.2, and 200 mm/s from a guide that fades.
                    RC_ASSERT(glm::length(rig.last.goal.tip - goal) <= moved * (1.0 + 1.0 / 0.2) + 0.2 + 1e-9);
                    // 1.8 mm that fade smoothly over 0.1 s, for as many guides as hold at once.
                    RC_ASSERT(glm::length(rig.last.pull - pull) <= 3.0 * (1.5 * moved + 0.027) + 1e-9);
                    goal = rig.last.goal.tip;
                    pull = rig.last.pull;
                }
            }
        }));
    }

    void severalPlanesHoldTheToolWhereTheyMeet() {
        QVERIFY(rc::check("the goal is the nearest point to the hand on all planes", [] {
            const glm::dvec3 meeting = randomPoint(20.0) + up(60);
            const glm::dvec3 first = randomDirection(), second = randomDirection();
            RC_PRE(glm::length(glm::cross(first, second)) > 0.5);
            GuideRig<> rig;
            rig.use({planeGuide(meeting, first), planeGuide(meeting, second)});
            const glm::dvec3 hand = meeting + randomPoint(0.8);
            rig.feed(hand);
            rig.rest(settled);
            RC_ASSERT(rig.last.held == 3U);
            const glm::dvec3 goal = rig.last.goal.tip, along = glm::normalize(glm::cross(first, second));
            RC_ASSERT(std::abs(glm::dot(goal - meeting, first)) < 1e-9);
            RC_ASSERT(std::abs(glm::dot(goal - meeting, second)) < 1e-9);
            RC_ASSERT(std::abs(glm::dot(goal - hand, along)) < 1e-9); // directions that no plane holds follow the hand
        }));
    }

    void threePlanesHoldAPoint() {
        GuideRig<> rig;
        rig.use({planeGuide({1, 2, 50}, {1, 0, 0}), planeGuide({1, 2, 50}, {0, 1, 0}), planeGuide({1, 2, 50}, up(1))});
        rig.feed({2, 3, 51});
        QVERIFY(glm::length(rig.rest(settled).goal.tip - glm::dvec3(1, 2, 50)) < 1e-9);
        QCOMPARE(rig.last.held, 7U);
    }

    void ofGuidesThatContradictTheEarlierOneHolds() {
        GuideRig<> rig;
        const Guide high = planeGuide(up(51), up(1)), low = planeGuide(up(50), up(1));
        rig.use({low, high});
        rig.feed(up(50.9)); // nearer to the later one
        rig.rest(settled);
        QCOMPARE(rig.last.held, 1U);
        QCOMPARE(rig.guides.news(1).is, GuideNews::Is::overruled);
        QVERIFY(std::abs(rig.last.goal.tip.z - 50.0) < 1e-9);
        // An earlier guide that is switched on while a later one holds replaces it.
        GuideSettings settings;
        settings.guides[1] = high;
        rig.guides.set(settings);
        rig.rest(3 * settled);
        QCOMPARE(rig.last.held, 2U);
        QVERIFY(std::abs(rig.last.goal.tip.z - 51.0) < 1e-9);
        rig.use({low, high});
        rig.rest(3 * settled);
        QCOMPARE(rig.last.held, 1U);
        QVERIFY(std::abs(rig.last.goal.tip.z - 50.0) < 1e-9);
    }

    void levelsChangeAtSixTenthsOfTheirDistance() {
        GuideRig<> rig;
        Guide levels = guideOf(GuideKind::levels, 2.0);
        levels.point = up(50);
        rig.use({levels});
        rig.feed(up(50.1));
        QVERIFY(std::abs(rig.rest(settled).goal.tip.z - 50.0) < 1e-9);
        rig.moveTo(up(48.85)); // past the midpoint
        QVERIFY(std::abs(rig.rest(2 * settled).goal.tip.z - 50.0) < 1e-9);
        rig.moveTo(up(48.75)); // past six tenths
        QVERIFY(std::abs(rig.rest(3 * settled).goal.tip.z - 48.0) < 1e-9);
        QCOMPARE(rig.guides.news(0).level, -1);
        rig.moveTo(up(49.15));
        QVERIFY(std::abs(rig.rest(3 * settled).goal.tip.z - 48.0) < 1e-9);
        rig.moveTo(up(49.3));
        QVERIFY(std::abs(rig.rest(3 * settled).goal.tip.z - 50.0) < 1e-9);
    }

    void aButtonTakesTheNextLevelBelow() {
        GuideRig<> rig;
        Guide levels = guideOf(GuideKind::levels, 5.0);
        levels.point = up(50);
        GuideSettings settings;
        settings.guides[0] = levels;
        settings.stepButton = 2;
        rig.guides.set(settings);
        rig.feed(up(50.5));
        rig.rest(settled);
        rig.buttons = 2;
        rig.rest(3 * settled); // held down: one level only
        QVERIFY(std::abs(rig.last.goal.tip.z - 45.0) < 1e-9);
        QVERIFY(rig.last.pull.z < -1.0); // and the hand is pulled there
        rig.moveTo(up(45.5));
        rig.buttons = 0;
        QVERIFY(std::abs(rig.rest(settled).goal.tip.z - 45.0) < 1e-9);
        rig.moveTo(up(48.2)); // pushed off as usual: the level above engages
        QVERIFY(std::abs(rig.rest(3 * settled).goal.tip.z - 50.0) < 1e-9);
    }

    void aLineLeavesTheWayAlongItFree() {
        QVERIFY(rc::check("the goal is the hand's projection", [] {
            Guide line = guideOf(GuideKind::line);
            line.point = randomPoint(20.0) + up(60);
            line.direction = randomDirection();
            GuideRig<> rig;
            rig.use({line});
            const glm::dvec3 start = line.point + line.direction * randomNumber(-20.0, 20.0) + randomPoint(0.9);
            rig.feed(start);
            rig.moveTo(start + line.direction * 5.0);
            rig.rest(settled);
            const glm::dvec3 away = rig.hand - line.point;
            const glm::dvec3 onLine = line.point + line.direction * glm::dot(away, line.direction);
            RC_ASSERT(glm::length(rig.last.goal.tip - onLine) < 1e-9);
            RC_ASSERT(std::abs(glm::dot(rig.last.pull, line.direction)) < 1e-9);
        }));
    }

    void anEdgeOfThePartIsFollowed() {
        const GuideCurve curve = circle(50.0);
        Guide edge = guideOf(GuideKind::curve);
        edge.curve = &curve;
        GuideRig<> rig;
        rig.use({edge});
        rig.feed({21, 0, 51});
        rig.rest(settled);
        QCOMPARE(rig.last.held, 1U);
        double worst = 0.0;
        for (int i = 0; i <= 3000; ++i) { // one and a half turns, across the joint
            const double angle = 3.0 * pi * i / 3000;
            rig.feed({21 * std::cos(angle), 21 * std::sin(angle), 51});
            const glm::dvec3 nearest(20 * std::cos(angle), 20 * std::sin(angle), 50);
            worst = std::max(worst, glm::length(rig.last.goal.tip - nearest));
        }
        // 4000 chords: 6e-6 mm from the circle; within one, a chord's slope moves the foot point by 1.4 mm · 0.8e-3.
        QVERIFY2(worst < 2e-3, qPrintable(QString::number(worst)));
    }

    void aBranchThatComesNearDoesNotTakeTheHandAway() {
        // Two long straights, 1.2 mm apart, joined far away: a hairpin.
        const GuideCurve curve = *GuideCurve::make({{0, 0, 50}, {100, 0, 50}, {100, 1.2, 50}, {0, 1.2, 50}},
                                                   {{1, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, 0, 0}});
        Guide edge = guideOf(GuideKind::curve);
        edge.curve = &curve;
        GuideRig<> rig;
        rig.use({edge});
        rig.feed({30, 0.1, 50});
        rig.rest(settled);
        rig.moveTo({40, 1.1, 50}); // nearer to the other branch
        QVERIFY(glm::length(rig.rest(settled).goal.tip - glm::dvec3(40, 0, 50)) < 1e-9);
    }

    void anOpenEdgeEndsWhereItEnds() {
        const GuideCurve curve = *GuideCurve::make({{0, 0, 50}, {10, 0, 50}}, {{1, 0, 0}, {1, 0, 0}});
        Guide edge = guideOf(GuideKind::curve);
        edge.curve = &curve;
        GuideRig<> rig;
        rig.use({edge});
        rig.feed({9, 0.5, 50});
        rig.rest(settled);
        rig.moveTo({12, 0.5, 50});
        QVERIFY(glm::length(rig.rest(settled).goal.tip - glm::dvec3(10, 0, 50)) < 1e-9);
        rig.moveTo({13.1, 0.5, 50});
        QCOMPARE(rig.rest(settled).held, 0U);
    }

    void theToolKeepsItsDistanceFromThePart() {
        QVERIFY(rc::check("clearance is the guide's distance, at the nearest such place", [] {
            const SphereSolid sphere{15.0};
            GuideRig<SphereSolid> rig(sphere);
            const double offset = randomNumber(0.0, 2.0);
            rig.use({guideOf(GuideKind::surface, offset)});
            const glm::dvec3 start = randomDirection() * (18.0 + offset + randomNumber(-1.5, 1.5));
            rig.feed(start - up(3.0)); // centre to tip
            rig.rest(settled);
            RC_ASSERT(rig.last.held == 1U);
            for (int leg = 0; leg < 4; ++leg) {
                const glm::dvec3 centre = rig.hand + up(3.0);
                const glm::dvec3 next =
                    glm::normalize(centre + randomPoint(4.0)) * (18.0 + offset + randomNumber(-1.5, 1.5));
                rig.moveTo(next - up(3.0));
                const glm::dvec3 nearest = glm::normalize(rig.hand + up(3.0)) * (18.0 + offset) - up(3.0);
                RC_ASSERT(std::abs(rig.field.clearance(rig.last.goal.tip) - offset) < 1e-3);
                RC_ASSERT(glm::length(rig.last.goal.tip - nearest) < 0.02);
            }
        }));
    }

    void aSurfaceGuideSettlesInAPocketsCorner() {
        const PocketSolid pocket;
        GuideRig<PocketSolid> rig(pocket);
        rig.use({guideOf(GuideKind::surface, 0.5)});
        rig.feed({0, 0, -10.5}); // a millimetre too deep
        rig.rest(settled);
        QCOMPARE(rig.last.held, 1U);
        rig.moveTo({5.2, 3.2, -10.2}, 20.0); // into the corner of floor and two walls
        rig.rest(settled);
        QVERIFY(glm::length(rig.last.goal.tip - glm::dvec3(4.5, 2.5, -9.5)) < 1e-2);
    }

    void aPlaneAndTheSurfaceGiveAContour() {
        const SphereSolid sphere{15.0};
        GuideRig<SphereSolid> rig(sphere);
        rig.use({planeGuide(up(2.0), up(1)), guideOf(GuideKind::surface, 1.0)});
        const double ring = std::sqrt(19.0 * 19.0 - 5.0 * 5.0); // of the ball's centre at z = 2 + 3
        rig.feed({ring + 0.5, 0, 2.8});
        rig.rest(settled);
        QCOMPARE(rig.last.held, 3U);
        for (int i = 0; i <= 500; ++i) {
            const double angle = 0.002 * i;
            rig.feed({(ring + 0.5) * std::cos(angle), (ring + 0.5) * std::sin(angle), 2.8});
            QVERIFY(std::abs(rig.last.goal.tip.z - 2.0) < 1e-6);
            QVERIFY(std::abs(rig.field.clearance(rig.last.goal.tip) - 1.0) < 1e-4);
        }
    }

    void thePullIsAFadingMagnets() {
        GuideRig<> rig;
        rig.use({planeGuide(up(50), up(1))});
        const double strongest = 0.5 * 2.4 / 240.0 * 1000.0; // half the force divided by the spring constant
        rig.feed(up(50));
        rig.rest(settled);
        for (double z = -2.99; z < 3.0; z += 0.05) {
            rig.moveTo(up(50.0 + z), 20.0);
            QVERIFY(std::abs(rig.last.pull.z + std::copysign(pullAt(std::abs(z), strongest), z)) < 1e-9);
        }
    }

    void aDamagedGuideIsRefused() {
        QVERIFY(checkGuide(planeGuide({}, up(1))));
        Guide guide = planeGuide({}, up(1));
        guide.direction = up(2);
        QCOMPARE(checkGuide(guide).error().code, ErrorCode::argumentInvalid);
        guide = guideOf(GuideKind::levels, 0.0);
        QCOMPARE(checkGuide(guide).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(checkGuide(guideOf(GuideKind::curve)).error().code, ErrorCode::argumentInvalid);
        guide = guideOf(GuideKind::axis);
        guide.lead = std::nan("");
        QCOMPARE(checkGuide(guide).error().code, ErrorCode::argumentInvalid);
        QVERIFY(!GuideCurve::make({{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}));
        QVERIFY(!GuideCurve::make({{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {0, 0, 0}}));
        QVERIFY(!GuideCurve::make({{0, 0, 0}}, {{1, 0, 0}}));
        // Finite, but with a length that does not give a direction.
        QVERIFY(!GuideCurve::make({{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {1e200, 0, 0}}));
        QVERIFY(!GuideCurve::make({{0, 0, 0}, {1e-200, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}));
        QVERIFY(!GuideCurve::make({{-1e200, 0, 0}, {1e200, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}));
    }
};

BURIN_TEST(TestGuides, NoApplication)

} // namespace burin::tst_guides

#include "tst_guides.moc"
