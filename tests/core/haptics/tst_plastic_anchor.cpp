// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/plastic_anchor.h"
#include "tests/oracles/random_number.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_plastic_anchor {

using namespace burin::test;

namespace {

constexpr double stiffness = 0.32, mostForce = 2.4; // N/mm, N

} // namespace

class PlasticAnchorTest : public QObject {
    Q_OBJECT
private slots:
    void aSpringUpToItsYieldAndNoFurther() {
        PlasticAnchor anchor(stiffness, mostForce);
        glm::dvec3 force(0.0);
        for (int i = 1; i <= 100; ++i) {
            force = anchor.drag({0.02, 0, 0}, {0.5});
            const double spring = stiffness * 0.02 * i;
            QVERIFY(std::abs(force.x + std::min(0.5, spring)) < 1e-12);
        }
        // At rest the force holds, without creep or decay.
        for (int i = 0; i < 1000; ++i) QVERIFY(glm::length(anchor.drag(glm::dvec3(0.0), {0.5}) - force) < 1e-12);
        // When released, it returns the energy of its extension and no more.
        for (int i = 0; i < 79; ++i) force = anchor.drag({-0.02, 0, 0}, {0.5});
        QVERIFY(std::abs(force.x) < 0.02);
    }

    void aYieldThatFallsIsFollowedAtOnce() {
        PlasticAnchor anchor(stiffness, mostForce);
        for (int i = 0; i < 200; ++i) anchor.drag({0.02, 0, 0}, {1.0});
        QVERIFY(std::abs(anchor.drag(glm::dvec3(0.0), {0.4}).x + 0.4) < 1e-12);
        QCOMPARE(anchor.drag({0.02, 0, 0}, {0.0}), glm::dvec3(0.0));
    }

    /// Into harder material: the force rises at once, as long as the energy was spent by dragging before.
    void aYieldThatGrowsIsFollowedAtOnceWhileItDrags() {
        PlasticAnchor anchor(stiffness, mostForce);
        for (int i = 0; i < 500; ++i) anchor.drag({0.02, 0, 0}, {0.5}); // 8 mm of drag at 0.5 N: 4 N·mm
        QVERIFY(std::abs(anchor.drag({0.02, 0, 0}, {1.0}).x + 1.0) < 1e-12);
        // A tool that is not dragged is not pushed: it was at rest below the yield force.
        PlasticAnchor held(stiffness, mostForce);
        for (int i = 0; i < 50; ++i) held.drag({0.02, 0, 0}, {0.5});
        const glm::dvec3 before = held.drag(glm::dvec3(0.0), {0.5});
        QVERIFY(glm::length(held.drag(glm::dvec3(0.0), {1.0}) - before) < 1e-12);
    }

    void withoutCreditTheForceRisesAsTheToolGoesOn() {
        PlasticAnchor anchor(stiffness, mostForce);
        anchor.drag({0.02, 0, 0}, {0.001}); // it drags a little
        const double force = -anchor.drag({0.02, 0, 0}, {2.0}).x;
        QVERIFY(force < 0.02);
    }

    /// Whatever the motion of the hand and the yield force, the work that the hand gets back is at most what it put in,
    /// except for half of k d² per tick.
    void itCanNotDrive() {
        QVERIFY(rc::check([] {
            PlasticAnchor anchor(stiffness, mostForce);
            glm::dvec3 force(0.0);
            double work = 0.0, leak = 0.0, yield = 0.0; // N·mm that the hand put in
            for (int i = 0; i < 400; ++i) {
                if (*rc::gen::inRange(0, 8) == 0) yield = randomNumber(0.0, mostForce);
                const glm::dvec3 motion(randomNumber(-0.1, 0.15), randomNumber(-0.05, 0.05), randomNumber(-0.05, 0.05));
                work -= glm::dot(force, motion);
                leak += 0.5 * stiffness * glm::dot(motion, motion);
                force = anchor.drag(motion, {yield});
                RC_ASSERT(glm::length(force) <= yield + 1e-9);
                const double spring = 0.5 * glm::dot(force, force) / stiffness;
                RC_ASSERT(spring <= work + leak + 1e-9);
            }
        }));
    }

    void anotherStiffnessKeepsTheForce() {
        PlasticAnchor anchor(stiffness, mostForce);
        for (int i = 0; i < 50; ++i) anchor.drag({0.02, 0.01, 0}, {0.5});
        const glm::dvec3 before = anchor.drag(glm::dvec3(0.0), {0.5});
        anchor.setStiffness(0.1);
        QVERIFY(glm::length(anchor.drag(glm::dvec3(0.0), {0.5}) - before) < 1e-12);
        QVERIFY(std::abs(glm::length(anchor.drag({-0.1, 0, 0}, {0.5}) - before) - 0.01) < 1e-12);
    }

    /// A wall holds a tool that slides on it, and releases one that moves away.
    void acrossAWallItYieldsAtLess() {
        PlasticAnchor anchor(stiffness, mostForce);
        glm::dvec3 force(0.0);
        for (int i = 0; i < 100; ++i) force = anchor.drag({0.02, 0, 0.05}, {0.3, {0, 0, 1}, 0.0});
        QVERIFY(std::abs(force.x + 0.3) < 1e-3);
        QCOMPARE(force.z, 0.0);
        for (int i = 0; i < 200; ++i) force = anchor.drag({0, 0, 0.05}, {0.3, {0, 0, 1}, 0.1});
        QVERIFY(std::abs(force.z + 0.1) < 1e-9);
    }

    void withoutStiffnessThereIsNoForce() {
        PlasticAnchor anchor(0.0, 0.0);
        QCOMPARE(anchor.drag({1.0, 0, 0}, {1.0}), glm::dvec3(0.0));
    }
};

BURIN_TEST(PlasticAnchorTest, NoApplication)

} // namespace burin::tst_plastic_anchor

#include "tst_plastic_anchor.moc"
