// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/progress.h"
#include "core/geometry/mesh_distance.h"
#include "core/geometry/piece_minimum.h"

#include "tests/core/geometry/random_shapes.h"
#include "tests/core/geometry/shapes.h"
#include "tests/test_program.h"

#include <QtTest>

#include <array>

namespace burin::tst_entered_tips {

namespace {

std::vector<RevolvedPiece> toolWith(const RevolvedPiece& flutes) {
    return {flutes,
            {flutes.top, flutes.top + 4.0, 0.8 * flutes.topRadius, 0.8 * flutes.topRadius, 0.0},
            {flutes.top + 4.0, flutes.top + 12.0, 6.0, 9.0, 0.0}};
}

/// The definition itself: the deepest point of any triangle in any piece, mm, as a positive number. If no point is
/// deeper than `depth` in the tool, but its ends and the middle of its first piece lie inside the solid, the depth is
/// the largest possible.
double depthOf(const TriangleMesh& mesh, const MeshDistance& distance, std::span<const RevolvedPiece> tool,
               const ToolPose& pose, double depth) {
    double least = 1.0;
    for (const RevolvedPiece& piece : tool) {
        const PlacedPiece placed(piece, pose);
        for (const auto& [a, b, c] : mesh.triangles) {
            const auto found =
                minimumOverTriangle(placed, {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, least);
            if (found) least = found->distance;
        }
    }
    if (-least > depth) return -least;
    std::vector<double> heights{0.5 * (tool[0].bottom + tool[0].top)};
    for (const RevolvedPiece& piece : tool) heights.insert(heights.end(), {piece.bottom, piece.top});
    const bool inside = std::ranges::all_of(
        heights, [&](double height) { return distance.closest(pose.tip + height * pose.axis).signedDistance < 0.0; });
    return inside ? std::numeric_limits<double>::infinity() : -least;
}

RevolvedPiece fluteOf(int kind) {
    switch (kind) {
    case 0:
        return {0.0, 8.0, 2.0, 2.0, 2.0}; // ball
    case 1:
        return {0.0, 8.0, 2.0, 2.0, 0.0}; // flat
    case 2:
        return {0.0, 8.0, 2.0, 2.0, 0.5}; // bull nose
    case 3:
        return {0.0, 8.0, 0.2, 3.0, 0.0}; // cone
    default:
        return bulgingPiece(0.0, 4.0, 0.0, 2.0, 2.0); // lollipop
    }
}

} // namespace

class EnteredTipsTest : public QObject {
    Q_OBJECT

private slots:
    void ofATouchingCloud();
    void ofTipsAnywhere();
    void whatIsWhollyInsideEnters();
    void whatIsNotFiniteEntersNothing();
};

/// Tips that touch a surface all over, as in queries for a finished part: most neither enter nor have much clearance.
void EnteredTipsTest::ofATouchingCloud() {
    const std::vector<TriangleMesh> meshes{
        shapes::starShaped(
            44, 22, [](double u, double v) { return 9.0 + 1.2 * std::sin(4.0 * u) * std::cos(v) * std::cos(v); }),
        shapes::pocket(12.0, 9.0, 7.0, 5.0)};
    int entering = 0, clear = 0;
    for (const TriangleMesh& mesh : meshes) {
        const MeshDistance distance(mesh);
        for (int kind = 0; kind < 5; ++kind) {
            const std::vector<RevolvedPiece> tool = toolWith(fluteOf(kind));
            std::vector<glm::dvec3> tips;
            for (std::size_t i = 0; i < mesh.triangles.size(); i += 1 + mesh.triangles.size() / 150) {
                const auto& [a, b, c] = mesh.triangles[i];
                const glm::dvec3 &pa = mesh.vertices[a], &pb = mesh.vertices[b], &pc = mesh.vertices[c];
                const glm::dvec3 normal = glm::normalize(glm::cross(pb - pa, pc - pa));
                if (normal.z < 0.0) continue;
                const double radial = glm::length(glm::dvec2(normal));
                const ProfilePoint ring = farthestIn(tool[0], radial, -normal.z);
                const glm::dvec2 out = radial > 1e-9 ? glm::dvec2(normal) / radial : glm::dvec2(0.0);
                for (const glm::dvec3& share : {glm::dvec3(0.4, 0.3, 0.3), glm::dvec3(0.8, 0.1, 0.1)}) {
                    const glm::dvec3 place = share.x * pa + share.y * pb + share.z * pc;
                    tips.push_back(place + glm::dvec3(ring.radius * out, -ring.height));
                }
            }
            Progress progress;
            const std::vector<std::uint8_t> entered = distance.entered(tool, {0.0, 0.0, 1.0}, tips, 0.01, progress);
            QCOMPARE(entered.size(), tips.size());
            for (std::size_t i = 0; i < tips.size(); ++i) {
                const double depth = depthOf(mesh, distance, tool, {tips[i], {0.0, 0.0, 1.0}}, 0.01);
                if (std::abs(depth - 0.01) < 1e-7) continue;
                QVERIFY2((entered[i] != 0) == (depth > 0.01), qPrintable(QString("%1 %2").arg(kind).arg(depth)));
                ++(entered[i] != 0 ? entering : clear);
            }
        }
    }
    QVERIFY(entering > 200 && clear > 200);
}

void EnteredTipsTest::ofTipsAnywhere() {
    const TriangleMesh mesh = shapes::torus(10.0, 4.0, 30, 15);
    const MeshDistance distance(mesh);
    QVERIFY(rc::check("any tool, any axis, tips in a heap or far apart", [&] {
        const std::vector<RevolvedPiece> tool = toolWith(random::piece());
        const glm::dvec3 axis = random::direction(), middle = random::point(12.0);
        const double depth = random::number(0.005, 0.5), reach = *rc::gen::element(0.0, 0.3, 3.0, 15.0);
        std::vector<glm::dvec3> tips;
        for (int i = 0; i < 9; ++i) tips.push_back(middle + random::point(reach));
        Progress progress;
        const std::vector<std::uint8_t> entered = distance.entered(tool, axis, tips, depth, progress);
        for (std::size_t i = 0; i < tips.size(); ++i) {
            const double wanted = depthOf(mesh, distance, tool, {tips[i], axis}, depth);
            if (std::abs(wanted - depth) < 1e-6) continue;
            RC_ASSERT((entered[i] != 0) == (wanted > depth));
        }
    }));
}

void EnteredTipsTest::whatIsWhollyInsideEnters() {
    const MeshDistance distance(shapes::torus(14.0, 6.0, 120, 60));
    const std::vector<RevolvedPiece> small{{0.0, 1.0, 0.5, 0.5, 0.0}};
    Progress progress;
    const std::array<glm::dvec3, 2> tips{glm::dvec3(14.0, 0.0, -0.5), glm::dvec3(0.0, 0.0, -0.5)}; // and in the hole
    const std::vector<std::uint8_t> entered = distance.entered(small, {0.0, 0.0, 1.0}, tips, 0.1, progress);
    QCOMPARE(int(entered[0]), 1);
    QCOMPARE(int(entered[1]), 0);
}

void EnteredTipsTest::whatIsNotFiniteEntersNothing() {
    const MeshDistance distance(shapes::box(glm::dvec3(-5.0), glm::dvec3(5.0)));
    const std::vector<RevolvedPiece> tool{{0.0, 20.0, 1.0, 1.0, 1.0}};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Progress progress;
    const std::array<glm::dvec3, 3> tips{glm::dvec3(nan, 0.0, 0.0), glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 6.0)};
    QCOMPARE(distance.entered(tool, {0.0, 0.0, 1.0}, tips, 0.01, progress), (std::vector<std::uint8_t>{0, 1, 0}));
    QCOMPARE(distance.entered(tool, {0.0, nan, 1.0}, tips, 0.01, progress), (std::vector<std::uint8_t>{0, 0, 0}));
    QCOMPARE(MeshDistance{TriangleMesh{}}.entered(tool, {0.0, 0.0, 1.0}, tips, 0.01, progress),
             (std::vector<std::uint8_t>{0, 0, 0}));
}

BURIN_TEST(EnteredTipsTest, NoApplication)

} // namespace burin::tst_entered_tips

#include "tst_entered_tips.moc"
