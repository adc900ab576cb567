// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cad/face_area.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <cmath>

namespace burin::tst_face_area {

namespace {

/// A plate of 40 x 30 x 10 mm with a round boss of radius 8 mm, 5 mm high, on it; no vertex is shared, as in an STL.
Model plateWithBoss() {
    TriangleMesh mesh;
    const auto triangle = [&mesh](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
        mesh.triangles.push_back({first, first + 1, first + 2});
    };
    const auto quad = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
        triangle(a, b, c);
        triangle(a, c, d);
    };
    constexpr int count = 96;
    const auto on = [](int i, double radius, double z) {
        const double angle = 2.0 * pi * i / count;
        return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    const auto border = [&](int i, double z) { // point where a ray meets the rectangle
        const glm::dvec3 out = on(i, 1.0, 0.0);
        const double far = std::min(20.0 / std::max(std::abs(out.x), 1e-9), 15.0 / std::max(std::abs(out.y), 1e-9));
        return glm::dvec3(far * out.x, far * out.y, z);
    };
    for (int i = 0; i < count; ++i) {
        quad(on(i, 8.0, 10.0), border(i, 10.0), border(i + 1, 10.0), on(i + 1, 8.0, 10.0));
        quad(on(i, 8.0, 10.0), on(i + 1, 8.0, 10.0), on(i + 1, 8.0, 15.0), on(i, 8.0, 15.0));
        triangle({0.0, 0.0, 15.0}, on(i, 8.0, 15.0), on(i + 1, 8.0, 15.0));
        quad(border(i, 0.0), border(i + 1, 0.0), border(i + 1, 10.0), border(i, 10.0));
        triangle({0.0, 0.0, 0.0}, border(i + 1, 0.0), border(i, 0.0));
    }
    Model model;
    Body& body = model.bodies.emplace_back();
    body.mesh = std::move(mesh);
    return model;
}

} // namespace

class FaceAreaTest final : public QObject {
    Q_OBJECT

private slots:
    /// Around the boss the face is the plate without a disc; on the boss it is the disc: areas of polygons of 96
    /// corners.
    void facesEndAtSharpEdges() {
        const Model model = plateWithBoss();
        const double disc = 0.5 * 96 * 64.0 * std::sin(2.0 * pi / 96);
        const Result<PlanRegion> plate = faceArea(model, {15.0, 3.0, 10.0});
        QVERIFY(plate);
        double rectangle = 0.0; // the corners of the rectangle are cut off between two rays
        {
            const Result<PlanRegion> top = faceArea(model, {0.0, 0.0, 15.0});
            QVERIFY(top);
            QVERIFY2(std::abs(areaInPlan(*top) - disc) < 0.01, qPrintable(QString::number(areaInPlan(*top))));
            QVERIFY(holds(*top, {1.0, 1.0}) && !holds(*top, {9.0, 0.0}));
        }
        std::vector<glm::dvec2> corners;
        for (int i = 0; i < 96; ++i) {
            const double x = std::cos(2.0 * pi * i / 96), y = std::sin(2.0 * pi * i / 96);
            const double far = std::min(20.0 / std::max(std::abs(x), 1e-9), 15.0 / std::max(std::abs(y), 1e-9));
            corners.emplace_back(far * x, far * y);
        }
        for (std::size_t i = 0; i < 96; ++i) {
            const glm::dvec2 &a = corners[i], &b = corners[(i + 1) % 96];
            rectangle += 0.5 * (a.x * b.y - a.y * b.x);
        }
        QVERIFY2(std::abs(areaInPlan(*plate) - (rectangle - disc)) < 0.01,
                 qPrintable(QString::number(areaInPlan(*plate))));
        QVERIFY(!holds(*plate, {1.0, 1.0}) && holds(*plate, {15.0, 3.0}));
    }

    void whatHasNoAreaFromAboveIsRefused() {
        const Model model = plateWithBoss();
        for (const glm::dvec3& place :
             {glm::dvec3(20.0, 1.0, 5.0), glm::dvec3(1.0, 1.0, 0.0), glm::dvec3(0.0, 0.0, 30.0)}) {
            const Result<PlanRegion> face = faceArea(model, place);
            QVERIFY(!face);
            QCOMPARE(face.error().code, ErrorCode::argumentInvalid);
        }
    }
};

BURIN_TEST(FaceAreaTest, QCoreApplication)

} // namespace burin::tst_face_area

#include "tst_face_area.moc"
