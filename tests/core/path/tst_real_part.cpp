// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/import.h"
#include "part_oracle.h"
#include "random_edits.h"
#include "tests/places.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QTest>

#include <fstream>

namespace burin::tst_real_part {

using namespace burin::test;

namespace {

constexpr double toolRadius = 3.0;

/// A block with pockets; its faces are plane, so that the mesh is exact. Its centre is at the origin.
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

/// A fork with many fillets, tori and freeform faces, laid on its side; its mesh is at least as accurate as that used
/// by the check.
TriangleMesh legFork() {
    ImportOptions options;
    options.worker = BURIN_BUILD_DIRECTORY "/burin-import";
    options.meshChord = 0.002;
    Progress progress;
    const Result<Model> model = importModel(BURIN_FIXTURES "/models/lower-leg-fork.step", options, progress);
    if (!model) return {};
    TriangleMesh mesh = model->bodies.front().mesh;
    const glm::dvec3 middle = 0.5 * (model->box().low + model->box().high);
    for (glm::dvec3& vertex : mesh.vertices) {
        const glm::dvec3 at = vertex - middle;
        vertex = {at.z, at.y, -at.x + 7.0}; // a rotation about Y
    }
    return mesh;
}

/// Least clearance of a path's cutting moves from a part, up to 1 mm: where the tool is clear, points closer than the
/// clearance are skipped.
double leastClearance(const std::vector<PathPoint>& points, const PartOracle& oracle, double step) {
    double least = 1.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].kind == MoveKind::rapid) continue; // between strokes, without links
        glm::dvec3 last(1e9);
        double clear = 0.0;
        for (const glm::dvec3& place : placesOf(points[i - 1].pose.tip, points[i], step)) {
            if (glm::distance(place, last) < clear) continue;
            last = place;
            clear = oracle.clearance(place, 1.0);
            least = std::min(least, clear);
        }
    }
    return least;
}

/// Edits of the recording and the surface, the last of which keeps the path out of the part; sometimes arcs.
std::vector<Edit> editsWithProjectionLast() {
    std::vector<Edit> edits = randomEdits(false);
    for (const Edit& edit : randomEdits(true)) edits.push_back(edit);
    edits.push_back(*rc::gen::element<Edit>(Edit{HoldOut{}}, Edit{HoldOut{}}, Edit{LayOnPart{}}));
    if (*rc::gen::arbitrary<bool>()) edits.push_back({FitArcs{}});
    return edits;
}

/// For use within a property. @return whether there was anything to judge
bool expectNoGouge(const PathContext& context, const PartOracle& oracle, const glm::dvec3& scale) {
    Take take = randomTake(); // all over the part, inside and outside it
    for (Sample& sample : take.samples) sample.proxy.tip *= scale;
    const auto path = run({take}, editsWithProjectionLast(), context);
    if (isEmpty(path) || missesMoment(path)) return false;
    RC_ASSERT(static_cast<bool>(path));
    RC_ASSERT(leastClearance(path->path.points, oracle, 0.2) >= -0.01);
    return true;
}

} // namespace

class TestRealPart : public QObject {
    Q_OBJECT

private slots:
    void theOracleKnowsTheBlock() {
        const TriangleMesh mesh = pocketBlock();
        const PartOracle oracle(mesh, toolRadius, 5.0);
        QCOMPARE(mesh.triangles.size(), std::size_t{28});
        QCOMPARE(oracle.clearance({48, 48, 20}, 10.0), 2.0);
        QCOMPARE(oracle.clearance({48, 48, 17}, 10.0), -1.0);
        QVERIFY(oracle.clearance({48, 48, 10}, 10.0) < -3.0);
        QCOMPARE(oracle.clearance({60, 0, 5}, 10.0), 7.0);
    }

    void noRandomSequenceOfEditsGouges() {
        const TriangleMesh mesh = pocketBlock();
        const MeshDistance part(mesh);
        const PartOracle oracle(mesh, toolRadius, 5.0);
        const PathContext context = contextOf(part, ballTool(), {{-55, -55, -2}, {55, 55, 18}});
        int judged = 0;
        QVERIFY(testing::holdsInShare("with what holds out of the part last", [&] {
            judged += expectNoGouge(context, oracle, {2.5, 2.5, 1.6}) ? 1 : 0;
        }));
        QVERIFY2(judged > testing::inLongRun(60, 18), qPrintable(QString::number(judged))); // of a hundred, or of 30
    }

    /// The part of the CAD file, its curved faces within 0.002 mm.
    void noRandomSequenceOfEditsGougesCurvedFaces() {
        const TriangleMesh mesh = legFork();
        QVERIFY(mesh.triangles.size() > 10000);
        const MeshDistance part(mesh);
        const double radius = 1.5;
        const PartOracle oracle(mesh, radius, 0.5);
        QVERIFY(std::abs(oracle.clearance({0.0, 0.0, 30.0}, 100.0) - (30.0 - boundingBox(mesh).high.z)) < 20.0);
        const PathContext context = contextOf(part, ballTool(2.0 * radius), {{-36, -12, -2}, {36, 12, 15}});
        int judged = 0;
        QVERIFY(testing::holdsInShare("on fillets, tori and freeform faces", [&] {
            judged += expectNoGouge(context, oracle, {1.8, 0.5, 1.1}) ? 1 : 0;
        }));
        QVERIFY2(judged > testing::inLongRun(60, 18), qPrintable(QString::number(judged)));
    }
};

BURIN_TEST(TestRealPart, NoApplication)

} // namespace burin::tst_real_part

#include "tst_real_part.moc"
