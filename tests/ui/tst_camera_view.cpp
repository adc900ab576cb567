// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "tests/test_program.h"
#include "ui/scene/camera_motion.h"

#include <QTest>

#include <random>

namespace burin::tst_camera_view {

namespace {

const QSizeF size(1280.0, 800.0);

CameraView someView(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> turn(-pi, pi), rise(-1.5, 1.5), far(50.0, 900.0), place(-40.0, 40.0);
    return {{place(random), place(random), place(random)}, turn(random), rise(random), far(random)};
}

double pixels(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

glm::dvec3 placeUnder(const CameraView& view, const QPointF& position, double share) {
    const Sight sight = sightThrough(view, size, position);
    return sight.origin + sight.direction * (view.distance * share);
}

} // namespace

class TestCameraView : public QObject {
    Q_OBJECT

private slots:
    void sightAndAppearanceAreInverse() {
        for (unsigned seed = 0; seed < 200; ++seed) {
            const CameraView view = someView(seed);
            for (const QPointF& at :
                 {QPointF(0.0, 0.0), QPointF(1279.0, 10.0), QPointF(640.0, 400.0), QPointF(300.5, 799.0)})
                QVERIFY(pixels(appearanceOf(view, size, placeUnder(view, at, 0.7)), at) < 1e-6);
        }
    }

    /// In any projection, also in those between parallel and perspective.
    void pixelsAndSightsAgreeInBothProjections() {
        for (unsigned seed = 0; seed < 300; ++seed) {
            CameraView view = someView(seed);
            view.convergence = seed % 3 == 0 ? 0.0 : seed % 3 == 1 ? 1.0 : 0.37;
            const glm::dvec3 right = axesOf(view).right;
            for (const QPointF& at : {QPointF(0.0, 0.0), QPointF(1279.0, 10.0), QPointF(640.0, 400.0)}) {
                const Sight sight = sightThrough(view, size, at);
                const glm::dvec3 place = besideFocus(view, sight);
                QVERIFY(std::abs(glm::dot(place - view.focus, axesOf(view).back)) < 1e-6);
                for (const double nearer : {-0.4, 0.0, 0.6}) {
                    const glm::dvec3 on = place - sight.direction * (nearer * view.distance);
                    QVERIFY(pixels(appearanceOf(view, size, on), at) < 1e-5);
                    // A pixel there has the reported width.
                    const QPointF beside = appearanceOf(view, size, on + right * pixelAt(view, size, on));
                    QVERIFY(pixels(beside, at + QPointF(1.0, 0.0)) < 1e-5);
                }
            }
        }
    }

    /// In a parallel view nearer is not larger: from above, x and y in the picture are x and y of the world at one
    /// scale.
    void aParallelTopViewIsAPlan() {
        CameraView top = turnedTo({}, StandardView::top);
        top.convergence = 0.0;
        top.focus = {5.0, -3.0, 0.0};
        const double scale = 2.0 * std::tan(0.5 * cameraViewAngle) * top.distance / size.height(); // mm a pixel
        for (const glm::dvec3& place : {glm::dvec3(0.0, 0.0, 900.0), glm::dvec3(17.0, 8.0, -40.0)}) {
            const QPointF expected(640.0 + (place.x - 5.0) / scale, 400.0 - (place.y + 3.0) / scale);
            QVERIFY(pixels(appearanceOf(top, size, place), expected) < 1e-6);
            const Sight sight = sightThrough(top, size, expected);
            QVERIFY(glm::distance(glm::dvec2(sight.origin), glm::dvec2(place)) < 1e-6);
            QVERIFY(sight.direction == glm::dvec3(0.0, 0.0, -1.0) ||
                    glm::distance(sight.direction, {0.0, 0.0, -1.0}) < 1e-9);
            QVERIFY(sight.origin.z > 1000.0); // in front of everything in the scene
        }
    }

