// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The handles of a gizmo: what the pointer grips, and what a drag amounts to.
#include "core/base/units.h"
#include "tests/test_program.h"
#include "ui/scene/gizmo_drag.h"
#include "ui/scene/gizmo_geometry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace burin::tst_gizmo {

namespace {

const QSizeF size(1000.0, 700.0);
constexpr GizmoSteps exact{0.0, 0.0};

CameraView someView(std::mt19937& random, bool parallel) {
    std::uniform_real_distribution<double> turn(-pi, pi), rise(-1.4, 1.4), far(300.0, 900.0), place(-20.0, 20.0);
    return {
        {place(random), place(random), place(random)}, turn(random), rise(random), far(random), parallel ? 0.0 : 1.0};
}

/// From the eye through a point.
Sight through(const CameraView& view, const glm::dvec3& point) {
    return sightThrough(view, size, appearanceOf(view, size, point));
}

bool near(const glm::dvec3& one, const glm::dvec3& other, double within = 1e-6) {
    return glm::distance(one, other) <= within;
}

} // namespace

class TestGizmo : public QObject {
    Q_OBJECT
private slots:
    /// The pointer goes from one point of the axis to another one: the object moves by what is between them.
    void anArrowMovesByTheDistanceOnItsAxis() {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> along(-40.0, 40.0);
        for (int i = 0; i < 300; ++i) {
            const CameraView view = someView(random, i % 2 == 0);
            const glm::dvec3 centre = view.focus + 0.25 * glm::dvec3(along(random), along(random), along(random));
            const GizmoHandle handle{GizmoPart::arrow, i % 3};
            const std::vector<GizmoHandle> offered = offeredHandles({centre}, view);
            if (std::ranges::find(offered, handle) == offered.end()) continue;
            const glm::dvec3 axis = axisDirection(handle.axis);
            const double from = along(random), to = along(random);
            GizmoDrag drag(handle, centre, through(view, centre + from * axis), 10.0);
            drag.follow(through(view, centre + along(random) * axis), 1.0);
            drag.follow(through(view, centre + to * axis), 1.0);
            QVERIFY(near(drag.motion(exact).shift, (to - from) * axis, 1e-5));
            QCOMPARE(drag.motion(exact).angle, 0.0);
        }
    }

    void aSquareMovesInItsPlane() {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> along(-30.0, 30.0);
        for (int i = 0; i < 300; ++i) {
            const CameraView view = someView(random, i % 2 == 0);
            const glm::dvec3 centre = view.focus + 0.25 * glm::dvec3(along(random), along(random), along(random));
            const GizmoHandle handle{GizmoPart::square, i % 3};
            if (std::abs(towardsEye(view, centre)[handle.axis]) < 0.17) continue;
            const auto inPlane = [&] {
                glm::dvec3 offset(along(random), along(random), along(random));
                offset[handle.axis] = 0.0;
                return offset;
            };
            const glm::dvec3 from = inPlane(), to = inPlane();
            GizmoDrag drag(handle, centre, through(view, centre + from), 10.0);
            drag.follow(through(view, centre + to), 1.0);
            QVERIFY(near(drag.motion(exact).shift, to - from, 1e-5));
        }
    }

