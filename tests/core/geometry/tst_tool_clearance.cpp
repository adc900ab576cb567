// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/mesh_distance.h"
#include "core/geometry/piece_minimum.h"

#include "tests/core/geometry/random_shapes.h"
#include "tests/core/geometry/shapes.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QtTest>

#include <random>

namespace burin::tst_tool_clearance {

namespace {

double pieceDistance(const RevolvedPiece& piece, const ToolPose& pose, const glm::dvec3& point) {
    const glm::dvec3 q = point - pose.tip;
    const double height = glm::dot(q, pose.axis);
    return signedDistance(piece, glm::length(q - height * pose.axis), height);
}

/// Least value of a convex function of one number in [0, 1], by ternary search.
template <class Function>
double leastByThirds(const Function& function) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 55; ++i) {
        const double third = (high - low) / 3.0;
        if (function(low + third) < function(high - third))
            high -= third;
        else
            low += third;
    }
    return function(0.5 * (low + high));
}

/// Slow and obvious: ternary search across the triangle, and along each line across it. The lines sweep the triangle
/// from a corner, so that their least values are a convex function too.
double leastOverTriangle(const RevolvedPiece& piece, const ToolPose& pose, const Triangle& t) {
    return leastByThirds([&](double u) {
        return leastByThirds(
            [&](double v) { return pieceDistance(piece, pose, t[0] + u * ((t[1] - t[0]) + v * (t[2] - t[1]))); });
    });
}

double leastBySampling(const RevolvedPiece& piece, const ToolPose& pose, const Triangle& t, int steps) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j)
            least = std::min(
                least, pieceDistance(piece, pose,
                                     t[0] + (double(i) / steps) * (t[1] - t[0]) + (double(j) / steps) * (t[2] - t[0])));
    return least;
}

RevolvedPiece ball(double radius, double length = 20.0) {
    return {0.0, length, radius, radius, radius};
}
RevolvedPiece flat(double radius, double length = 20.0) {
    return {0.0, length, radius, radius, 0.0};
}
RevolvedPiece bull(double radius, double corner, double length = 20.0) {
    return {0.0, length, radius, radius, corner};
}

std::vector<RevolvedPiece> wholeTool(const RevolvedPiece& flutes) {
    return {flutes,
            {flutes.top, flutes.top + 20.0, 0.9 * flutes.topRadius, 0.9 * flutes.topRadius, 0.0},
            {flutes.top + 20.0, flutes.top + 40.0, 10.0, 16.0, 0.0}};
}

} // namespace

class ToolClearanceTest : public QObject {
    Q_OBJECT

private slots:
    void triangleAgainstThirds();
    void triangleAgainstSampling();
    void tangentsStayBelow();
    void meshAgainstAllTriangles();
    void ballOverSphere();
    void aboveAndInABlock();
    void throughAPlate();
    void plungedBelowItsRadius();
    void whollyInside();
    void shankAndHolderCount();
    void awayGainsClearance();
    void changesNoFasterThanTheToolMoves();
    void askingOneAfterTheOtherIsTheSame();
    void toleranceIsKept();
    void withinCaps();
    void emptyMeshIsFree();
    void whatIsNotFiniteTouchesNothing();
};

void ToolClearanceTest::triangleAgainstThirds() {
    QVERIFY(testing::holdsInShare("minimum over a triangle", [] {
        const RevolvedPiece piece = random::piece();
        const ToolPose pose{random::point(2.0), random::direction()};
        const glm::dvec3 at = random::point(8.0) + 4.0 * pose.axis;
        const double size = random::number(0.01, 1.0) * random::number(0.0, 10.0) + 1e-3;
        const Triangle triangle{at + size * random::point(1.0), at + size * random::point(1.0),
                                at + size * random::point(1.0)};
        const double wanted = leastOverTriangle(piece, pose, triangle);
        const auto found = minimumOverTriangle(PlacedPiece(piece, pose), triangle, 1e9);
        RC_ASSERT(found.has_value());
        RC_ASSERT(std::abs(found->distance - wanted) < 1e-7);
        RC_ASSERT(std::abs(pieceDistance(piece, pose, found->point) - found->distance) < 1e-8);
        RC_ASSERT(!minimumOverTriangle(PlacedPiece(piece, pose), triangle, wanted - 1e-6));
        RC_ASSERT(minimumOverTriangle(PlacedPiece(piece, pose), triangle, wanted + 1e-6).has_value());
    }));
}

