// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "tests/core/haptics/guide_rig.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_guide_ways {

using namespace burin::test;

/// Guides that follow earlier tool motion: passes, and the direction of the motion for the tool's axis.
class TestGuideWays : public QObject {
    Q_OBJECT
private slots:
    void theNextPassKeepsItsDistanceFromTheLastOne() {
        GuideRig<> rig;
        const double stepOver = 0.8;
        rig.use({guideOf(GuideKind::stepOver, stepOver)});
        const auto wave = [](double x) { return 3.0 * std::sin(0.2 * x); };
        rig.feed({0, wave(0), 50});
        rig.cutting = true;
        for (double x = 0.0; x <= 40.0; x += 0.02) rig.feed({x, wave(x), 50.0});
        rig.cutting = false;
        rig.moveTo({40, wave(40) + 0.6, 55});
        rig.rest(settled);
        QCOMPARE(rig.last.held, 1U);
        rig.cutting = true;
        double worst = 0.0;
        glm::dvec3 pull = rig.last.pull;
        for (double x = 40.0; x >= 5.0; x -= 0.02) { // back next to it, with a hand tremor, at another height
            rig.feed({x, wave(x) + 0.7 + 0.2 * std::sin(17.0 * x), 52.0 + 0.1 * x});
            const glm::dvec3 change = rig.last.pull - pull;
            pull = rig.last.pull;
            if (x > 35.0) continue;
            QVERIFY(glm::length(change) < 0.15); // the hand moves up to 0.08 mm a tick
            double nearest = 1e9;
            for (double at = x - 3.0; at <= x + 3.0; at += 0.001)
                nearest = std::min(nearest, std::hypot(rig.last.goal.tip.x - at, rig.last.goal.tip.y - wave(at)));
            worst = std::max(worst, std::abs(nearest - stepOver));
        }
        QVERIFY2(worst < 0.01, qPrintable(QString::number(worst)));
        // That pass is now the last one, and the next continues beyond it.
        rig.cutting = false;
        rig.moveTo({10, rig.last.goal.tip.y + 0.5, 52});
        rig.rest(3 * settled);
        QVERIFY(rig.last.goal.tip.y > wave(10) + 1.5 * stepOver);
    }

    void leadAndTiltTurnTheAxisAsTheyAreDefined() {
        Guide axis = guideOf(GuideKind::axis);
        axis.lead = 10.0 * pi / 180.0;
        axis.tilt = 20.0 * pi / 180.0;
        GuideRig<> rig;
        rig.use({axis});
        rig.feed(up(50));
        glm::dvec3 before = rig.last.goal.axis;
        for (int i = 1; i <= 1000; ++i) {
            rig.feed({0.05 * i, 0, 50});
            const glm::dvec3 now = rig.last.goal.axis;
            QVERIFY(std::abs(glm::length(now) - 1.0) < 1e-12);
            QVERIFY(glm::length(now - before) <= AxisFollower::speed * period + 1e-9);
            before = now;
        }
        // Moving along +x with the normal +z: lead inclines towards +x, tilt to the left, which is +y.
        const glm::dvec3 expected(std::cos(axis.tilt) * std::sin(axis.lead), std::sin(axis.tilt),
                                  std::cos(axis.tilt) * std::cos(axis.lead));
        QVERIFY(glm::length(before - expected) < 1e-9);
        rig.use({});
        for (int i = 0; i < 1000; ++i) rig.feed(rig.hand, glm::normalize(glm::dvec3(0.1, 0, 1)));
        QVERIFY(glm::length(rig.last.goal.axis - glm::normalize(glm::dvec3(0.1, 0, 1))) < 1e-12);
    }

    void onASphereTheAxisStandsOnItsNormal() {
        const SphereSolid sphere{15.0};
        GuideRig<SphereSolid> rig(sphere);
        Guide axis = guideOf(GuideKind::axis);
        axis.onSurface = true;
        axis.lead = 0.2;
        rig.use({axis, guideOf(GuideKind::surface, 0.0)});
        const auto at = [](double angle) { return glm::dvec3(18 * std::sin(angle), 0, 18 * std::cos(angle) - 3); };
        rig.feed(at(0.0));
        for (int i = 0; i <= 1000; ++i) rig.feed(at(0.0005 * i));
        const double angle = 0.5;
        const glm::dvec3 normal(std::sin(angle), 0, std::cos(angle)), forward(std::cos(angle), 0, -std::sin(angle));
        const glm::dvec3 expected = std::cos(0.2) * normal + std::sin(0.2) * forward;
        // The direction of motion is measured over 0.5 mm of an arc of 18 mm.
        QVERIFY(glm::length(rig.last.goal.axis - expected) < 0.01);
    }
};

BURIN_TEST(TestGuideWays, NoApplication)

} // namespace burin::tst_guide_ways

#include "tst_guide_ways.moc"
