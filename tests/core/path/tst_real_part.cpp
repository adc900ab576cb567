// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "random_edits.h"

#include <QTest>

#include <fstream>

using namespace burin;
using namespace burin::test;

namespace {

constexpr double toolRadius = 3.0;

/// A block with pockets; its faces are level, so that the mesh is the part. Its middle lies at the origin.
TriangleMesh pocketBlock() {
    std::ifstream file(BURIN_FIXTURES "/models/pocket-test.stl");
    TriangleMesh mesh;
    std::string word;
    while (file >> word) {
        if (word != "vertex") continue;
        glm::dvec3 corner(0.0);
        file >> corner.x >> corner.y >> corner.z;
        mesh.vertices.push_back(corner);
        const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
        if (count % 3 == 0) mesh.triangles.push_back({count - 3, count - 2, count - 1});
    }
    return weldIdenticalVertices(mesh);
}

/// Nearest place of a triangle, by its inside and its three edges; slow and obvious.
double triangleDistance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    const glm::dvec3 foot = p - glm::dot(p - a, normal) * normal;
    const bool inside = glm::dot(glm::cross(b - a, foot - a), normal) >= 0.0 &&
                        glm::dot(glm::cross(c - b, foot - b), normal) >= 0.0 &&
                        glm::dot(glm::cross(a - c, foot - c), normal) >= 0.0;
    if (inside) return glm::distance(p, foot);
    return distanceToPolyline(p, {a, b, c, a});
}

class PartOracle {
public:
    explicit PartOracle(const TriangleMesh& mesh) : mesh_(mesh) {}

    /// How far the ball, and the places of the shaft's axis a millimetre apart, keep from the part at least.
    double clearance(const glm::dvec3& tip) const {
        double least = 1e9;
        for (int i = 0; i <= 20; ++i) {
            const glm::dvec3 place = tip + glm::dvec3(0.0, 0.0, toolRadius + i);
            const double distance = distanceTo(place);
            least = std::min(least, (isInside(place) ? -distance : distance) - toolRadius);
            if (place.z > 18.0 + toolRadius) break; // above the block
        }
        return least;
    }

private:
    double distanceTo(const glm::dvec3& place) const {
        double nearest = 1e9;
        for (const auto& t : mesh_.triangles)
            nearest = std::min(
                nearest, triangleDistance(place, mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]));
        return nearest;
    }
    /// By the parity of what a ray upwards, a little askew, goes through.
    bool isInside(const glm::dvec3& place) const {
        const glm::dvec3 way(0.00371, 0.00597, 1.0);
        bool inside = false;
        for (const auto& t : mesh_.triangles) {
            const glm::dvec3 &a = mesh_.vertices[t[0]], &b = mesh_.vertices[t[1]], &c = mesh_.vertices[t[2]];
            const glm::dvec3 normal = glm::cross(b - a, c - a);
            const double slope = glm::dot(normal, way);
            if (slope == 0.0) continue;
            const double along = glm::dot(normal, a - place) / slope;
            const glm::dvec3 hit = place + along * way;
            const bool goesThrough = glm::dot(glm::cross(b - a, hit - a), normal) >= 0.0 &&
                                     glm::dot(glm::cross(c - b, hit - b), normal) >= 0.0 &&
                                     glm::dot(glm::cross(a - c, hit - c), normal) >= 0.0;
            if (along > 0.0 && goesThrough) inside = !inside;
        }
        return inside;
    }

    const TriangleMesh& mesh_;
};

} // namespace

class TestRealPart : public QObject {
    Q_OBJECT

private slots:
    void theOracleKnowsTheBlock() {
        const TriangleMesh mesh = pocketBlock();
        const PartOracle oracle(mesh);
        QCOMPARE(mesh.triangles.size(), std::size_t{28});
        QCOMPARE(oracle.clearance({48, 48, 20}), 2.0);
        QCOMPARE(oracle.clearance({48, 48, 15}), -3.0);
        QCOMPARE(oracle.clearance({60, 0, 5}), 7.0);
    }

    void noRandomSequenceOfEditsGouges() {
        const TriangleMesh mesh = pocketBlock();
        const MeshDistance part(mesh);
        const PartOracle oracle(mesh);
        const PathContext context = contextOf(part, ballTool(), {{-55, -55, -2}, {55, 55, 18}});
        int judged = 0;
        QVERIFY(rc::check("with what holds out of the part last", [&] {
            Take take = randomTake(); // all over the block, in and out of its pockets
            for (Sample& sample : take.samples) sample.proxy.tip *= glm::dvec3(2.5, 2.5, 1.6);
            std::vector<Edit> edits = randomEdits(false);
            for (const Edit& edit : randomEdits(true)) edits.push_back(edit);
            edits.push_back(*rc::gen::element<Edit>(Edit{HoldOut{}}, Edit{HoldOut{}}, Edit{LayOnPart{}}));
            if (*rc::gen::arbitrary<bool>()) edits.push_back({FitArcs{}});
            const auto path = run({take}, edits, context);
            if (!path && path.error().code == ErrorCode::pathEmpty) return;
            RC_ASSERT(static_cast<bool>(path));
            for (std::size_t i = 1; i < path->path.points.size(); ++i) {
                const PathPoint& point = path->path.points[i];
                if (point.kind == MoveKind::rapid) continue; // from stroke to stroke, without links
                for (const glm::dvec3& place : placesOf(path->path.points[i - 1].tip, point, 0.25))
                    RC_ASSERT(oracle.clearance(place) >= -0.01);
            }
            ++judged;
        }));
        QVERIFY2(judged > 60, qPrintable(QString::number(judged))); // of a hundred
    }
};

QTEST_APPLESS_MAIN(TestRealPart)
#include "tst_real_part.moc"
