// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/setup/obstacle_motion.h"
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

    /// Corners, volume and axis after a rotation by 30° about Z through (5, 0, 0) and a shift, by hand. A box holds
    /// quarter turns alone.
    void whatIsMovedKeepsItsForm() {
        const double cosine = std::sqrt(0.75), sine = 0.5;
        const Placement by =
            combined(turnedAbout({0.0, 0.0, 1.0}, pi / 6.0, {5.0, 0.0, 0.0}), movedBy({0.0, 0.0, 4.0}));
        const Obstacle mesh{"jaw", cube, 1.5, false, ObstacleKind::keepOut};
        const Result<Obstacle> turned = moved(mesh, by);
        QVERIFY(turned && turned->margin == 1.5 && !turned->on && turned->kind == ObstacleKind::keepOut);
        const Box around = boundsOf(*turned);
        QVERIFY(glm::distance(around.low, {5.0 - 5.0 * cosine - 2.0 * sine, -5.0 * sine, 4.0}) < 1e-12);
        QVERIFY(glm::distance(around.high, {5.0 - 4.0 * cosine, 2.0 * cosine - 4.0 * sine, 7.0}) < 1e-12);
        QVERIFY(std::abs(signedVolume(std::get<TriangleMesh>(turned->shape)) - 6.0) < 1e-12);

        const Obstacle lying{"bar", CylinderShape{{6.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 2.0, 7.0}};
        const auto bar = std::get<CylinderShape>(moved(lying, by)->shape);
        QVERIFY(glm::distance(bar.base, {5.0 + cosine, sine, 5.0}) < 1e-12);
        QVERIFY(glm::distance(bar.axis, {cosine, sine, 0.0}) < 1e-12 && bar.radius == 2.0 && bar.height == 7.0);

        const Obstacle box{"block", Box{{0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}}};
        const Result<Obstacle> refused = moved(box, by);
        QVERIFY(!refused && refused.error().code == ErrorCode::argumentInvalid);
        const auto quarter = std::get<Box>(moved(box, turnedAbout({0.0, 0.0, 1.0}, 0.5 * pi, {}))->shape);
        QCOMPARE(quarter.low, glm::dvec3(-2.0, 0.0, 0.0));
        QCOMPARE(quarter.high, glm::dvec3(0.0, 1.0, 3.0));
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
