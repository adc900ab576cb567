// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "tests/test_program.h"
#include "ui/scene/guide_geometry.h"
#include "ui/scene/guide_surface.h"

#include <rapidcheck.h>

#include <QCoreApplication>
#include <QtTest>

#include <vtkPolyData.h>

#include <cmath>

namespace burin::tst_guide_geometry {

namespace {

const Box box{{-30.0, -20.0, 0.0}, {30.0, 20.0, 25.0}};

double within(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

glm::dvec3 anyDirection() {
    const double z = within(-1.0, 1.0), angle = within(0.0, 2.0 * pi), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

glm::dvec3 anyPlaceIn(const Box& where) {
    return {within(where.low.x, where.high.x), within(where.low.y, where.high.y), within(where.low.z, where.high.z)};
}

double areaOf(const Polygon& corners, const glm::dvec3& normal) {
    double twice = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        twice += glm::dot(normal, glm::cross(corners[i], corners[(i + 1) % corners.size()]));
    return 0.5 * std::abs(twice);
}

/// Area of the part of a plane within a box, found independently by counting points of a lattice in the plane.
double countedArea(const glm::dvec3& point, const glm::dvec3& normal) {
    const glm::dvec3 other = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(normal, other)), v = glm::cross(normal, u);
    constexpr double step = 0.5;
    int count = 0;
    for (int i = -200; i <= 200; ++i)
        for (int j = -200; j <= 200; ++j)
            if (box.contains(point + u * (step * i) + v * (step * j))) ++count;
    return count * step * step;
}

/// A ball of stock that a tip must not enter, known in closed form.
class BallField final : public ClearanceField {
public:
    FieldSample at(const glm::dvec3& tip) const noexcept override {
        const double distance = glm::length(tip);
        return {distance - 10.0, distance > 0.0 ? tip / distance : glm::dvec3(0, 0, 1),
                distance > 7.0 && distance < 14.0};
    }
    double errorBound() const noexcept override { return 0.0; }
    double spacing() const noexcept override { return 0.5; }
};

} // namespace

/// The geometry by which guides are shown.
class TestGuideGeometry : public QObject {
    Q_OBJECT
private slots:
    void aPlaneEndsAtTheBox() {
        const bool held = rc::check([] {
            const glm::dvec3 point = anyPlaceIn(box), normal = anyDirection();
            const Polygon corners = planeInBox(box, point, normal);
            RC_ASSERT(corners.size() >= 3 && corners.size() <= 6);
            for (const glm::dvec3& corner : corners) {
                RC_ASSERT(std::abs(glm::dot(normal, corner - point)) < 1e-9);
                RC_ASSERT(box.grown(1e-9).contains(corner));
            }
            const double area = areaOf(corners, normal), counted = countedArea(point, normal);
            RC_ASSERT(std::abs(area - counted) < 0.03 * area + 60.0);
        });
        QVERIFY(held);
        QVERIFY(planeInBox(box, {0, 0, 25.1}, {0, 0, 1}).empty());
        for (const double height : {0.0, 25.0}) // a face of the box itself
            QCOMPARE(areaOf(planeInBox(box, {0, 0, height}, {0, 0, 1}), {0, 0, 1}), 60.0 * 40.0);
    }

    void levelsThatMeetTheBoxAreKnown() {
        const auto range = levelsInBox(box, {0, 0, 24.0}, {0, 0, 1}, 1.5);
        QVERIFY(range);
        QCOMPARE(range->first, -16); // at 0 mm
        QCOMPARE(range->second, 0);
        QVERIFY(!levelsInBox(box, {0, 0, 26.0}, {0, 0, 1}, 100.0));
    }

    void aLineEndsAtTheBox() {
        const bool held = rc::check([] {
            const glm::dvec3 point = anyPlaceIn(box), direction = anyDirection();
            const auto ends = lineInBox(box, point, direction);
            RC_ASSERT(ends.has_value());
            for (const glm::dvec3& end : {ends->first, ends->second}) {
                RC_ASSERT(glm::length(glm::cross(direction, end - point)) < 1e-6);
                RC_ASSERT(box.grown(1e-6).contains(end));
                RC_ASSERT(!box.grown(-1e-6).contains(end)); // on its surface
            }
        });
        QVERIFY(held);
        QVERIFY(!lineInBox(box, {0, 50, 5}, {1, 0, 0}));
    }