    /// Twice round in steps: two whole turns, not none.
    void aRingTurnsByTheAngleInItsPlane() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> along(-30.0, 30.0), turn(-pi, pi);
        for (int i = 0; i < 300; ++i) {
            const CameraView view = someView(random, i % 2 == 0);
            const glm::dvec3 centre = view.focus + 0.25 * glm::dvec3(along(random), along(random), along(random));
            const GizmoHandle handle{GizmoPart::ring, i % 3};
            if (std::abs(towardsEye(view, centre)[handle.axis]) < 0.35) continue;
            const glm::dvec3 u = axisDirection((handle.axis + 1) % 3), v = axisDirection((handle.axis + 2) % 3);
            const auto at = [&](double angle) {
                return through(view, centre + 12.0 * (std::cos(angle) * u + std::sin(angle) * v));
            };
            const double from = turn(random), whole = 4.0 * pi + turn(random);
            GizmoDrag drag(handle, centre, at(from), 12.0);
            for (int step = 1; step <= 20; ++step) drag.follow(at(from + whole * step / 20.0), 1.0);
            QVERIFY(std::abs(drag.motion(exact).angle - whole) < 1e-6);
            QCOMPARE(drag.motion(exact).shift, glm::dvec3(0.0));
        }
    }

    /// Seen from its edge, a ring turns by the distance along its tangent over its radius.
    void aRingSeenFromItsEdgeFollowsItsTangent() {
        const glm::dvec3 centre(3.0, -4.0, 5.0);
        // The eye is on the -Y side; a ring about Z is seen as a line along X.
        const auto sight = [&](double x) { return Sight{centre + glm::dvec3(x, -500.0, 1.0), {0.0, 1.0, 0.0}, true}; };
        GizmoDrag drag({GizmoPart::ring, 2}, centre, sight(-2.0), 25.0);
        drag.follow(sight(8.0), 1.0);
        QVERIFY(std::abs(drag.motion(exact).angle - 10.0 / 25.0) < 1e-9);
    }

    void sightLinesThatTellNothingMoveNothing() {
        const glm::dvec3 centre(0.0);
        const Sight along{{1.0, 2.0, 500.0}, {0.0, 0.0, -1.0}, true}, other{{30.0, 2.0, 500.0}, {0.0, 0.0, -1.0}, true};
        GizmoDrag arrow({GizmoPart::arrow, 2}, centre, along, 10.0);
        arrow.follow(other, 1.0);
        QCOMPARE(arrow.motion(exact), GizmoMotion{});
        GizmoDrag square({GizmoPart::square, 0}, centre, along, 10.0); // the plane of Y and Z, seen from its edge
        square.follow(other, 1.0);
        QCOMPARE(square.motion(exact), GizmoMotion{});
        // The plane lies behind the eye.
        QVERIFY(!onPlane({{0.0, 0.0, 10.0}, {0.0, 0.0, 1.0}}, centre, {0.0, 0.0, 1.0}));
    }

    void finePartsAndStepsAreKept() {
        const auto sight = [](double x) { return Sight{{x, 0.0, 500.0}, {0.0, 0.0, -1.0}, true}; };
        GizmoDrag drag({GizmoPart::arrow, 0}, glm::dvec3(0.0), sight(10.0), 10.0);
        drag.follow(sight(17.3), 1.0);
        QVERIFY(std::abs(drag.motion(exact).shift.x - 7.3) < 1e-9);
        QVERIFY(std::abs(drag.motion({1.0, 0.1}).shift.x - 7.0) < 1e-9);
        drag.follow(sight(27.3), 0.1); // no jump where fine positioning begins
        QVERIFY(std::abs(drag.motion(exact).shift.x - 8.3) < 1e-9);
        QVERIFY(std::abs(drag.motion({2.54, 0.1}).shift.x - 3 * 2.54) < 1e-9);
    }

    /// On the line of a handle the pointer grips it, or one that is nearer to the eye; beside all, nothing.
    void theNearestHandleIsGripped() {
        std::mt19937 random(4);
        for (int i = 0; i < 200; ++i) {
            const CameraView view = someView(random, i % 2 == 0);
            const Gizmo gizmo{view.focus + glm::dvec3(3.0, 2.0, -1.0), i % 5 == 0};
            const double pixel = pixelAt(view, size, gizmo.centre);
            const glm::dvec3 eye = towardsEye(view, gizmo.centre);
            const std::vector<GizmoHandle> offered = offeredHandles(gizmo, view);
            for (const GizmoHandle& handle : offered) {
                QVERIFY(!gizmo.upright || handle.part != GizmoPart::ring || handle.axis == 2);
                const GizmoLine line = handleLine(gizmo, handle, view, pixel);
                const glm::dvec3 grip = 0.5 * (line[line.size() / 2] + line[line.size() / 2 - 1]);
                const auto found = handleAt(gizmo, view, size, appearanceOf(view, size, grip));
                QVERIFY(found && std::ranges::find(offered, *found) != offered.end());
                if (*found == handle) continue;
                double nearest = -1e9; // of what is gripped instead
                for (const glm::dvec3& point : handleLine(gizmo, *found, view, pixel))
                    nearest = std::max(nearest, glm::dot(point - gizmo.centre, eye));
                QVERIFY(nearest >= glm::dot(grip - gizmo.centre, eye) - 1e-9);
            }
            const QPointF beside = appearanceOf(view, size, gizmo.centre) + QPointF(140.0, 0.0);
            QVERIFY(!handleAt(gizmo, view, size, beside));
        }
    }

    /// Its size on the screen is the same in any view.
    void theSizeOnTheScreenIsConstant() {
        const Gizmo gizmo{{1.0, 2.0, 3.0}};
        for (const double distance : {50.0, 300.0, 4000.0}) {
            CameraView view{gizmo.centre, 0.0, 0.5 * pi, distance, 0.0};
            const GizmoLine line = handleLine(gizmo, {GizmoPart::arrow, 0}, view, pixelAt(view, size, gizmo.centre));
            const QPointF arrow = appearanceOf(view, size, line.back()) - appearanceOf(view, size, gizmo.centre);
            QVERIFY(std::abs(std::hypot(arrow.x(), arrow.y()) - gizmoArrowLength) < 1e-3);
        }
        // From above: no arrow towards the eye, and of the rings only the one that faces it.
        const CameraView above{gizmo.centre, 0.0, 0.5 * pi, 300.0, 0.0};
        const std::vector<GizmoHandle> expected{
            {GizmoPart::arrow, 0}, {GizmoPart::arrow, 1}, {GizmoPart::square, 2}, {GizmoPart::ring, 2}};
        QVERIFY(offeredHandles(gizmo, above) == expected);
    }
};

BURIN_TEST(TestGizmo, NoApplication)

} // namespace burin::tst_gizmo

#include "tst_gizmo.moc"