    void parallelViewsTurnScaleAndMoveAboutThePointer() {
        for (unsigned seed = 0; seed < 200; ++seed) {
            CameraView view = someView(seed);
            view.convergence = 0.0;
            const QPointF at(100.0 + seed, 650.0 - seed);
            const glm::dvec3 pivot =
                besideFocus(view, sightThrough(view, size, at)) + axesOf(view).back * (seed - 70.0);
            QVERIFY(pixels(appearanceOf(zoomed(view, 0.6, pivot), size, pivot), at) < 1e-6);
            QVERIFY(std::abs(pixelAt(zoomed(view, 0.6, pivot), size, pivot) / pixelAt(view, size, pivot) - 0.6) < 1e-9);
            QVERIFY(pixels(appearanceOf(orbited(view, 0.01 * seed, 0.3, pivot), size, pivot), at) < 1e-6);
            const QPointF moved = appearanceOf(panned(view, size, {-120.0, 45.0}, pivot), size, pivot);
            QVERIFY(pixels(moved, at + QPointF(-120.0, 45.0)) < 1e-6);
        }
    }

    void theChangeOfProjectionKeepsWhatIsAsFarAsThePivot() {
        for (unsigned seed = 0; seed < 200; ++seed) {
            const CameraView view = someView(seed);
            const glm::dvec3 pivot = placeUnder(view, {300.0, 500.0}, 0.8), right = axesOf(view).right;
            for (const double convergence : {0.0, 0.5, 1.0}) {
                const CameraView other = converged(view, convergence, pivot);
                for (const glm::dvec3& place : {pivot, pivot + 7.0 * right})
                    QVERIFY(pixels(appearanceOf(other, size, place), appearanceOf(view, size, place)) < 1e-6);
            }
        }
    }

    /// Straight views are parallel projections. Once turned, they become the projection that the user chose, and the
    /// point that was gripped stays under the pointer.
    void straightViewsAreParallelUntilTheyAreTurned() {
        using namespace std::chrono_literals;
        for (const bool chosen : {false, true}) {
            CameraMotion motion;
            motion.setSize(size);
            motion.setContent({{-10.0, -10.0, 0.0}, {10.0, 10.0, 10.0}});
            motion.setParallel(chosen, {}, 0ms);
            QCOMPARE(isParallel(motion.view()), chosen);
            for (const StandardView straight : {StandardView::top, StandardView::front, StandardView::left}) {
                motion.turnTo(straight, {}, 0ms);
                QVERIFY(isParallel(motion.view()));
                motion.zoom(1.0, motion.view().focus);
                QVERIFY(isParallel(motion.view()));
                const glm::dvec3 gripped(6.0, -5.0, 10.0);
                const QPointF at = appearanceOf(motion.view(), size, gripped);
                motion.beginDrag(CameraMotion::Drag::pan, at, gripped);
                motion.drag(at + QPointF(30.0, 0.0));
                motion.endDrag();
                QVERIFY(isParallel(motion.view()));
                motion.beginDrag(CameraMotion::Drag::orbit, at, gripped);
                motion.drag(at + QPointF(20.0, 12.0));
                motion.endDrag();
                QCOMPARE(isParallel(motion.view()), chosen);
                QVERIFY(pixels(appearanceOf(motion.view(), size, gripped), at + QPointF(30.0, 0.0)) < 1e-6);
            }
            motion.turnTo(StandardView::isometric, {}, 0ms);
            QCOMPARE(isParallel(motion.view()), chosen);
        }
    }

    void aPlaceToTheRightAppearsToTheRightAndAboveAbove() {
        const CameraView front = turnedTo({}, StandardView::front);
        const QPointF middle = appearanceOf(front, size, {0.0, 0.0, 0.0});
        QVERIFY(pixels(middle, QPointF(640.0, 400.0)) < 1e-9);
        QVERIFY(appearanceOf(front, size, {10.0, 0.0, 0.0}).x() > middle.x());
        QVERIFY(appearanceOf(front, size, {0.0, 0.0, 10.0}).y() < middle.y());
        const CameraView top = turnedTo({}, StandardView::top);
        QVERIFY(appearanceOf(top, size, {0.0, 10.0, 0.0}).y() < middle.y()); // y is up in the picture, x to the right
        QVERIFY(appearanceOf(top, size, {10.0, 0.0, 0.0}).x() > middle.x());
    }

