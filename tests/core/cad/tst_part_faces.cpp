// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "cad_test.h"

#include "core/base/units.h"
#include "core/cad/part_faces.h"
#include "core/cad/reader/face_patches.h"
#include "core/cad/worker_message.h"
#include "tests/test_program.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace burin::tst_part_faces {

using namespace burin::test;
using Kind = MeasuredFace::Kind;

namespace {

constexpr double chord = 0.01; // mm

/// A block of 40 x 30 x 20 mm with a corner at the origin and, from above, a round pocket at (20, 15) with a radius of
/// 6 mm, 8 mm deep.
TopoDS_Shape blockWithPocket() {
    const gp_Ax2 axis(gp_Pnt(20.0, 15.0, 12.0), gp_Dir(0.0, 0.0, 1.0));
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Shape(),
                           BRepPrimAPI_MakeCylinder(axis, 6.0, 10.0).Shape())
        .Shape();
}

/// Identifies a face of the block by the position of its triangles: a side of the block, or a face of the pocket.
enum class Side { bottom, top, left, right, front, back, wall, floor };
Side sideOf(const TriangleMesh& mesh) {
    const Box box = boundingBox(mesh);
    const glm::dvec3 size = box.size();
    if (size.z < 1e-9) return box.low.z < 1e-9 ? Side::bottom : box.low.z > 19.0 ? Side::top : Side::floor;
    if (size.x < 1e-9) return box.low.x < 1e-9 ? Side::left : Side::right;
    if (size.x < 13.0) return Side::wall;
    return box.low.y < 1e-9 ? Side::front : Side::back;
}
double areaOf(Side side) {
    const std::map<Side, double> areas{{Side::bottom, 1200.0},  {Side::top, 1200.0 - 36.0 * pi},
                                       {Side::left, 600.0},     {Side::right, 600.0},
                                       {Side::front, 800.0},    {Side::back, 800.0},
                                       {Side::wall, 96.0 * pi}, {Side::floor, 36.0 * pi}};
    return areas.at(side);
}

TriangleMesh joined(const std::vector<PartFacePatch>& patches) {
    TriangleMesh mesh;
    for (const PartFacePatch& patch : patches) append(mesh, patch.mesh);
    return mesh;
}

/// A prism over a regular polygon with a radius of 10 mm, 5 mm high; no vertices are shared, as in an STL file.
TriangleMesh prism(int corners) {
    TriangleMesh mesh;
    const auto on = [corners](int i, double z) {
        const double angle = 2.0 * pi * i / corners;
        return glm::dvec3(10.0 * std::cos(angle), 10.0 * std::sin(angle), z);
    };
    const auto triangle = [&mesh](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
        mesh.triangles.push_back({first, first + 1, first + 2});
    };
    for (int i = 0; i < corners; ++i) {
        const int next = (i + 1) % corners;
        triangle({0.0, 0.0, 5.0}, on(i, 5.0), on(next, 5.0));
        triangle({0.0, 0.0, 0.0}, on(next, 0.0), on(i, 0.0));
        triangle(on(i, 0.0), on(next, 0.0), on(next, 5.0));
        triangle(on(i, 0.0), on(next, 5.0), on(i, 5.0));
    }
    return mesh;
}

Result<std::vector<PartFacePatch>> facesOf(const Model& model) {
    Progress progress;
    return partFaces(model, options(), progress);
}

std::vector<PartFacePatch> patchesOf(const TopoDS_Shape& shape) {
    Result<std::vector<PartFacePatch>> patches = facePatches(shape, chord, false, [](double) {});
    return patches ? std::move(*patches) : std::vector<PartFacePatch>();
}

bool close(double value, double wanted) {
    return std::abs(value / wanted - 1.0) < 1e-5;
}

} // namespace

class PartFacesTest : public QObject {
    Q_OBJECT
private slots:
    /// Through the import program, with the block placed in a setup: count, kinds, radii and areas by formula.
    void theFacesOfABlockWithAPocket() {
        const std::string file = folder_.filePath("block.brep").toStdString();
        QVERIFY(BRepTools::Write(blockWithPocket(), file.c_str()));
        const Result<Model> model = import(file);
        QVERIFY(model);
        const Result<std::vector<PartFacePatch>> faces = facesOf(*model);
        QVERIFY2(faces, faces ? "" : describe(faces.error()).c_str());
        QCOMPARE(faces->size(), std::size_t{8});
        std::map<Side, int> met;
        for (const PartFacePatch& face : *faces) {
            const Side side = sideOf(face.mesh);
            ++met[side];
            QVERIFY(face.kind == (side == Side::wall ? Kind::cylinder : Kind::plane));
            QVERIFY(std::abs(face.radius - (side == Side::wall ? 6.0 : 0.0)) < 1e-9);
            QVERIFY2(close(face.area, areaOf(side)), qPrintable(QString::number(face.area)));
            // With a chord c on a radius r, the area of the triangles is too small by a share of at most c / r.
            QVERIFY(std::abs(surfaceArea(face.mesh) / face.area - 1.0) < 2e-3);
        }
        QCOMPARE(met.size(), std::size_t{8});
        // Together they are the surface of the part, with the material inside.
        QVERIFY(std::abs(signedVolume(joined(*faces)) / (24000.0 - 288.0 * pi) - 1.0) < 1e-3);
    }

