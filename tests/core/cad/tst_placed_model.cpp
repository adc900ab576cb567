// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "cad_test.h"

#include "core/base/units.h"
#include "core/cad/part_edge.h"
#include "core/cad/part_face.h"
#include "core/geometry/triangle_mesh.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <random>

namespace burin::tst_placed_model {

using namespace burin::test;

namespace {

std::shared_ptr<const Model> shared(const char* name) {
    Result<Model> model = import(modelFile(name));
    return model ? std::make_shared<const Model>(std::move(*model)) : nullptr;
}

Result<PartFace> faceAt(const Model& model, const glm::dvec3& place) {
    Progress progress;
    return partFaceAt(model, place, options(), progress);
}

const Placement tilted = combined(turnedAbout({0.3, -0.5, 0.8}, 1.1, {1.0, 2.0, 3.0}), movedBy({7.0, -8.0, 9.0}));

} // namespace

/// A model placed in another frame is the same body there: its mesh, its box, its exact surface and its edges.
class PlacedModel : public QObject {
    Q_OBJECT

private slots:
    void neitherTurnedNorMovedItIsTheSame() {
        const auto model = shared("cube.brep");
        QVERIFY(model && placed(model, {}) == model);
    }

    void bodiesKeepTheirVolumeAndStayClosed() {
        const auto model = shared("mouse-cover.step");
        QVERIFY(model);
        for (const Placement& placement :
             {tilted, mirroredAcross(0, {1.0, 0.0, 0.0}), combined(tilted, mirroredAcross(2, {}))}) {
            const auto other = placed(model, placement);
            for (std::size_t i = 0; i < model->bodies.size(); ++i) {
                const Body &before = model->bodies[i], &after = other->bodies[i];
                QCOMPARE(countOpenEdges(after.mesh), countOpenEdges(before.mesh));
                const double volume = signedVolume(before.mesh);
                QVERIFY(std::abs(signedVolume(after.mesh) - volume) < 1e-9 * volume);
                const Box mesh = boundingBox(after.mesh);
                for (int axis = 0; axis < 3; ++axis) {
                    QVERIFY(after.box.low[axis] <= mesh.low[axis] + 1e-9);
                    QVERIFY(after.box.high[axis] >= mesh.high[axis] - 1e-9);
                    QVERIFY(mesh.low[axis] - after.box.low[axis] < model->meshChord + 1e-6);
                }
            }
        }
    }

    /// OpenCASCADE measures the same from a transformed point to the placed model as from the original point.
    void exactDistancesGoWithThePlacement() {
        const auto model = shared("featuretype.step");
        QVERIFY(model);
        std::mt19937 random(4711);
        const Box around = model->box().grown(3.0);
        std::vector<glm::dvec3> places, moved;
        const Placement placement = combined(tilted, mirroredAcross(1, {0.0, 4.0, 0.0}));
        for (int i = 0; i < 40; ++i) {
            std::uniform_real_distribution<double> share(0.0, 1.0);
            const glm::dvec3 at(share(random), share(random), share(random));
            places.push_back(around.low + at * around.size());
            moved.push_back(placement.point(places.back()));
        }
        Progress progress;
        const auto before = exactSignedDistances(*model, places, options(), progress);
        const auto after = exactSignedDistances(*placed(model, placement), moved, options(), progress);
        QVERIFY(before && after);
        for (std::size_t i = 0; i < places.size(); ++i) QVERIFY(std::abs((*before)[i] - (*after)[i]) < 1e-7);
    }

    void edgesGoWithThePlacement() {
        const auto model = shared("cube.brep");
        QVERIFY(model);
        Progress progress;
        const auto before = partEdges(*model, 0.01, options(), progress);
        const auto after = partEdges(*placed(model, tilted), 0.01, options(), progress);
        QVERIFY(before && after && before->size() == after->size());
        for (std::size_t i = 0; i < before->size(); ++i) {
            QVERIFY(glm::distance(tilted.point((*before)[i].points.front()), (*after)[i].points.front()) < 1e-9);
            QVERIFY(glm::distance(tilted.direction((*before)[i].tangents.front()), (*after)[i].tangents.front()) <
                    1e-9);
        }
    }

    /// A cube of 10 mm: six planes, each with its own normal, wherever it is placed.
    void facesOfACubeArePlanes() {
        const auto model = shared("cube.brep");
        QVERIFY(model);
        const Box box = model->box();
        for (const Placement& placement : {Placement{}, tilted, mirroredAcross(2, {0.0, 0.0, 1.0})}) {
            const auto lying = placed(model, placement);
            for (int axis = 0; axis < 3; ++axis)
                for (const double side : {-1.0, 1.0}) {
                    glm::dvec3 normal(0.0);
                    normal[axis] = side;
                    const glm::dvec3 place = box.centre() + 0.5 * box.size() * normal + 0.01 * normal;
                    const Result<PartFace> face = faceAt(*lying, placement.point(place));
                    QVERIFY2(face, face ? "" : describe(face.error()).c_str());
                    QCOMPARE(face->kind, PartFace::Kind::plane);
                    QVERIFY(glm::distance(face->direction, placement.direction(normal)) < 1e-9);
                    QVERIFY(std::abs(glm::distance(face->place, placement.point(place)) - 0.01) < 1e-6);
                }
        }
    }

