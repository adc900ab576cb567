// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/pose_steps.h"
#include "tests/core/tool/random_sweeps.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_pose_steps {

using random::real;

namespace {

ToolPose randomPose() {
    return {{real(-9.0, 9.0), real(-9.0, 9.0), real(-9.0, 9.0)}, random::axis()};
}

/// Rotates `axis` by `angle` rad about a line perpendicular to it.
glm::dvec3 leaned(const glm::dvec3& axis, double angle) {
    const glm::dvec3 any(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 1.0));
    const glm::dvec3 across = any - glm::dot(any, axis) * axis;
    if (glm::length(across) < 1e-3) return axis;
    return std::cos(angle) * axis + std::sin(angle) * glm::normalize(across);
}

/// The position at a pose of a point of the tool: the tool does not spin about its own axis, so points are carried
/// along with the axis by the smallest rotation from its previous direction.
glm::dvec3 carried(const ToolPose& from, const ToolPose& to, const glm::dvec3& point) {
    const glm::dvec3 turn = glm::cross(from.axis, to.axis);
    const double sine = glm::length(turn), cosine = glm::dot(from.axis, to.axis);
    const glm::dvec3 q = point - from.tip;
    if (sine < 1e-15) return to.tip + q;
    const glm::dvec3 about = turn / sine;
    return to.tip + cosine * q + sine * glm::cross(about, q) + (1.0 - cosine) * glm::dot(about, q) * about;
}

} // namespace

class PoseStepsTest : public QObject {
    Q_OBJECT

private slots:
    void standingAxisIsOneStep() {
        const ToolPose from{{1.0, 2.0, 3.0}, {0.0, 0.6, 0.8}}, to{{4.0, 2.0, 3.0}, {0.0, 0.6, 0.8}};
        const PoseSteps steps(from, to, 30.0, 0.01);
        QCOMPARE(steps.count(), 1);
        QVERIFY(steps.step(0).fromTip == from.tip && steps.step(0).toTip == to.tip && steps.step(0).axis == from.axis);
    }

    void poseThatIsNotFiniteGivesNone() {
        const ToolPose good, bad{{0.0, std::nan(""), 0.0}, {0.0, 0.0, 1.0}};
        QCOMPARE(PoseSteps(good, bad, 30.0, 0.01).count(), 0);
        QCOMPARE(PoseSteps(bad, good, 30.0, 0.01).count(), 0);
    }

    void opposedAxesAreTurnedThrough() {
        const PoseSteps steps({{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, {{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}}, 10.0, 0.1);
        QVERIFY(steps.count() > 157); // pi · 10 / 0.2
        for (std::int32_t k = 0; k < steps.count(); ++k) QCOMPARE(glm::length(steps.step(k).axis), 1.0);
    }

    /// Ends are bitwise equal and joints have no gap: no material is left between two steps or two ticks.
    void stepsJoin() {
        QVERIFY(rc::check("joints", [] {
            const ToolPose from = randomPose();
            const ToolPose to{from.tip + random::move(), leaned(from.axis, real(0.0, 0.3))};
            const PoseSteps steps(from, to, 20.0, 0.05);
            RC_ASSERT(steps.step(0).fromTip == from.tip && steps.step(0).axis == from.axis);
            const PoseStep last = steps.step(steps.count() - 1);
            RC_ASSERT(last.toTip == to.tip && last.axis == to.axis);
            for (std::int32_t k = 1; k < steps.count(); ++k)
                RC_ASSERT(steps.step(k).fromTip == steps.step(k - 1).toTip);
        }));
    }

    /// The bound: at every moment each point of the tool is within the tolerance of its position in the true motion.
    void noPointStraysFartherThanTheTolerance() {
        QVERIFY(rc::check("deviation", [] {
            const double reach = real(1.0, 60.0), tolerance = real(0.001, 0.2);
            const ToolPose from = randomPose();
            const ToolPose to{from.tip + random::move(), leaned(from.axis, real(0.0, 1.0))};
            const PoseSteps steps(from, to, reach, tolerance);
            double worst = 0.0;
            for (int sample = 0; sample < 60; ++sample) {
                const double part = real(0.0, 1.0), place = part * (steps.count() - 1);
                const auto k = static_cast<std::int32_t>(std::lround(place));
                const PoseStep step = steps.step(k);
                const ToolPose truly = steps.poseAt(part);
                // The step covers the time k - 1/2 … k + 1/2, truncated at both ends of the motion.
                const double begin = std::max(k - 0.5, 0.0), end = std::min(k + 0.5, steps.count() - 1.0);
                const glm::dvec3 tip = step.fromTip + (place - begin) / (end - begin) * (step.toTip - step.fromTip);
                glm::dvec3 q(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 1.0));
                if (glm::length(q) < 1e-3) continue;
                q *= reach / glm::length(q);
                const glm::dvec3 there = truly.tip + q;
                worst = std::max(worst, glm::length(carried(truly, {tip, step.axis}, there) - there));
            }
            RC_ASSERT(worst <= tolerance + 1e-12);
        }));
    }

    /// The count is no gross overestimate either: half as many steps would not have kept twice the tolerance.
    void stepsAreNotMoreThanTheBoundNeeds() {
        QVERIFY(rc::check("count", [] {
            const double reach = real(5.0, 60.0), tolerance = real(0.001, 0.01), angle = real(0.05, 1.0);
            const ToolPose from = randomPose(), to{from.tip, leaned(from.axis, angle)};
            const PoseSteps steps(from, to, reach, tolerance);
            const double turn = std::acos(std::clamp(glm::dot(from.axis, to.axis), -1.0, 1.0));
            RC_ASSERT(steps.count() <= 0.5 * turn * reach / tolerance + 3.0);
        }));
    }

    void reachIsThatOfTheFarthestPoint() {
        const std::vector<RevolvedPiece> pieces{{0.0, 4.0, 3.0, 3.0, 3.0}, bulgingPiece(4.0, 8.0, 0.0, 6.0, 2.5)};
        QCOMPARE(reachOf(pieces), std::hypot(2.5, 8.0));
    }
};

BURIN_TEST(PoseStepsTest, NoApplication)

} // namespace burin::tst_pose_steps

#include "tst_pose_steps.moc"
