// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/mesh_distance.h"

#include "tests/core/geometry/random_shapes.h"
#include "tests/core/geometry/shapes.h"
#include "tests/places.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QFile>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>

namespace burin::tst_mesh_distance {

namespace {

/// Distance to a triangle without Voronoi regions: foot point in the plane if it is inside, otherwise the edges.
double triangleDistance(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p) {
    const auto edge = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const glm::dvec3 way = to - from;
        const double length = glm::dot(way, way);
        const double t = length > 0.0 ? std::clamp(glm::dot(p - from, way) / length, 0.0, 1.0) : 0.0;
        return glm::length(p - from - t * way);
    };
    double least = std::min({edge(a, b), edge(b, c), edge(c, a)});
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const auto left = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return glm::dot(glm::cross(to - from, p - from), normal) >= 0.0;
    };
    if (glm::length(normal) > 0.0 && left(a, b) && left(b, c) && left(c, a))
        least = std::min(least, std::abs(glm::dot(p - a, glm::normalize(normal))));
    return least;
}

double bruteDistance(const TriangleMesh& mesh, const glm::dvec3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : mesh.triangles)
        least = std::min(least, triangleDistance(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], p));
    return least;
}

/// Solid angle of the mesh over 4 pi: 1 inside, 0 outside (A. van Oosterom and J. Strackee, 1983).
double windingNumber(const TriangleMesh& mesh, const glm::dvec3& p) {
    double sum = 0.0;
    for (const auto& [ia, ib, ic] : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[ia] - p, b = mesh.vertices[ib] - p, c = mesh.vertices[ic] - p;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        sum += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                                la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return sum / (4.0 * std::numbers::pi);
}

/// Reads one triangle after the other, merging corners at the same point.
TriangleMesh binaryStl(const char* file) {
    QFile stl(file);
    if (!stl.open(QIODevice::ReadOnly)) return {};
    const QByteArray content = stl.readAll();
    TriangleMesh mesh;
    for (qsizetype at = 84; at + 50 <= content.size(); at += 50) {
        std::array<float, 12> numbers{};
        std::memcpy(numbers.data(), content.data() + at, sizeof numbers);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::size_t i = 3; i < 12; i += 3) mesh.vertices.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return weldIdenticalVertices(mesh);
}

class Points {
public:
    glm::dvec3 operator()(double reach) {
        std::uniform_real_distribution<double> d(-reach, reach);
        const double x = d(engine_), y = d(engine_), z = d(engine_);
        return {x, y, z};
    }

private:
    std::mt19937_64 engine_{20260101};
};

} // namespace

class MeshDistanceTest : public QObject {
    Q_OBJECT

private slots:
    void emptyMeshIsInfinitelyFar();
    void agreesWithAllTriangles_data();
    void agreesWithAllTriangles();
    void boxByFormula();
    void signOfSharpTetrahedra();
    void splitVerticesAreOneSurface();
    void trianglesWithoutAreaDoNotSpoilTheSign();
    void foldsOfRoundedCornersDoNotSpoilTheSign();
    void stopsLookingWithin();
    void farFromTheOrigin();
    void namesTheTriangle();
};

void MeshDistanceTest::emptyMeshIsInfinitelyFar() {
    const MeshDistance distance{TriangleMesh{}};
    QVERIFY(std::isinf(distance.closest({1.0, 2.0, 3.0}).distance));
    QVERIFY(distance.bounds().empty());
}

void MeshDistanceTest::agreesWithAllTriangles_data() {
    QTest::addColumn<int>("shape");
    QTest::newRow("sphere") << 0;
    QTest::newRow("torus") << 1;
    QTest::newRow("bumps") << 2;
    QTest::newRow("pocket") << 3;
}

