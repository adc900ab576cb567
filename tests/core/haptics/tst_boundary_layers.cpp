// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/allowance_follower.h"
#include "core/haptics/boundary/mesh_boundary.h"
#include "core/haptics/boundary/proxy.h"
#include "core/haptics/boundary/tool_boundaries.h"
#include "tests/core/geometry/random_shapes.h"
#include "tests/core/geometry/shapes.h"
#include "tests/oracles/push_back_scenes.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_boundary_layers {

namespace {

constexpr double voxel = 0.5;
const glm::dvec3 upright(0.0, 0.0, 1.0);

Tool bullNose() {
    return oracles::pushBackTools()[3];
}

/// A floor at z = 0 and layers over it.
struct Stage {
    explicit Stage(const std::vector<Obstacle>& obstacles, const Envelope& envelope = {})
        : layers(std::make_unique<MeshBoundary>(
              std::make_shared<const MeshDistance>(shapes::box({-200, -200, -50}, {200, 200, 0})),
              pieces(bullNose().cutter), voxel)) {
        addLayers(layers, obstacles, envelope, bullNose(), voxel);
    }
    ToolPose follow(ToolPose pose, const ToolPose& goal, int ticks = 60) {
        ProxyStride stride;
        stride.travel = 3.0;
        stride.turn = 0.025;
        stride.yields = ProxyStride::Yields::tip;
        stride.room = 1.0;
        for (int tick = 0; tick < ticks; ++tick) {
            layers.settle(pose);
            pose = Proxy(layers).advance(pose, goal, stride).pose;
        }
        return pose;
    }
    BoundaryLayers layers;
};

Obstacle box(const glm::dvec3& low, const glm::dvec3& high, bool on = true) {
    Obstacle obstacle;
    obstacle.name = "vise";
    obstacle.shape = Box{low, high};
    obstacle.on = on;
    return obstacle;
}

} // namespace

class TestBoundaryLayers : public QObject {
    Q_OBJECT
private slots:
    void aFixtureHoldsTheToolAtItsMargin() {
        Obstacle vise = box({10, -20, 0}, {30, 20, 30});
        vise.margin = 0.7;
        Stage stage({vise});
        const ToolPose rest = stage.follow({{0, 0, 5}, upright}, {{25, 0, 5}, upright});
        QVERIFY(std::abs(rest.tip.x - (10.0 - 3.0 - 0.7)) < 1e-3); // its radius is 3
    }

    void theAllowanceIsThePartsAlone() {
        Stage stage({box({10, -20, 0}, {30, 20, 30})});
        stage.layers.setAllowance(0.4);
        const ToolPose rest = stage.follow({{0, 0, 5}, upright}, {{25, 0, -5}, upright});
        QVERIFY(std::abs(rest.tip.z - 0.4) < 1e-3);
        QVERIFY(std::abs(rest.tip.x - 7.0) < 1e-3);
    }

    void aCylinderAndAMeshKeepOutAsWell() {
        Obstacle column, block;
        column.shape = CylinderShape{{0, 0, 0}, upright, 12.0, 20.0};
        block.shape = shapes::box({-40, -5, 0}, {-30, 5, 20});
        Stage stage({column, block});
        const ToolPose rest = stage.follow({{25, 1, 5}, upright}, {{2, 0, 5}, upright});
        QVERIFY2(std::abs(glm::length(glm::dvec2(rest.tip)) - 15.0) < cylinderChord + 1e-3,
                 qPrintable(QString::number(glm::length(glm::dvec2(rest.tip)))));
        const ToolPose other = stage.follow({{-25, 0, 5}, upright}, {{-35, 0, 5}, upright});
        QVERIFY(std::abs(other.tip.x + 27.0) < 1e-3);
    }

