// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/triangle_ray.h"

#include "tests/core/geometry/random_shapes.h"
#include "tests/core/geometry/shapes.h"
#include "tests/test_program.h"

#include <QtTest>

#include <numeric>

namespace burin::tst_triangle_ray {

namespace {

TriangleTree treeOf(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    return {mesh, all};
}

/// The first intersection of a ray with a sphere around the origin, by the quadratic formula.
std::optional<TriangleHit> hitOnSphere(const Ray& ray, double radius) {
    const double a = glm::dot(ray.direction, ray.direction), b = glm::dot(ray.origin, ray.direction),
                 c = glm::dot(ray.origin, ray.origin) - radius * radius, square = b * b - a * c;
    if (square < 0.0) return std::nullopt;
    const double in = (-b - std::sqrt(square)) / a, out = (-b + std::sqrt(square)) / a;
    if (in >= 0.0) return TriangleHit{in, false};
    if (out >= 0.0) return TriangleHit{out, true};
    return std::nullopt;
}

} // namespace

class TriangleRayTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsMetInAnEmptyTree() { QVERIFY(!nearestHit({}, treeOf({}))); }

    /// A box, far from the origin and with faces perpendicular to the axes; many of the rays are parallel to them.
    void aBoxIsMetAtItsFaces() {
        const glm::dvec3 low{997.0, 1.0, 2.0}, high{1005.0, 4.0, 3.0};
        const TriangleTree tree = treeOf(shapes::box(low, high));
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                glm::dvec3 along(0.0);
                along[axis] = 2.0 * sign; // distances are in units of its length
                const glm::dvec3 inside(1000.3, 2.4, 2.7);
                const double wall = sign > 0.0 ? high[axis] : low[axis];
                const auto out = nearestHit({inside, along}, tree);
                QVERIFY(out && out->leaving && std::abs(out->distance - std::abs(wall - inside[axis]) / 2.0) < 1e-9);
                glm::dvec3 before = inside;
                before[axis] = wall + 5.0 * sign;
                const auto in = nearestHit({before, -along}, tree);
                QVERIFY(in && !in->leaving && std::abs(in->distance - 2.5) < 1e-9);
                QVERIFY(!nearestHit({before, along}, tree)); // it is behind
                before[(axis + 1) % 3] = high[(axis + 1) % 3] + 0.1;
                QVERIFY(!nearestHit({before, -along}, tree)); // to the side
            }
    }

    void aSphereIsMetWhereItsFormulaSays() {
        constexpr double radius = 10.0, chord = 0.02; // of 160 × 80 faces
        const TriangleTree tree = treeOf(shapes::sphere(radius, 160, 80));
        QVERIFY(rc::check([&] {
            const Ray ray{random::point(25.0), random::number(0.1, 3.0) * random::direction()};
            const double length = glm::length(ray.direction);
            const glm::dvec3 nearestToCentre =
                ray.origin - ray.direction * glm::dot(ray.origin, ray.direction) / (length * length);
            const double off = glm::length(nearestToCentre);
            RC_PRE(std::abs(off - radius) > 0.5 && std::abs(glm::length(ray.origin) - radius) > 0.1); // no grazing
            const std::optional<TriangleHit> expected = hitOnSphere(ray, radius), found = nearestHit(ray, tree);
            RC_ASSERT(expected.has_value() == found.has_value());
            if (!found) return;
            RC_ASSERT(expected->leaving == found->leaving);
            const double slope = std::sqrt(1.0 - off * off / (radius * radius)); // of the ray to the surface, sine
            RC_ASSERT(std::abs(expected->distance - found->distance) * length < chord / slope);
        }));
    }
};

BURIN_TEST(TriangleRayTest, NoApplication)

} // namespace burin::tst_triangle_ray

#include "tst_triangle_ray.moc"