void MeshDistanceTest::agreesWithAllTriangles() {
    QFETCH(int, shape);
    const TriangleMesh mesh =
        shape == 0   ? shapes::sphere(10.0, 60, 30)
        : shape == 1 ? shapes::torus(8.0, 3.0, 70, 30)
        : shape == 2
            ? shapes::starShaped(
                  70, 40, [](double u, double v) { return 9.0 + std::sin(5.0 * u) * std::cos(3.0 * v) * std::cos(v); })
            : shapes::pocket(10.0, 8.0, 4.0, 5.0);
    QCOMPARE(countOpenEdges(mesh), std::size_t(0));
    QVERIFY(signedVolume(mesh) > 0.0);
    const MeshDistance distance(mesh);
    Points points;
    for (int i = 0; i < 1500; ++i) {
        const glm::dvec3 p = points(14.0);
        const ClosestPoint found = distance.closest(p);
        const double wanted = bruteDistance(mesh, p);
        QVERIFY2(std::abs(found.distance - wanted) < 1e-9, qPrintable(QString::number(found.distance - wanted)));
        QVERIFY(std::abs(glm::length(found.point - p) - found.distance) < 1e-9);
        QCOMPARE(found.signedDistance<0.0, windingNumber(mesh, p)> 0.5);
        QCOMPARE(std::abs(found.signedDistance), found.distance);
    }
}

void MeshDistanceTest::boxByFormula() {
    const glm::dvec3 low{-3.0, 1.0, 2.0}, high{5.0, 4.0, 3.0};
    const MeshDistance distance(shapes::box(low, high));
    Points points;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 p = points(7.0);
        QVERIFY(std::abs(distance.closest(p).signedDistance - shapes::boxDistance(low, high, p)) < 1e-12);
    }
    // Straight outwards from edges and corners, where single face normals are ambiguous.
    for (const double x : {-4.0, 1.0, 6.0})
        for (const double y : {0.0, 2.0, 5.0})
            for (const double z : {1.0, 2.5, 4.0}) {
                const glm::dvec3 p{x, y, z};
                QVERIFY(std::abs(distance.closest(p).signedDistance - shapes::boxDistance(low, high, p)) < 1e-12);
            }
}

void MeshDistanceTest::signOfSharpTetrahedra() {
    QVERIFY(testing::holdsInShare("inside exactly where all four faces say so", [] {
        TriangleMesh mesh;
        for (int i = 0; i < 4; ++i) mesh.vertices.push_back(random::point(4.0));
        mesh.vertices[3] =
            mesh.vertices[0] + random::number(0.002, 1.0) * (mesh.vertices[3] - mesh.vertices[0]); // also flat ones
        mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        if (signedVolume(mesh) < 0.0)
            for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
        RC_PRE(signedVolume(mesh) > 1e-4);
        const MeshDistance distance(mesh);
        const glm::dvec3 p = random::point(6.0);
        double deepest = -std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c] : mesh.triangles) {
            const glm::dvec3 normal =
                glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
            deepest = std::max(deepest, glm::dot(p - mesh.vertices[a], glm::normalize(normal)));
        }
        RC_PRE(std::abs(deepest) > 1e-9);
        RC_ASSERT((distance.closest(p).signedDistance < 0.0) == (deepest < 0.0));
    }));
}

void MeshDistanceTest::splitVerticesAreOneSurface() {
    // A mesher gives each face vertices of its own.
    const glm::dvec3 low{-1.0}, high{1.0};
    const TriangleMesh joined = shapes::box(low, high);
    TriangleMesh split;
    for (const auto& triangle : joined.triangles) {
        const auto first = static_cast<std::uint32_t>(split.vertices.size());
        for (const std::uint32_t vertex : triangle) split.vertices.push_back(joined.vertices[vertex]);
        split.triangles.push_back({first, first + 1, first + 2});
    }
    const MeshDistance distance(split);
    Points points;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 p = points(3.0);
        QVERIFY(std::abs(distance.closest(p).signedDistance - shapes::boxDistance(low, high, p)) < 1e-12);
    }
}

