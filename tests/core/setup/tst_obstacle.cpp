// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/obstacle.h"
#include "tests/core/geometry/shapes.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_obstacle {

namespace {

Model modelOf(const std::vector<TriangleMesh>& meshes) {
    Model model;
    model.sourceFile = "/fixtures/vise.step";
    for (const TriangleMesh& mesh : meshes) {
        Body body;
        body.name = "jaw " + std::to_string(model.bodies.size() + 1);
        body.mesh = mesh;
        body.box = boundingBox(mesh);
        model.bodies.push_back(body);
    }
    return model;
}

const TriangleMesh cube = shapes::box({0, 0, 0}, {1, 2, 3});

} // namespace

class TestObstacle : public QObject {
    Q_OBJECT
private slots:
    void eachBodyOfAModelIsAFixtureOfItsOwn() {
        const Result<std::vector<Obstacle>> one = fixturesOf(modelOf({cube}), "vise", 0.5);
        QVERIFY(one && one->size() == 1);
        QCOMPARE(one->front().name, std::string("vise"));
        QCOMPARE(one->front().margin, 0.5);
        QVERIFY(one->front().kind == ObstacleKind::fixture && one->front().on);
        const Result<std::vector<Obstacle>> two =
            fixturesOf(modelOf({cube, shapes::box({5, 0, 0}, {6, 1, 1})}), "vise", 0.0);
        QVERIFY(two && two->size() == 2);
        QCOMPARE(two->back().name, std::string("vise: jaw 2"));
        QCOMPARE(boundsOf(two->back()).low, glm::dvec3(5, 0, 0));
    }

    void aFixtureThatIsInsideOutIsTurned() {
        TriangleMesh inward = cube;
        for (auto& triangle : inward.triangles) std::swap(triangle[0], triangle[1]);
        const Result<std::vector<Obstacle>> fixtures = fixturesOf(modelOf({inward}), "vise", 0.0);
        QVERIFY(fixtures);
        QVERIFY(std::abs(signedVolume(meshOf(fixtures->front())) - 6.0) < 1e-12);
    }

    void anOpenFixtureIsRefusedWithItsBody() {
        TriangleMesh open = cube;
        open.triangles.pop_back();
        const Result<std::vector<Obstacle>> fixtures = fixturesOf(modelOf({cube, open}), "vise", 0.0);
        QVERIFY(!fixtures);
        QCOMPARE(fixtures.error().code, ErrorCode::modelNotWatertight);
        QCOMPARE(fixtures.error().subject, std::string("/fixtures/vise.step"));
        QVERIFY(fixtures.error().place.starts_with("jaw 2: 3 "));
        QCOMPARE(fixturesOf(modelOf({}), "vise", 0.0).error().code, ErrorCode::modelHasNoSolid);
    }

    void aShapeThatCantBeIsRefused() {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const glm::dvec3 up(0, 0, 1);
        Obstacle good;
        good.shape = cube;
        QVERIFY(checkObstacle(good));
        Obstacle tight = good;
        tight.margin = -0.1;
        std::vector<Obstacle> wrong{tight};
        for (const auto& shape : std::vector<std::variant<Box, CylinderShape, TriangleMesh>>{
                 Box{{0, 0, 0}, {1, 0, 1}}, Box{{0, 0, nan}, {1, 1, 1}}, Box{},
                 CylinderShape{{0, 0, 0}, 2.0 * up, 1, 1}, CylinderShape{{0, 0, 0}, up, 0, 1},
                 CylinderShape{{0, 0, 0}, up, 1, nan}, TriangleMesh{}, TriangleMesh{{{0, 0, 0}}, {{0, 0, 1}}}}) {
            wrong.push_back(good);
            wrong.back().shape = shape;
        }
        for (const Obstacle& obstacle : wrong)
            QCOMPARE(checkObstacle(obstacle).error().code, ErrorCode::argumentInvalid);
    }

    void itsBoxHoldsItsMeshAndNoMore() {
        Obstacle column;
        column.shape = CylinderShape{{1, 2, 3}, glm::normalize(glm::dvec3(1, 2, -1)), 2.0, 7.0};
        const Box box = boundsOf(column), mesh = boundingBox(meshOf(column));
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(std::abs(box.low[axis] - mesh.low[axis]) < 2.0 * cylinderChord);
            QVERIFY(std::abs(box.high[axis] - mesh.high[axis]) < 2.0 * cylinderChord);
        }
    }
};

BURIN_TEST(TestObstacle, NoApplication)

} // namespace burin::tst_obstacle

#include "tst_obstacle.moc"
