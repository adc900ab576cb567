// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/geometry/placement.h"
#include "tests/test_program.h"

#include <QtTest>
#include <glm/gtc/quaternion.hpp>
#include <rapidcheck.h>

#include <cmath>

namespace burin::tst_placement {

namespace {

double number(int most) {
    return *rc::gen::inRange(-1000 * most, 1000 * most + 1) / 1000.0;
}

glm::dvec3 vector(int most) {
    return {number(most), number(most), number(most)};
}

glm::dvec3 someDirection() {
    const glm::dvec3 direction = vector(1);
    return glm::length(direction) > 0.01 ? direction : glm::dvec3(0.0, 0.6, 0.8);
}

} // namespace

class TestPlacement : public QObject {
    Q_OBJECT

private slots:
    /// A quarter turn has no rounding errors at all: points on the grid stay on it.
    void quarterTurnsAreExact() {
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 about(0.0), along(0.0), to(0.0);
            about[axis] = 1.0;
            along[(axis + 1) % 3] = 1.0;
            to[(axis + 2) % 3] = 1.0;
            const Placement quarter = turnedAbout(about, 0.5 * pi, glm::dvec3(0.0));
            QCOMPARE(quarter.direction(along), to);
            Placement whole;
            for (int i = 0; i < 4; ++i) whole = combined(whole, turnedAbout(about, 0.5 * pi, {10.0, 20.0, 30.0}));
            QVERIFY(isNone(whole));
        }
        const Box box{{1.1, -2.2, 3.3}, {4.4, 5.5, 6.6}};
        const Box turned = boxAround(box, turnedAbout({1.0, 0.0, 0.0}, pi, box.centre()));
        QCOMPARE(turned.low.x, box.low.x);
        QVERIFY(glm::distance(turned.low, box.low) < 1e-14 && glm::distance(turned.high, box.high) < 1e-14);
    }

    /// glm's quaternions are the oracle.
    void turnsAreThoseOfQuaternions() {
        QVERIFY(rc::check("turns", [] {
            const glm::dvec3 axis = someDirection(), through = vector(100), place = vector(100);
            const double angle = number(4);
            const glm::dvec3 expected = glm::angleAxis(angle, glm::normalize(axis)) * (place - through) + through;
            const Placement turn = turnedAbout(axis, angle, through);
            RC_ASSERT(glm::distance(turn.point(place), expected) < 1e-9);
            RC_ASSERT(isSound(turn) && !mirrors(turn));
        }));
    }

    void whatIsDoneIsUndoneByTheInverse() {
        QVERIFY(rc::check("inverse", [] {
            const Placement first = turnedAbout(someDirection(), number(4), vector(100));
            const Placement second =
                combined(turnedAbout(someDirection(), number(4), vector(100)), movedBy(vector(1000)));
            const glm::dvec3 place = vector(100);
            RC_ASSERT(glm::distance(combined(first, second).point(place), second.point(first.point(place))) < 1e-8);
            RC_ASSERT(glm::distance(inverse(second).point(second.point(place)), place) < 1e-8);
        }));
    }

    void aDirectionIsTurnedTowardsAnother() {
        QVERIFY(rc::check("towards", [] {
            const glm::dvec3 from = someDirection();
            const glm::dvec3 to = *rc::gen::arbitrary<bool>() ? someDirection() : -from;
            const glm::dvec3 through = vector(100);
            const Placement turn = turnedTowards(from, to, through);
            RC_ASSERT(glm::distance(turn.direction(glm::normalize(from)), glm::normalize(to)) < 1e-9);
            RC_ASSERT(glm::distance(turn.point(through), through) < 1e-9);
            RC_ASSERT(isSound(turn) && !mirrors(turn));
        }));
        QVERIFY(isNone(turnedTowards({0.0, 0.0, -2.0}, {0.0, 0.0, -1.0}, {1.0, 2.0, 3.0})));
    }

    void mirrorsMirror() {
        const Placement mirror = mirroredAcross(1, {0.0, 3.0, 0.0});
        QVERIFY(mirrors(mirror) && isSound(mirror) && alongAxes(mirror));
        QCOMPARE(mirror.point({1.0, 5.0, 2.0}), glm::dvec3(1.0, 1.0, 2.0));
        QVERIFY(isNone(combined(mirror, mirror)));
    }

    void whatDoesNotKeepLengthsIsNoPlacement() {
        const double nothing = std::nan("");
        QVERIFY(!isSound({glm::dmat3(1.001), glm::dvec3(0.0)}));
        QVERIFY(!isSound({glm::dmat3(nothing), glm::dvec3(0.0)}));
        QVERIFY(!isSound({glm::dmat3(1.0), glm::dvec3(nothing)}));
        glm::dmat3 late(1.0);
        late[0][0] = nothing;
        QVERIFY(!isSound({late, glm::dvec3(0.0)}));
        QVERIFY(isSound({}));
    }
};

BURIN_TEST(TestPlacement, NoApplication)

} // namespace burin::tst_placement

#include "tst_placement.moc"
