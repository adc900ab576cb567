// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "ui/scene/camera_motion.h"

#include <QTest>

#include <random>

using namespace burin;

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
                const CameraView fit = fitted(someView(seed), picture, box);
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
};

QTEST_APPLESS_MAIN(TestCameraView)
#include "tst_camera_view.moc"