    /// The order is that of the B-rep, here taken from OpenCASCADE directly.
    void theOrderIsThatOfTheShape() {
        const TopoDS_Shape block = blockWithPocket();
        const std::vector<PartFacePatch> faces = patchesOf(block);
        QCOMPARE(faces.size(), std::size_t{8});
        std::size_t number = 0;
        for (TopExp_Explorer each(block, TopAbs_FACE); each.More(); each.Next(), ++number) {
            TriangleMesh corners; // the vertices of the face
            for (TopExp_Explorer vertex(each.Current(), TopAbs_VERTEX); vertex.More(); vertex.Next()) {
                const gp_Pnt place = BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current()));
                corners.vertices.emplace_back(place.X(), place.Y(), place.Z());
            }
            for (const glm::dvec3& corner : corners.vertices)
                QVERIFY(std::ranges::any_of(faces[number].mesh.vertices, [&](const glm::dvec3& vertex) {
                    return glm::distance(vertex, corner) < 1e-6;
                }));
        }
    }

    void roundFacesHaveTheirKindAndRadius_data() {
        QTest::addColumn<TopoDS_Shape>("shape");
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("radius"); // mm
        QTest::addColumn<double>("area");   // mm²
        const double side = std::hypot(4.0, 3.0);
        QTest::newRow("sphere") << TopoDS_Shape(BRepPrimAPI_MakeSphere(8.0).Shape()) << int(Kind::sphere) << 8.0
                                << 256.0 * pi;
        QTest::newRow("torus") << TopoDS_Shape(BRepPrimAPI_MakeTorus(5.0, 2.0).Shape()) << int(Kind::torus) << 2.0
                               << 40.0 * pi * pi;
        QTest::newRow("cone") << TopoDS_Shape(BRepPrimAPI_MakeCone(3.0, 0.0, 4.0).Shape()) << int(Kind::cone) << 0.0
                              << 3.0 * pi * side;
    }
    void roundFacesHaveTheirKindAndRadius() {
        QFETCH(TopoDS_Shape, shape);
        QFETCH(int, kind);
        QFETCH(double, radius);
        QFETCH(double, area);
        const std::vector<PartFacePatch> faces = patchesOf(shape);
        QVERIFY(!faces.empty());
        QVERIFY(int(faces.front().kind) == kind && std::abs(faces.front().radius - radius) < 1e-9);
        QVERIFY(close(faces.front().area, area));
    }

    /// Mirrored and moved: the faces lie on the mesh of the body and still face outwards.
    void aPlacedPartHasItsFacesWhereItLies() {
        const std::string file = folder_.filePath("placed.brep").toStdString();
        QVERIFY(BRepTools::Write(blockWithPocket(), file.c_str()));
        Result<Model> model = import(file);
        QVERIFY(model);
        const Placement placement = combined(mirroredAcross(0, glm::dvec3(7.0)), movedBy({1.0, 2.0, 3.0}));
        const auto part = placed(std::make_shared<const Model>(std::move(*model)), placement);
        const Result<std::vector<PartFacePatch>> faces = facesOf(*part);
        QVERIFY(faces);
        const TriangleMesh mesh = joined(*faces);
        QVERIFY(signedVolume(mesh) > 0.0);
        const Box box = boundingBox(mesh);
        QVERIFY(glm::distance(box.low, part->box().low) < 1e-6 && glm::distance(box.high, part->box().high) < 1e-6);
    }

    /// A bend of 30 degrees is an edge, one of 10 degrees is not. Areas are those of polygons.
    void regionsOfAMeshEndAtSharpBends() {
        for (const int corners : {12, 36}) {
            Model model;
            model.bodies.emplace_back().mesh = prism(corners);
            const Result<std::vector<PartFacePatch>> faces = facesOf(model);
            QVERIFY(faces);
            const bool sharp = corners == 12;
            QCOMPARE(faces->size(), static_cast<std::size_t>(sharp ? 2 + corners : 3));
            const double end = 0.5 * corners * 100.0 * std::sin(2.0 * pi / corners);
            const double sides = 5.0 * corners * 20.0 * std::sin(pi / corners);
            for (const PartFacePatch& face : *faces) {
                const bool side = boundingBox(face.mesh).size().z > 1.0;
                QVERIFY(face.kind == (side && !sharp ? Kind::other : Kind::plane));
                QVERIFY(close(face.area, side ? (sharp ? sides / corners : sides) : end));
                QCOMPARE(face.radius, 0.0);
            }
        }
    }

    void withoutABodyThereAreNone() {
        const Result<std::vector<PartFacePatch>> faces = facesOf(Model());
        QVERIFY(!faces && faces.error().code == ErrorCode::argumentInvalid);
    }

    void cancellingEndsIt() {
        Model model;
        model.bodies.emplace_back().mesh = prism(12);
        Progress progress;
        progress.cancel();
        const Result<std::vector<PartFacePatch>> faces = partFaces(model, options(), progress);
        QVERIFY(!faces && faces.error().code == ErrorCode::cancelled);
    }

    /// If only divided faces could be meshed, each half belongs to its original face.
    void halvesBelongToTheirFace() {
        const TopoDS_Shape block = blockWithPocket();
        const TopoDS_Solid solid = TopoDS::Solid(TopExp_Explorer(block, TopAbs_SOLID).Current());
        SolidMesh mesh = meshSolid(solid, chord, [](double) {});
        const std::vector<std::uint32_t> before = mesh.faceOf;
        QCOMPARE(ownersOf(solid, mesh).size(), std::size_t{8});
        mesh.divided = true;
        for (std::size_t i = 0; i < mesh.faceOf.size(); ++i) { // divided at the middle of the block and renumbered
            const auto& [a, b, c] = mesh.mesh.triangles[i];
            const double x = (mesh.mesh.vertices[a].x + mesh.mesh.vertices[b].x + mesh.mesh.vertices[c].x) / 3.0;
            mesh.faceOf[i] = 2 * (7 - before[i]) + (x > 20.0 ? 1 : 0);
        }
        const std::vector<std::uint32_t> owners = ownersOf(solid, mesh);
        for (std::size_t i = 0; i < before.size(); ++i) QCOMPARE(owners[mesh.faceOf[i]], before[i]);
    }

    /// Requests and answers are transmitted unchanged, and damaged ones are refused.
    void messagesComeThrough() {
        const PatchRequest asked{"brep", {2, 5}, 0.02, true};
        const std::optional<WorkerRequest> request = decodeRequest(encodeRequest(asked));
        const auto* same = request ? std::get_if<PatchRequest>(&*request) : nullptr;
        QVERIFY(same && same->brep == asked.brep && same->solids == asked.solids && same->chord == asked.chord &&
                same->careful);
        std::vector<PartFacePatch> patches(2);
        patches[0] = {Kind::torus, 1.5, 12.25, {}};
        patches[1].mesh.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.5}};
        patches[1].mesh.triangles = {{0, 1, 2}};
        const auto read = [](const std::string& frame) {
            FrameReader reader;
            reader.append(frame);
            return reader.next();
        };
        const std::string frame = encodeFrame(WorkerAnswer(patches));
        const std::optional<WorkerFrame> whole = read(frame);
        const auto* answer = whole ? std::get_if<WorkerAnswer>(&*whole) : nullptr;
        const auto* got = answer != nullptr ? std::get_if<std::vector<PartFacePatch>>(answer) : nullptr;
        QVERIFY(got && got->size() == 2);
        QVERIFY(got->front().kind == Kind::torus && got->front().radius == 1.5 && got->front().area == 12.25);
        QVERIFY(got->back().mesh.vertices == patches[1].mesh.vertices);
        QVERIFY(got->back().mesh.triangles == patches[1].mesh.triangles);
        for (std::size_t i = 0; i < frame.size(); ++i) {
            std::string broken = frame;
            broken[i] = static_cast<char>(broken[i] ^ 0x55);
            QVERIFY(!read(broken) || (i >= 12 && i < 16)); // only the reserved word may change undetected
        }
        std::vector<PartFacePatch> outside = patches, nowhere = patches, endless = patches;
        outside[1].mesh.triangles = {{0, 1, 3}};
        nowhere[1].mesh.vertices[1].y = std::numeric_limits<double>::quiet_NaN();
        endless[0].area = std::numeric_limits<double>::infinity();
        for (const auto& wrong : {outside, nowhere, endless}) QVERIFY(!read(encodeFrame(WorkerAnswer(wrong))));
    }

private:
    QTemporaryDir folder_;
};

BURIN_TEST(PartFacesTest, QCoreApplication)

} // namespace burin::tst_part_faces

#include "tst_part_faces.moc"