void MeshDistanceTest::trianglesWithoutAreaDoNotSpoilTheSign() {
    // A corner of the upper side placed on an edge of the front side, with a flat triangle between.
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 1, 2}, {2, 0, 0}};
    mesh.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 4}, {4, 2, 1}, {0, 4, 1}};
    QCOMPARE(countOpenEdges(mesh), std::size_t(0));
    QVERIFY(signedVolume(mesh) > 0.0);
    const MeshDistance distance(mesh);
    Points points;
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 p = points(5.0);
        QCOMPARE(distance.closest(p).signedDistance<0.0, windingNumber(mesh, p)> 0.5);
    }
    for (double x = 0.5; x < 4.0; x += 0.25) QVERIFY(distance.closest({x, -1.0, -1.0}).signedDistance > 0.0);
}

/// The mouse's shell has triangles whose height is below the last digit of their corners, some of them inverted; none
/// of the points around them that are outside is reported as inside.
void MeshDistanceTest::foldsOfRoundedCornersDoNotSpoilTheSign() {
    const TriangleMesh mesh = binaryStl(BURIN_FIXTURES "/models/mouse-shell-top.stl");
    QVERIFY(mesh.triangles.size() > 10000);
    const MeshDistance distance(mesh);
    Points points;
    int outside = 0, slivers = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 u = mesh.vertices[b] - mesh.vertices[a], v = mesh.vertices[c] - mesh.vertices[a];
        const double longest = std::max({glm::length(u), glm::length(v), glm::length(v - u)});
        if (glm::length(glm::cross(u, v)) > 1e-5 * longest) continue;
        ++slivers;
        for (int k = 0; k < 40; ++k) {
            const glm::dvec3 p = mesh.vertices[a] + 0.025 * k * u + points(1.5);
            if (windingNumber(mesh, p) > 0.01) continue;
            ++outside;
            QVERIFY2(distance.closest(p).signedDistance > 0.0,
                     qPrintable(QStringLiteral("%1 %2 %3").arg(p.x).arg(p.y).arg(p.z)));
        }
    }
    QVERIFY(slivers > 3 && outside > 100);
}

void MeshDistanceTest::stopsLookingWithin() {
    const MeshDistance distance(shapes::sphere(10.0, 60, 30));
    const glm::dvec3 p{14.0, 0.0, 0.0};
    QVERIFY(std::abs(distance.closest(p, 4.5).distance - 4.0) < 1e-9);
    QCOMPARE(distance.closest(p, 3.5).distance, 3.5);
}

void MeshDistanceTest::farFromTheOrigin() {
    const glm::dvec3 shift{1e5, -2e5, 3e5};
    TriangleMesh mesh = shapes::box(glm::dvec3(-1.0), glm::dvec3(1.0));
    for (glm::dvec3& v : mesh.vertices) v += shift;
    const MeshDistance distance(mesh);
    Points points;
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 p = points(4.0);
        const double wanted = shapes::boxDistance(glm::dvec3(-1.0), glm::dvec3(1.0), p);
        QVERIFY(std::abs(distance.closest(p + shift).signedDistance - wanted) < 1e-9);
    }
    QVERIFY(std::abs(distance.closest({0.0, 0.0, 0.0}).distance - bruteDistance(mesh, glm::dvec3(0.0))) < 1e-6);
}

void MeshDistanceTest::namesTheTriangle() {
    const TriangleMesh mesh = shapes::sphere(10.0, 40, 20);
    const MeshDistance distance(mesh);
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 7) {
        const auto& [a, b, c] = mesh.triangles[i];
        const glm::dvec3 middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
        QCOMPARE(distance.closest(1.01 * middle).triangle, i);
    }
}

BURIN_TEST(MeshDistanceTest, NoApplication)

} // namespace burin::tst_mesh_distance

#include "tst_mesh_distance.moc"
