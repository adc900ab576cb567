// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/pose.h"
#include "core/haptics/guides/last_pass.h"
#include "core/haptics/guides/polyline_tracker.h"
#include "core/setup/guide_curve.h"
#include "tests/oracles/random_number.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <algorithm>
#include <vector>

namespace burin::tst_guide_tracking {

using namespace burin::test;

namespace {

glm::dvec3 randomPoint(double half) {
    return {randomNumber(-half, half), randomNumber(-half, half), randomNumber(-half, half)};
}

double distanceTo(const std::vector<glm::dvec3>& line, const glm::dvec3& place) {
    double nearest = 1e300;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const glm::dvec3 side = line[i + 1] - line[i];
        const double share = std::clamp(glm::dot(place - line[i], side) / glm::dot(side, side), 0.0, 1.0);
        nearest = std::min(nearest, glm::length(place - line[i] - share * side));
    }
    return nearest;
}

std::vector<glm::dvec3> asVector(std::span<const glm::dvec3> points) {
    return {points.begin(), points.end()};
}

} // namespace

class TestGuideTracking : public QObject {
    Q_OBJECT
private slots:
    void searchingFindsTheNearestPointOfAll() {
        QVERIFY(rc::check("as trying every point does", [] {
            std::vector<glm::dvec3> points;
            const int count = *rc::gen::inRange(2, 40);
            for (int i = 0; i < count; ++i) points.push_back(randomPoint(10.0));
            const Polyline line{points, PolylineEnds::stop};
            PolylineTracker tracker;
            for (int i = 0; i < 5; ++i) {
                const glm::dvec3 place = randomPoint(12.0);
                const PolylineFoot& foot = tracker.search(line, place); // fewer segments than it examines
                RC_ASSERT(std::abs(foot.distance - glm::length(foot.point - place)) < 1e-12);
                RC_ASSERT(foot.distance <= distanceTo(points, place) + 1e-9);
            }
        }));
    }

    void aLongPolylineIsSearchedInTurn() {
        std::vector<glm::dvec3> points;
        for (int i = 0; i <= 4000; ++i) points.emplace_back(0.1 * i, i % 2 == 0 ? 0.0 : 0.05, 0.0);
        const Polyline line{points, PolylineEnds::stop};
        PolylineTracker tracker;
        tracker.search(line, {0, 0, 0});
        const glm::dvec3 place(333.33, 1.0, 0.0);
        for (std::size_t i = 0; i <= 4000 / PolylineTracker::searchedSegments + 1; ++i) tracker.search(line, place);
        QVERIFY(std::abs(tracker.foot().point.x - 333.33) < 0.1);
        QVERIFY(tracker.foot().distance <= 1.0);
    }

    void aStraightEndGoesOn() {
        const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}};
        PolylineTracker tracker;
        QVERIFY(glm::length(tracker.search({points, PolylineEnds::goOn}, {-7, 2, 0}).point - glm::dvec3(-7, 0, 0)) <
                1e-12);
        QVERIFY(glm::length(tracker.search({points, PolylineEnds::goOn}, {12, 11, 0}).point - glm::dvec3(12, 11, 0)) <
                1e-9);
    }

    void aClosedOneIsFollowedOverItsJoint() {
        const std::vector<glm::dvec3> square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}};
        const Polyline line{square, PolylineEnds::join};
        PolylineTracker tracker;
        tracker.search(line, {1, -0.5, 0});
        for (int i = 0; i < 100; ++i) tracker.follow(line, {1 - 0.015 * i, -0.5 + 0.015 * i, 0}, 0.1);
        QVERIFY(glm::length(tracker.foot().point - glm::dvec3(0, 0.985, 0)) < 1e-9);
    }

    void everyTipOfAPassLiesWithinTheStatedBound() {
        QVERIFY(rc::check("of the polyline that is kept", [] {
            LastPass pass;
            std::vector<glm::dvec3> tips;
            glm::dvec3 tip(0.0), way(0.02, 0.0, 0.0);
            const int count = *rc::gen::inRange(200, 2000);
            for (int i = 0; i < count; ++i) {
                way = clampLength(way + randomPoint(0.004), 0.05);
                tips.push_back(tip += way);
                pass.add(tip);
            }
            pass.finish();
            const std::vector<glm::dvec3> kept = asVector(pass.points());
            RC_PRE(!kept.empty());
            RC_ASSERT(kept.size() < tips.size());
            for (std::size_t i = 0; i < tips.size(); i += 7)
                RC_ASSERT(distanceTo(kept, tips[i]) <= pass.errorBound() + 1e-12);
        }));
    }

    void aVeryLongPassIsKeptMoreRoughlyAndSaysSo() {
        LastPass pass;
        std::vector<glm::dvec3> tips;
        for (int i = 0; i < 40'000; ++i) {
            const double angle = 0.02 * i;
            tips.emplace_back(0.004 * i, std::sin(angle), std::cos(1.3 * angle));
            pass.add(tips.back());
        }
        pass.finish();
        QVERIFY(pass.points().size() <= LastPass::capacity);
        QVERIFY(pass.errorBound() > LastPass::tolerance);
        QVERIFY(pass.errorBound() < 0.2);
        const std::vector<glm::dvec3> kept = asVector(pass.points());
        for (std::size_t i = 0; i < tips.size(); i += 97) QVERIFY(distanceTo(kept, tips[i]) <= pass.errorBound());
    }

    void aTapIsNoPass() {
        LastPass pass;
        for (int i = 0; i < 100; ++i) pass.add({0.02 * i, 0, 0});
        pass.finish();
        const std::vector<glm::dvec3> before = asVector(pass.points());
        for (int i = 0; i < 20; ++i) pass.add({5, 0.02 * i, 0});
        pass.finish();
        QCOMPARE(asVector(pass.points()).size(), before.size());
        QCOMPARE(pass.number(), 1U);
    }
};

BURIN_TEST(TestGuideTracking, NoApplication)

} // namespace burin::tst_guide_tracking

#include "tst_guide_tracking.moc"