void ToolClearanceTest::triangleAgainstSampling() {
    QVERIFY(testing::holdsInShare("no sample of a triangle is nearer", [] {
        const RevolvedPiece piece = random::piece();
        const ToolPose pose{random::point(2.0), random::direction()};
        const Triangle triangle{random::point(6.0), random::point(6.0), random::point(6.0)};
        const double sampled = leastBySampling(piece, pose, triangle, 60);
        const auto found = minimumOverTriangle(PlacedPiece(piece, pose), triangle, 1e9);
        RC_ASSERT(found.has_value());
        RC_ASSERT(found->distance <= sampled + 1e-8);
        RC_ASSERT(found->distance >= sampled - 21.0 / 60.0);
    }));
}

void ToolClearanceTest::tangentsStayBelow() {
    QVERIFY(testing::holdsInShare("no tangent is above the signed distance, on the axis as elsewhere", [] {
        const RevolvedPiece piece = random::piece();
        const ToolPose pose{random::point(30.0), random::direction()};
        const double beside = *rc::gen::element(0.0, 0.0, 1e-15, 1e-12, 1e-6, 1.0);
        const double length = piece.top - piece.bottom;
        for (int i = 0; i < 20; ++i) {
            const double height = piece.bottom + random::number(-0.5, 1.5) * length;
            const glm::dvec3 at = pose.tip + height * pose.axis + beside * random::point(3.0);
            const PlacedPiece::Value tangent = PlacedPiece(piece, pose).at(at);
            const glm::dvec3 other = at + random::point(10.0);
            const double below = tangent.distance + glm::dot(tangent.gradient, other - at);
            RC_ASSERT(pieceDistance(piece, pose, other) > below - 1e-6);
        }
    }));
}