    /// Each point of the curves has the required distance from the pass, seen from above, and there are curves on both
    /// sides.
    void curvesKeepTheirDistanceFromThePass() {
        std::vector<glm::dvec3> pass;
        for (int i = 0; i <= 800; ++i) {
            const double x = -20.0 + 0.05 * i;
            pass.emplace_back(x, 6.0 * std::sin(0.4 * x), 5.0 + 0.1 * x);
        }
        constexpr double distance = 1.5;
        const std::vector<Polygon> curves = besidePass(pass, {0, 0, 1}, distance);
        QVERIFY(curves.size() >= 2);
        double length = 0.0;
        int above = 0, below = 0;
        for (const Polygon& curve : curves)
            for (std::size_t i = 0; i < curve.size(); ++i) {
                const glm::dvec3& place = curve[i];
                if (std::abs(place.x) > 18.0) continue; // beyond the ends the curve is straight
                double nearest = 1e9;
                for (const glm::dvec3& tip : pass)
                    nearest = std::min(nearest, std::hypot(tip.x - place.x, tip.y - place.y));
                QVERIFY2(std::abs(nearest - distance) < 0.01 * distance + passTolerance + 0.001,
                         qPrintable(QString::number(nearest)));
                (place.y > 6.0 * std::sin(0.4 * place.x) ? above : below) += 1;
                if (i > 0) length += glm::distance(place, curve[i - 1]);
            }
        QVERIFY(above > 20 && below > 20);
        QVERIFY(length > 2.0 * 36.0);
        QVERIFY(besidePass(std::vector<glm::dvec3>{{1, 1, 1}}, {0, 0, 1}, 1.0).empty());
    }

    /// Where the pass bends more sharply than the distance allows, nothing is drawn too close to it.
    void aCurveIsCutWhereItWouldRunIntoThePass() {
        const std::vector<glm::dvec3> pass{{0, 0, 0}, {10, 0, 0}, {10, 1, 0}, {0, 1, 0}};
        for (const Polygon& curve : besidePass(pass, {0, 0, 1}, 2.0))
            for (const glm::dvec3& place : curve) {
                const double x = std::clamp(place.x, 0.0, 10.0), y = std::clamp(place.y, 0.0, 1.0);
                QVERIFY(std::hypot(place.x - x, place.y - y) > 1.97 || place.x < 0.0);
            }
    }

    void aSurfaceLiesWhereTheFieldSays() {
        const GuideSurface surface = guideSurface(BallField(), {{-16, -16, -16}, {16, 16, 16}}, 2.0);
        QVERIFY(surface.shell->GetNumberOfPolys() > 5000);
        vtkPoints& points = *surface.shell->GetPoints();
        double area = 0.0;
        for (vtkIdType cell = 0; cell < surface.shell->GetNumberOfPolys(); ++cell) {
            vtkIdType count = 0;
            const vtkIdType* ids = nullptr;
            surface.shell->GetPolys()->GetCellAtId(cell, count, ids);
            std::array<glm::dvec3, 3> corner{};
            for (std::size_t i = 0; i < 3; ++i) {
                std::array<double, 3> p{};
                points.GetPoint(ids[i], p.data());
                corner[i] = {p[0], p[1], p[2]};
                QVERIFY(std::abs(glm::length(corner[i]) - 12.0) < 0.006);
            }
            area += 0.5 * glm::length(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
        }
        QVERIFY(std::abs(area / (4.0 * pi * 144.0) - 1.0) < 0.01);
        QVERIFY(surface.contours->GetNumberOfLines() > 100);
        // No guide can act beyond the distances that the field knows exactly, and none is drawn there.
        QCOMPARE(guideSurface(BallField(), {{-16, -16, -16}, {16, 16, 16}}, 5.0).shell->GetNumberOfPolys(),
                 vtkIdType{0});
    }
};

BURIN_TEST(TestGuideGeometry, QCoreApplication)

} // namespace burin::tst_guide_geometry

#include "tst_guide_geometry.moc"