    void standardViewsLookTheRightWay() {
        const auto back = [](StandardView view) { return axesOf(turnedTo({}, view)).back; };
        const auto is = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b) < 1e-12; };
        QVERIFY(is(back(StandardView::top), {0.0, 0.0, 1.0}));
        QVERIFY(is(back(StandardView::bottom), {0.0, 0.0, -1.0}));
        QVERIFY(is(back(StandardView::front), {0.0, -1.0, 0.0}));
        QVERIFY(is(back(StandardView::back), {0.0, 1.0, 0.0}));
        QVERIFY(is(back(StandardView::left), {-1.0, 0.0, 0.0}));
        QVERIFY(is(back(StandardView::right), {1.0, 0.0, 0.0}));
        QVERIFY(is(back(StandardView::isometric), glm::normalize(glm::dvec3(1.0, -1.0, 1.0))));
    }

    void orbitKeepsThePivotInPlaceAndNeverRolls() {
        for (unsigned seed = 0; seed < 200; ++seed) {
            const CameraView view = someView(seed);
            const QPointF at(200.0 + seed, 500.0 - seed);
            const glm::dvec3 pivot = placeUnder(view, at, 0.9);
            const CameraView turned = orbited(view, 0.01 * seed, 0.3, pivot);
            QVERIFY(pixels(appearanceOf(turned, size, pivot), at) < 1e-6);
            QVERIFY(std::abs(axesOf(turned).right.z) < 1e-12); // the horizon stays level
            QVERIFY(axesOf(turned).up.z >= 0.0);
            QVERIFY(std::abs(glm::distance(axesOf(turned).eye, pivot) - glm::distance(axesOf(view).eye, pivot)) < 1e-9);
        }
    }

    void zoomKeepsThePivotInPlace() {
        for (unsigned seed = 0; seed < 200; ++seed) {
            const CameraView view = someView(seed);
            const glm::dvec3 pivot = placeUnder(view, {100.0, 650.0}, 1.1);
            const CameraView nearer = zoomed(view, 0.6, pivot);
            QVERIFY(pixels(appearanceOf(nearer, size, pivot), {100.0, 650.0}) < 1e-6);
            QVERIFY(std::abs(glm::distance(axesOf(nearer).eye, pivot) / glm::distance(axesOf(view).eye, pivot) - 0.6) <
                    1e-9);
        }
    }

    void panMovesWhatIsGripped() {
        for (unsigned seed = 0; seed < 200; ++seed) {
            const CameraView view = someView(seed);
            const glm::dvec3 grip = placeUnder(view, {700.0, 300.0}, 0.8);
            const CameraView moved = panned(view, size, {-120.0, 45.0}, grip);
            QVERIFY(pixels(appearanceOf(moved, size, grip), {580.0, 345.0}) < 1e-6);
        }
    }

    void fitShowsAllOfTheBoxAndFillsThePicture() {
        const Box box{{-30.0, 10.0, 0.0}, {90.0, 50.0, 25.0}};
        for (unsigned seed = 0; seed < 100; ++seed)
            for (const QSizeF& picture : {QSizeF(1280.0, 800.0), QSizeF(300.0, 900.0)}) {
                CameraView view = someView(seed);
                view.convergence = seed % 2 == 0 ? 1.0 : 0.0;
                const CameraView fit = fitted(view, picture, box);
                double widest = 0.0;
                for (int i = 0; i < 8; ++i) {
                    const glm::dvec3 corner((i & 1) != 0 ? 90.0 : -30.0, (i & 2) != 0 ? 50.0 : 10.0,
                                            (i & 4) != 0 ? 25.0 : 0.0);
                    const QPointF at = appearanceOf(fit, picture, corner);
                    widest = std::max(
                        {widest, std::abs(at.x() / picture.width() - 0.5), std::abs(at.y() / picture.height() - 0.5)});
                }
                QVERIFY(widest < 0.5 && widest > 0.4);
            }
    }