    void aCylinderHasItsAxisAndItsEnds() {
        const auto model = shared("red-cube-blue-cylinder.step");
        QVERIFY(model);
        const auto cylinder = std::ranges::find_if(model->bodies, [](const Body& body) { return body.faceCount == 3; });
        QVERIFY(cylinder != model->bodies.end());
        const glm::dvec3 size = cylinder->box.size(), centre = cylinder->box.centre();
        int along = 2; // the dimension that differs from the two equal ones
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(size[(axis + 1) % 3] - size[(axis + 2) % 3]) < 1e-3) along = axis;
        glm::dvec3 beside(0.0), above(0.0);
        beside[(along + 1) % 3] = 0.5 * size[(along + 1) % 3];
        above[along] = 0.5 * size[along];
        const Result<PartFace> side = faceAt(*model, centre + beside), end = faceAt(*model, centre + above);
        QVERIFY(side && side->kind == PartFace::Kind::round && std::abs(std::abs(side->direction[along]) - 1.0) < 1e-9);
        QVERIFY(end && end->kind == PartFace::Kind::plane && std::abs(end->direction[along] - 1.0) < 1e-9);
    }

    /// Pointing near a vertex selects the vertex; in the middle of an edge it selects the midpoint.
    void cornersOfACubeAreItsVerticesAndTheMiddlesOfItsEdges() {
        const auto model = shared("cube.brep");
        QVERIFY(model);
        const Box box = model->box();
        const double size = box.size().x;
        for (const Placement& placement : {Placement{}, tilted}) {
            const auto lying = placed(model, placement);
            const auto corner = [&](const glm::dvec3& share) {
                return faceAt(*lying, placement.point(box.low + share * size)).value().corner;
            };
            const auto at = [&](const glm::dvec3& share) { return placement.point(box.low + share * size); };
            QVERIFY(glm::distance(corner({0.1, 0.05, 1.0}), at({0.0, 0.0, 1.0})) < 1e-9);
            QVERIFY(glm::distance(corner({0.9, 0.9, 1.0}), at({1.0, 1.0, 1.0})) < 1e-9);
            QVERIFY(glm::distance(corner({0.5, 0.1, 1.0}), at({0.5, 0.0, 1.0})) < 1e-9);
            QVERIFY(glm::distance(corner({1.0, 0.45, 0.8}), at({1.0, 0.5, 1.0})) < 1e-9);
        }
    }

    /// Nobody can point at the centre of a bore: pointing at its rim selects it.
    void theRimOfACircleMeansItsCentre() {
        const auto model = shared("red-cube-blue-cylinder.step");
        const auto cylinder = std::ranges::find_if(model->bodies, [](const Body& body) { return body.faceCount == 3; });
        QVERIFY(cylinder != model->bodies.end());
        const glm::dvec3 size = cylinder->box.size(), centre = cylinder->box.centre();
        int along = 2;
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(size[(axis + 1) % 3] - size[(axis + 2) % 3]) < 1e-3) along = axis;
        glm::dvec3 above(0.0), beside(0.0);
        above[along] = 0.5 * size[along];
        beside[(along + 2) % 3] = 0.45 * size[(along + 2) % 3];
        const Result<PartFace> end = faceAt(*model, centre + above + beside);
        QVERIFY(end);
        QVERIFY2(glm::distance(end->corner, centre + above) < 0.01, // the box follows the mesh
                 qPrintable(QString::number(glm::distance(end->corner, centre + above))));
    }

    /// A mesh file contains nothing but triangles.
    void aMeshHasItsTriangles() {
        const auto model = shared("featuretype.stl");
        QVERIFY(model && model->brep.empty());
        const Box box = model->box();
        const Result<PartFace> below = faceAt(*model, {box.centre().x, box.centre().y, box.low.z - 1.0});
        QVERIFY(below && below->kind == PartFace::Kind::plane);
        QVERIFY(std::abs(below->place.z - box.low.z) < 1e-6 && below->direction.z < -0.999);
        QCOMPARE(faceAt(Model{}, {}).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(faceAt(*model, {std::nan(""), 0.0, 0.0}).error().code, ErrorCode::argumentInvalid);
    }
};

BURIN_TEST(PlacedModel, NoApplication)

} // namespace burin::tst_placed_model

#include "tst_placed_model.moc"