    void aLayerThatIsOffHoldsNothing() {
        Stage stage({box({10, -20, 0}, {30, 20, 30}, false)});
        const ToolPose rest = stage.follow({{0, 0, 5}, upright}, {{25, 0, 5}, upright});
        QVERIFY(glm::length(rest.tip - glm::dvec3(25, 0, 5)) < 1e-4);
    }

    void aLayerSwitchedOnAroundTheToolWaitsUntilItIsClear() {
        Stage stage({box({10, -20, 0}, {30, 20, 30}, false)});
        ToolPose pose = stage.follow({{0, 0, 5}, upright}, {{20, 0, 5}, upright});
        stage.layers.switchTo(1, true);
        // The tool stays where it is, and moves inside as if there were no obstacle.
        const ToolPose inside = stage.follow(pose, pose, 20);
        QCOMPARE(inside.tip, pose.tip);
        QCOMPARE(stage.layers.state(1), BoundaryLayers::State::waiting);
        pose = stage.follow(pose, {{22, 3, 2}, upright});
        QVERIFY(glm::length(pose.tip - glm::dvec3(22, 3, 2)) < 1e-4);
        pose = stage.follow(pose, {{0, 0, 5}, upright});
        QCOMPARE(stage.layers.state(1), BoundaryLayers::State::inForce);
        pose = stage.follow(pose, {{20, 0, 5}, upright});
        QVERIFY(std::abs(pose.tip.x - 7.0) < 1e-3);
        stage.layers.switchTo(1, false);
        pose = stage.follow(pose, {{20, 0, 5}, upright});
        QVERIFY(std::abs(pose.tip.x - 20.0) < 1e-4);
    }

    void aGrowingAllowanceTakesTheToolAlongAtItsSpeed() {
        Stage stage({});
        AllowanceFollower follower(stage.layers, 0.0);
        ToolPose pose = stage.follow({{0, 0, 5}, upright}, {{0, 0, -2}, upright});
        follower.want(0.5);
        for (int tick = 0; tick < 120; ++tick) {
            const ToolPose before = pose;
            pose = follower.advance(Proxy(stage.layers), pose, 0.001);
            QVERIFY(pose.tip.z - before.tip.z <= 4.0 * 0.005 + 1e-9);
            pose = stage.follow(pose, {{0, 0, -2}, upright}, 1);
        }
        QVERIFY(std::abs(pose.tip.z - 0.5) < 1e-3);
    }

    void noPointOfTheToolLeavesTheEnvelope() {
        Envelope envelope;
        envelope.tips = {{-20, -20, -5}, {20, 20, 40}};
        envelope.tools = {{-30, -25, -10}, {30, 25, 90}};
        Stage stage({}, envelope);
        const oracles::ToolDepth depth(pieces(bullNose().cutter), 0.25);
        const auto outside = [&](const glm::dvec3& p) {
            return -shapes::boxDistance(envelope.tools.low, envelope.tools.high, p);
        };
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> number(-1.0, 1.0);
        ToolPose pose{{0, 0, 10}, upright};
        double atFace = 1e300;
        for (int round = 0; round < 120; ++round) {
            const glm::dvec3 aside(number(engine), number(engine), 0.4 + 0.6 * std::abs(number(engine)));
            const ToolPose goal{{40 * number(engine), 40 * number(engine), 50 * number(engine)}, glm::normalize(aside)};
            for (int tick = 0; tick < 8; ++tick) {
                pose = stage.follow(pose, goal, 1);
                const double inside = depth.at(pose, outside, {});
                QVERIFY2(inside < 1e-6, qPrintable(QString::number(inside)));
                QVERIFY(envelope.tips.grown(1e-9).contains(pose.tip));
                atFace = std::min(atFace, std::abs(inside));
            }
        }
        QVERIFY(atFace < 0.01); // it was pressed against the face
    }
};

BURIN_TEST(TestBoundaryLayers, NoApplication)

} // namespace burin::tst_boundary_layers

#include "tst_boundary_layers.moc"