void ToolClearanceTest::meshAgainstAllTriangles() {
    const TriangleMesh mesh = shapes::starShaped(
        26, 14, [](double u, double v) { return 9.0 + 1.5 * std::sin(3.0 * u) * std::cos(v) * std::cos(v); });
    QCOMPARE(countOpenEdges(mesh), std::size_t(0));
    const MeshDistance distance(mesh);
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    int entered = 0;
    for (int i = 0; i < 60; ++i) {
        const std::vector<RevolvedPiece> tool = wholeTool(i % 3 == 0   ? ball(2.0)
                                                          : i % 3 == 1 ? flat(2.0)
                                                                       : bull(2.0, 0.5));
        const glm::dvec3 out = glm::normalize(glm::dvec3(number(engine), number(engine), number(engine)));
        const ToolPose pose{(10.0 + 2.0 * number(engine)) * out,
                            glm::normalize(out + 0.5 * glm::dvec3(number(engine), number(engine), number(engine)))};
        double wanted = std::numeric_limits<double>::infinity();
        for (const RevolvedPiece& piece : tool)
            for (const auto& [a, b, c] : mesh.triangles) {
                const Triangle triangle{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
                if (leastBySampling(piece, pose, triangle, 1) < wanted + 6.0)
                    wanted = std::min(wanted, leastOverTriangle(piece, pose, triangle));
            }
        if (wanted < 0.0) {
            ++entered;
            wanted = std::min(wanted, distance.closest(pose.tip).signedDistance);
        }
        const ToolClearance found = distance.clearance(tool, pose);
        QVERIFY2(std::abs(found.clearance - wanted) < 1e-6,
                 qPrintable(QString("%1: %2 %3").arg(i).arg(found.clearance).arg(wanted)));
    }
    QVERIFY(entered > 5 && entered < 55);
}

void ToolClearanceTest::ballOverSphere() {
    const double radius = 10.0;
    const MeshDistance distance(shapes::sphere(radius, 400, 200));
    const double chord = radius * (1.0 - std::cos(std::numbers::pi / 200.0)) * 2.0; // the mesh lies inside the sphere
    for (const double gap : {-0.5, -0.01, 0.0, 0.3, 2.0})
        for (int i = 0; i < 20; ++i) {
            const double u = 0.3 * i, v = 0.2 + 0.06 * i;
            const glm::dvec3 out{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
            const glm::dvec3 centre = (radius + 3.0 + gap) * out;
            const auto found = distance.clearance(std::array{ball(3.0)}, {centre - glm::dvec3(0, 0, 3.0), {0, 0, 1}});
            QVERIFY2(found.clearance >= gap - 1e-9 && found.clearance <= gap + chord,
                     qPrintable(QString::number(found.clearance - gap)));
            QVERIFY(glm::dot(found.away, out) > 0.999);
        }
}

void ToolClearanceTest::aboveAndInABlock() {
    const MeshDistance distance(shapes::box({-20, -20, -10}, {20, 20, 0}));
    const auto at = [&](const RevolvedPiece& piece, const glm::dvec3& tip) {
        return distance.clearance(std::array{piece}, {tip, {0, 0, 1}}).clearance;
    };
    for (const RevolvedPiece& piece : {ball(3.0), flat(3.0), bull(3.0, 1.0)}) {
        QVERIFY(std::abs(at(piece, {1.0, 2.0, 0.75}) - 0.75) < 1e-8);
        QVERIFY(std::abs(at(piece, {1.0, 2.0, 0.0})) < 1e-8);
        QVERIFY(std::abs(at(piece, {1.0, 2.0, -0.4}) + 0.4) < 1e-8);
        QVERIFY(std::abs(at(piece, {23.5, 0.0, -5.0}) - 0.5) < 1e-8); // to the side
    }
    // Over the edge: bottom corner to edge, by formula.
    QVERIFY(std::abs(at(flat(3.0), {24.0, 0.0, 2.0}) - std::hypot(1.0, 2.0)) < 1e-8);
    QVERIFY(std::abs(at(bull(3.0, 1.0), {24.0, 0.0, 2.0}) - (std::hypot(2.0, 3.0) - 1.0)) < 1e-8);
    QVERIFY(std::abs(at(ball(3.0), {24.0, 0.0, 2.0}) - (std::hypot(4.0, 5.0) - 3.0)) < 1e-8);
    // A tenth of a millimetre into the side wall, far below the upper face.
    QVERIFY(std::abs(at(flat(3.0), {22.9, 0.0, -5.0}) + 0.1) < 1e-8);
    // Lying on its side.
    QVERIFY(std::abs(distance.clearance(std::array{flat(3.0)}, {{-8.0, 0.0, 4.0}, {1, 0, 0}}).clearance - 1.0) < 1e-8);
}

void ToolClearanceTest::throughAPlate() {
    const MeshDistance distance(shapes::box({-20, -20, -1}, {20, 20, 0}));
    QVERIFY(std::abs(distance.clearance(std::array{ball(3.0)}, {{0, 0, -8}, {0, 0, 1}}).clearance + 3.0) < 1e-8);
}

void ToolClearanceTest::plungedBelowItsRadius() {
    const MeshDistance distance(shapes::box({-20, -20, -30}, {20, 20, 0}));
    const auto found = distance.clearance(wholeTool(flat(0.5)), {{0, 0, -8}, {0, 0, 1}});
    QVERIFY(std::abs(found.clearance + 8.0) < 1e-8); // the error of a drilled hole is its depth
    QVERIFY(glm::length(found.away - glm::dvec3(0, 0, 1)) < 1e-8);
}

void ToolClearanceTest::whollyInside() {
    const MeshDistance distance(shapes::box(glm::dvec3(-50.0), glm::dvec3(50.0)));
    for (const RevolvedPiece& piece : {ball(2.0, 8.0), flat(2.0, 8.0)}) {
        const auto deep = distance.clearance(std::array{piece}, {{0, 0, 10}, {0, 0, 1}});
        QVERIFY(std::abs(deep.clearance + 40.0) < 1e-8);
        QVERIFY(std::abs(distance.clearance(std::array{piece}, {{0, 0, 10}, {0, 0, 1}}, 1.0).clearance + 40.0) < 1e-8);
    }
}

void ToolClearanceTest::shankAndHolderCount() {
    const MeshDistance distance(shapes::box({0, -90, -90}, {90, 90, 90})); // a wall at x = 0
    const std::vector<RevolvedPiece> tool = wholeTool(ball(3.0));
    const auto found = distance.clearance(tool, {{-16.5, 0, 0}, {0, 0, 1}});
    QVERIFY(std::abs(found.clearance - 0.5) < 1e-8);
    QCOMPARE(found.piece, std::size_t(2));
    QVERIFY(glm::dot(found.away, glm::dvec3(-1, 0, 0)) > 0.9);
}

void ToolClearanceTest::awayGainsClearance() {
    const MeshDistance distance(shapes::torus(12.0, 4.0, 120, 60));
    QVERIFY(testing::holdsInShare("a small step along `away` is a gain of its length", [&] {
        const RevolvedPiece piece = *rc::gen::inRange(0, 2) == 0 ? ball(2.0) : bull(2.0, 0.5);
        const ToolPose pose{random::point(18.0), random::direction()};
        const auto found = distance.clearance(std::array{piece}, pose);
        RC_PRE(found.clearance > 0.05);
        const auto back = distance.clearance(std::array{piece}, {pose.tip - 0.01 * found.away, pose.axis});
        RC_ASSERT(std::abs(found.clearance - back.clearance - 0.01) < 1e-6); // towards the nearest point: exact
    }));
}

void ToolClearanceTest::changesNoFasterThanTheToolMoves() {
    const TriangleMesh mesh = shapes::starShaped(
        26, 14, [](double u, double v) { return 30.0 + 4.0 * std::sin(3.0 * u) * std::cos(v) * std::cos(v); });
    const MeshDistance distance(mesh); // wide enough to contain the tool
    QVERIFY(testing::holdsInShare("two tips near each other", [&] {
        const double flutes = random::number(0.5, 6.0);
        const std::vector<RevolvedPiece> tool{{0.0, 8.0, 2.0, 2.0, random::number(0.0, 2.0)},
                                              {8.0, 8.0 + flutes, 1.5, 1.5, 0.0},
                                              {8.0 + flutes, 18.0, 3.0, 5.0, 0.0}};
        const glm::dvec3 axis = random::direction(), tip = random::point(40.0), step = random::point(1.5);
        const double here = distance.clearance(tool, {tip, axis}).clearance;
        const double there = distance.clearance(tool, {tip + step, axis}).clearance;
        RC_ASSERT(std::abs(here - there) <= glm::length(step) + 2e-6);
    }));
}

void ToolClearanceTest::askingOneAfterTheOtherIsTheSame() {
    const std::vector<TriangleMesh> meshes{
        shapes::starShaped(
            60, 30, [](double u, double v) { return 18.0 + 2.0 * std::sin(4.0 * u) * std::cos(v) * std::cos(v); }),
        shapes::pocket(20.0, 15.0, 8.0, 6.0)};
    for (const TriangleMesh& mesh : meshes) {
        const MeshDistance distance(mesh);
        QVERIFY(testing::holdsInShare("a walk with jumps", [&] {
            const std::vector<RevolvedPiece> tool =
                *rc::gen::inRange(0, 2) == 0 ? wholeTool(ball(3.0)) : random::stack();
            glm::dvec3 axis = random::direction();
            const bool turns = *rc::gen::arbitrary<bool>();
            ClearanceAsker asker(distance, tool, axis);
            glm::dvec3 tip = random::point(30.0);
            for (int i = 0; i < 30; ++i) {
                tip = i % 10 == 9 ? random::point(30.0) : tip + random::point(i % 3 == 0 ? 4.0 : 0.5);
                if (turns) axis = i % 10 == 7 ? random::direction() : glm::normalize(axis + random::point(0.05));
                const double within = i % 4 == 0 ? random::number(0.0, 5.0) : 1e300;
                const ToolClearance found =
                    turns ? asker.ask(ToolPose{tip, axis}, within, {}) : asker.ask(tip, within, {});
                const ToolClearance wanted = distance.clearance(tool, {tip, axis}, within);
                RC_ASSERT(std::abs(found.clearance - wanted.clearance) < 1e-6);
            }
        }));
    }
}

void ToolClearanceTest::toleranceIsKept() {
    const MeshDistance distance(shapes::torus(14.0, 6.0, 200, 90));
    const std::vector<RevolvedPiece> tool = wholeTool(flat(3.0));
    const ClearanceTolerance tolerance{0.01, -0.5, 0.3};
    ClearanceAsker asker(distance, tool, {0.0, 0.0, 1.0});
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    glm::dvec3 tip(0.0);
    int deep = 0, ordinary = 0;
    for (int i = 0; i < 3000; ++i) {
        const double reach = i % 50 == 0 ? 0.0 : 0.6;
        if (reach == 0.0) tip = {24.0 * number(engine), 24.0 * number(engine), 8.0 * number(engine)};
        tip += reach * glm::dvec3(number(engine), number(engine), number(engine));
        const double found = asker.ask(tip, 1e300, tolerance).clearance;
        const double over = found - distance.clearance(tool, {tip, {0.0, 0.0, 1.0}}).clearance;
        (found < tolerance.deepBelow ? deep : ordinary) += 1;
        QVERIFY(over >= -1e-6);
        QVERIFY(over <= (found < tolerance.deepBelow ? tolerance.deep : tolerance.ordinary) + 1e-6);
    }
    QVERIFY(deep > 300 && ordinary > 300);
}

void ToolClearanceTest::withinCaps() {
    const MeshDistance distance(shapes::box({-20, -20, -10}, {20, 20, 0}));
    QCOMPARE(distance.clearance(std::array{ball(3.0)}, {{0, 0, 5}, {0, 0, 1}}, 2.0).clearance, 2.0);
    QVERIFY(std::abs(distance.clearance(std::array{ball(3.0)}, {{0, 0, 5}, {0, 0, 1}}, 5.5).clearance - 5.0) < 1e-8);
}

void ToolClearanceTest::whatIsNotFiniteTouchesNothing() {
    const MeshDistance distance(shapes::box({-20, -20, -10}, {20, 20, 0}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(distance.clearance(std::array{ball(3.0)}, {{0, nan, 0}, {0, 0, 1}}, 2.0).clearance, 2.0);
    QCOMPARE(distance.clearance(std::array{ball(3.0)}, {{0, 0, 0}, {nan, 0, 1}}, 2.0).clearance, 2.0);
    QCOMPARE(distance.closest({0, 0, nan}, 3.0).distance, 3.0);
}

void ToolClearanceTest::emptyMeshIsFree() {
    QCOMPARE(MeshDistance{TriangleMesh{}}.clearance(std::array{ball(3.0)}, {{0, 0, 5}, {0, 0, 1}}).clearance, 1e300);
}

BURIN_TEST(ToolClearanceTest, NoApplication)

} // namespace burin::tst_tool_clearance

#include "tst_tool_clearance.moc"