    void aMovementGoesTheShortWayAndEndsExactly() {
        CameraView from, to;
        from.azimuth = 3.0;
        to.azimuth = -3.0;
        to.distance = 10.0;
        QVERIFY(std::abs(std::remainder(between(from, to, 0.5).azimuth - pi, 2.0 * pi)) < 1e-9);
        QCOMPARE(between(from, to, 1.0).azimuth, to.azimuth);
        QCOMPARE(between(from, to, 1.0).distance, to.distance);
    }

    void aFlightTakesItsTimeAndThenRests() {
        using namespace std::chrono_literals;
        CameraMotion motion;
        motion.setSize(size);
        motion.setContent({{-10.0, -10.0, 0.0}, {10.0, 10.0, 10.0}});
        const CameraMotion::Clock::time_point start{};
        motion.turnTo(StandardView::top, start, 180ms);
        QVERIFY(motion.advance(start + 90ms));
        QVERIFY(motion.view().elevation < 0.5 * pi - 0.01);
        QVERIFY(!motion.advance(start + 180ms));
        QVERIFY(!motion.moving());
        QVERIFY(std::abs(motion.view().elevation - 0.5 * pi) < 1e-12);
    }

    void aResizeKeepsTheFitUntilTheUserMovesTheCamera() {
        CameraMotion motion;
        motion.setSize(size);
        motion.setContent({{-10.0, -10.0, 0.0}, {10.0, 10.0, 10.0}});
        const double before = motion.view().distance;
        motion.setSize({400.0, 800.0});
        QVERIFY(motion.view().distance > before * 1.2);
        motion.zoom(2.0, motion.view().focus);
        const double chosen = motion.view().distance;
        motion.setSize(size);
        QCOMPARE(motion.view().distance, chosen);
    }

    /// With a 3D mouse the scene moves and turns like the device's cap, about its middle.
    void aPushMovesTheContentAsTheCapGoes() {
        CameraMotion motion;
        motion.setSize(size);
        motion.setContent({{-20.0, -20.0, 0.0}, {20.0, 20.0, 20.0}});
        const glm::dvec3 middle(0.0, 0.0, 10.0);
        const auto at = [&](const glm::dvec3& place) { return appearanceOf(motion.view(), size, place); };
        const QPointF before = at(middle);
        motion.push({{1.0, 0.0, 0.0}, {}}, 0.1);
        QVERIFY(pixels(at(middle), before + QPointF(0.06 * size.height(), 0.0)) < 1.0);
        motion.push({{-1.0, 0.0, 1.0}, {}}, 0.1);
        QVERIFY(pixels(at(middle), before - QPointF(0.0, 0.06 * size.height())) < 1.0);
        const double distance = motion.view().distance;
        motion.push({{0.0, 1.0, 0.0}, {}}, 0.2); // away
        QVERIFY(motion.view().distance > distance * 1.1);

        // Towards the eye, horizontally: the side that the viewer sees in front.
        glm::dvec3 front = axesOf(motion.view()).back;
        front = glm::normalize(glm::dvec3(front.x, front.y, 0.0)) * 20.0;
        const QPointF nearSide = at(middle + front), middleThen = at(middle);
        motion.push({{}, {0.0, 0.0, 1.0}}, 0.1); // counterclockwise, seen from above: the front moves to the right
        QVERIFY(at(middle + front).x() > nearSide.x() + 5.0);
        QVERIFY(pixels(at(middle), middleThen) < 1e-6);
        const double farSide = at(middle - front).y();
        motion.push({{}, {1.0, 0.0, 0.0}}, 0.1); // its far side rises
        QVERIFY(at(middle - front).y() < farSide - 5.0);
        QVERIFY(pixels(at(middle), middleThen) < 1e-6);
        for (int i = 0; i < 100; ++i) motion.push({{}, {1.0, 0.0, 0.0}}, 0.1);
        QVERIFY(motion.view().elevation <= pi / 2.0 + 1e-12); // never overhead
    }
};

BURIN_TEST(TestCameraView, NoApplication)

} // namespace burin::tst_camera_view

#include "tst_camera_view.moc"
