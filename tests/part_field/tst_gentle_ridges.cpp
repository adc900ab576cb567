// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/triangle_mesh.h"
#include "tests/part_field/part_field.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <random>

namespace burin::tst_gentle_ridges {

namespace {

constexpr double voxel = 0.5, half = 16.0; // mm
constexpr double bricks = 8.0 * voxel;

/// A block whose top slopes down equally on both sides of a ridge along y; negative angle: a valley.
struct Roof {
    double ridge = 0.0, angle = 0.0; ///< mm, rad

    double top(double x) const { return -std::tan(angle) * std::abs(x - ridge); }

    TriangleMesh mesh() const {
        // The outline of the cross-section, starting from the ridge, from which all of it is visible.
        const std::array<glm::dvec2, 5> outline{
            glm::dvec2(ridge, 0.0), {-half, top(-half)}, {-half, -half}, {half, -half}, {half, top(half)}};
        TriangleMesh mesh;
        for (const double y : {-half, half})
            for (const glm::dvec2& p : outline) mesh.vertices.emplace_back(p.x, y, p.y);
        for (std::uint32_t i = 0; i < 5; ++i) {
            const std::uint32_t next = (i + 1) % 5;
            mesh.triangles.push_back({i, i + 5, next});
            mesh.triangles.push_back({next, i + 5, next + 5});
        }
        for (std::uint32_t i = 1; i < 4; ++i) {
            mesh.triangles.push_back({0, i, i + 1});
            mesh.triangles.push_back({5, i + 6, i + 5});
        }
        if (signedVolume(mesh) < 0.0)
            for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
        return mesh;
    }

    /// Closed formula, where the top is nearest: a convex wedge, or the complement of one.
    double distance(const glm::dvec3& p) const {
        const double side = angle < 0.0 ? -1.0 : 1.0, steep = std::abs(angle);
        const double across = std::abs(p.x - ridge), up = side * p.z;
        const double above = across * std::sin(steep) + up * std::cos(steep);
        const double along = across * std::cos(steep) - up * std::sin(steep); // down the slope
        const double opposite = up * std::cos(steep) - across * std::sin(steep);
        const double inside = std::max(above, opposite);
        return side * (inside <= 0.0 ? inside : along >= 0.0 ? above : std::hypot(across, up));
    }
};

} // namespace

/// The corners of a brick do not show a ridge through its centre whose bend is as small as that of a curved face.
class GentleRidgesTest : public QObject {
    Q_OBJECT

private slots:
    void keepTheirBound_data();
    void keepTheirBound();
};

void GentleRidgesTest::keepTheirBound_data() {
    QTest::addColumn<double>("angle");
    for (const double angle : {0.02, 0.06, 0.12})
        for (const double side : {1.0, -1.0})
            QTest::addRow("%s, %.2f", side > 0.0 ? "ridge" : "valley", angle) << side * angle;
}

void GentleRidgesTest::keepTheirBound() {
    QFETCH(double, angle);
    std::mt19937 random(11);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    double largest = 0.0, overBound = -1e9;
    for (int place = 0; place < 8; ++place) {
        const Roof roof{bricks * place / 8.0 + 0.1 * voxel, angle};
        Progress progress;
        const auto field = PartField::build(roof.mesh(), {voxel, 4.0 * voxel}, progress);
        QVERIFY(bool(field));
        for (int i = 0; i < 4000; ++i) {
            const double x = roof.ridge + number(-1.0, 1.0) * (i % 2 == 0 ? bricks : 0.3 * voxel);
            const glm::dvec3 p{x, number(-8.0, 8.0), roof.top(x) + 3.9 * voxel * number(-1.0, 1.0)};
            const double error = std::abs(field->value(p) - roof.distance(p));
            largest = std::max(largest, error);
            overBound = std::max(overBound, error - field->errorBoundAt(p));
        }
    }
    qInfo("largest error %.4f voxel, over the bound %.4f", largest / voxel, overBound / voxel);
    QVERIFY(overBound <= 1e-6);
    QVERIFY(largest <= 0.08 * voxel);
}

BURIN_TEST(GentleRidgesTest, NoApplication)

} // namespace burin::tst_gentle_ridges

#include "tst_gentle_ridges.moc"
