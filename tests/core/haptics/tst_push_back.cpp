// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/mesh_boundary.h"
#include "core/haptics/boundary/proxy.h"
#include "tests/core/geometry/shapes.h"
#include "tests/oracles/push_back_scenes.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_push_back {

using namespace burin::oracles;

namespace {

constexpr double voxel = 0.5;
const glm::dvec3 upright(0.0, 0.0, 1.0);

glm::dvec3 tilted(double angle) {
    return {std::sin(angle), 0.0, std::cos(angle)};
}

double tilt(const glm::dvec3& axis) {
    return std::atan2(axis.x, axis.z);
}

BoundaryLayers around(const TriangleMesh& mesh, const Tool& tool) {
    return BoundaryLayers(
        std::make_unique<MeshBoundary>(std::make_shared<const MeshDistance>(mesh), pieces(tool.cutter), voxel));
}

const Tool& toolOf(const std::vector<Tool>& tools, const char* id) {
    return *std::find_if(tools.begin(), tools.end(), [&](const Tool& tool) { return tool.id == id; });
}

ProxyStride without(double turn) {
    ProxyStride stride;
    stride.travel = 6.0 * voxel;
    stride.turn = turn;
    stride.yields = ProxyStride::Yields::tip;
    stride.room = 2.0 * voxel;
    return stride;
}

ProxyStride withTorque(double turnLength) {
    ProxyStride stride = without(0.025);
    stride.yields = ProxyStride::Yields::both;
    stride.turnLength = turnLength;
    return stride;
}

ProxyStep settle(const Proxy& proxy, ToolPose pose, const ToolPose& goal, const ProxyStride& stride, int ticks = 200) {
    ProxyStep step;
    for (int tick = 0; tick < ticks; ++tick) {
        step = proxy.advance(pose, goal, stride);
        pose = step.pose;
    }
    return step;
}

QString text(const std::string& name, double figure) {
    return QString::fromStdString(name) + " " + QString::number(figure);
}

} // namespace

class TestPushBack : public QObject {
    Q_OBJECT
    std::vector<PushBackScene> scenes_ = analyticPushBackScenes();
    std::vector<Tool> tools_ = pushBackTools();
    int touching_ = 0, ticks_ = 0;

    void press(const PushBackScene& scene, const Tool& tool, BoundaryLayers& layers, PushBackRun run) {
        const double limit = (scene.smooth ? 0.05 : 0.5) * run.voxel;
        for (const bool pressing : {true, false}) {
            run.pressing = pressing;
            const PushBackFigures figures = measurePushBack(scene, tool, layers, run);
            const std::string name = scene.name + " " + tool.id + " " + nameOf(run.axis);
            QVERIFY2(figures.gouge <= limit, qPrintable(text(name, figures.gouge)));
            QVERIFY2(figures.gougeOnTheWay <= limit, qPrintable(text(name, figures.gougeOnTheWay)));
            QVERIFY2(figures.deepestPress > 1.0, qPrintable(text(name, figures.deepestPress)));
            touching_ += figures.touching;
            ticks_ += run.ticks;
        }
    }

private slots:
    void init() { touching_ = ticks_ = 0; }
    /// A run with few contacts would prove nothing.
    void cleanup() { QVERIFY(4 * touching_ >= ticks_); }

    void aFreeAxisNeverEntersAnyShapeWithAnyCutter() {
        for (const PushBackScene& scene : scenes_)
            for (const Tool& tool : tools_)
                for (const PushBackAxis axis : {PushBackAxis::freeWithoutTorque, PushBackAxis::freeWithTorque}) {
                    BoundaryLayers layers = pushBackLayers(scene, tool, axis, voxel, 0.5);
                    PushBackRun run;
                    run.axis = axis;
                    run.ticks = 90;
                    press(scene, tool, layers, run);
                }
    }

    void aStandingAxisNeverEntersEither() {
        struct Case {
            std::size_t scene;
            const char* tool;
            PushBackAxis axis;
        };
        const Case cases[] = {{2, "ball-6", PushBackAxis::upright},
                              {4, "flat-6", PushBackAxis::upright},
                              {1, "taper-6", PushBackAxis::chosen},
                              {3, "bull-6", PushBackAxis::chosen}};
        for (const auto& [place, id, axis] : cases) {
            const Tool& tool = toolOf(tools_, id);
            BoundaryLayers layers = pushBackLayers(scenes_[place], tool, axis, voxel, 0.5);
            PushBackRun run;
            run.axis = axis;
            run.ticks = 400;
            press(scenes_[place], tool, layers, run);
        }
    }

    void theAllowanceIsKeptToo() {
        const Tool& tool = toolOf(tools_, "bull-6");
        for (const std::size_t place : {std::size_t{2}, std::size_t{3}}) {
            BoundaryLayers layers = pushBackLayers(scenes_[place], tool, PushBackAxis::freeWithoutTorque, voxel, 0.5);
            PushBackRun run;
            run.axis = PushBackAxis::freeWithoutTorque;
            run.allowance = 0.3;
            run.ticks = 160;
            press(scenes_[place], tool, layers, run);
        }
    }

    void noToolPassesAWallThinnerThanItself() {
        const TriangleMesh wall = shapes::box({-0.05, -300, -300}, {0.05, 300, 300});
        for (const char* id : {"ball-1", "flat-6", "taper-6"}) {
            const Tool& tool = toolOf(tools_, id);
            const std::vector<RevolvedPiece> whole = pieces(tool.cutter);
            QVERIFY(rc::check([&] {
                BoundaryLayers layers = around(wall, tool);
                const Proxy proxy(layers);
                const double side = *rc::gen::element(-1.0, 1.0);
                std::mt19937 engine(*rc::gen::arbitrary<std::uint32_t>());
                std::uniform_real_distribution<double> number(-1.0, 1.0);
                ToolPose pose{{side * 15.0, 0, 0}, upright};
                ToolPose goal = pose;
                for (int tick = 0; tick < 60; ++tick) {
                    if (tick % 6 == 0) {
                        goal.tip = pose.tip + glm::dvec3(-side * 25.0 * std::abs(number(engine)), 9.0 * number(engine),
                                                         9.0 * number(engine));
                        goal.axis = glm::normalize(glm::dvec3(number(engine), number(engine), number(engine)) + 0.01);
                    }
                    pose = proxy.advance(pose, goal, tick % 2 ? withTorque(30.0) : without(0.05)).pose;
                    for (const RevolvedPiece& piece : whole)
                        for (const double height : {piece.bottom, piece.top})
                            RC_ASSERT(side * (pose.tip + height * pose.axis).x >= 0.05);
                }
            }));
        }
    }

    void settlesInACornerAndThenDoesNotStir() {
        const PushBackScene& pocket = scenes_[4]; // walls at 5, floor at -8
        const Tool& tool = toolOf(tools_, "flat-6");
        BoundaryLayers layers = around(shapes::pocket(16.0, 14.0, 5.0, 8.0), tool);
        const Proxy proxy(layers);
        const ToolPose goal{{20, 20, -30}, upright};
        for (const ProxyStride& stride : {without(0.0), without(0.025)}) {
            const ProxyStep rest = settle(proxy, {pocket.start, upright}, goal, stride);
            QVERIFY2(glm::length(rest.pose.tip - glm::dvec3(2, 2, -8)) < 1e-3, qPrintable(text("x", rest.pose.tip.x)));
            QVERIFY(rest.onBoundary && !rest.axisHeld);
            for (int tick = 0; tick < 50; ++tick) {
                const ProxyStep step = proxy.advance(rest.pose, goal, stride);
                QCOMPARE(step.pose.tip, rest.pose.tip);
                QCOMPARE(step.pose.axis, rest.pose.axis);
            }
        }
    }

    void aPocketNarrowerThanTheToolHoldsItAtItsRim() {
        const Tool& tool = toolOf(tools_, "ball-6");
        BoundaryLayers layers = around(shapes::pocket(16.0, 14.0, 2.0, 8.0), tool);
        const ProxyStep rest =
            settle(Proxy(layers), {{0.3, -0.2, 4}, upright}, {{0, 0, -20}, upright}, without(0.0), 60);
        // The ball lies on all four edges: its centre √(3² - 2²) above them.
        QVERIFY(glm::length(rest.pose.tip - glm::dvec3(0, 0, std::sqrt(5.0) - 3.0)) < 2e-3);
    }

    void withoutTorqueTheTipMakesRoomForTheAxis() {
        const Tool& tool = toolOf(tools_, "flat-6");
        BoundaryLayers layers = around(shapes::box({-100, -100, -100}, {100, 100, 0}), tool);
        const double angle = 0.5;
        const ProxyStep rest =
            settle(Proxy(layers), {{0, 0, 2}, upright}, {{1, 0, -1.5}, tilted(angle)}, without(0.025));
        QVERIFY(!rest.axisHeld);
        QVERIFY(std::abs(tilt(rest.pose.axis) - angle) < 1e-6);
        // The tool stands on its rim, 3 mm from the axis.
        QVERIFY2(glm::length(rest.pose.tip - glm::dvec3(1, 0, 3.0 * std::sin(angle))) < 1e-3,
                 qPrintable(text("z", rest.pose.tip.z)));
    }

    void withoutTorqueAndWithoutRoomTheAxisStaysAndSaysSo() {
        // Two walls, 0.4 mm farther apart than the tool is wide, far beyond its ends.
        Tool tool = toolOf(tools_, "flat-6");
        tool.cutter.holder.clear();
        const TriangleMesh walls =
            shapes::cells({-20, -3.2, 3.2, 20}, {-90, 90}, {-90, 90}, [](int i, int, int) { return i != 1; });
        BoundaryLayers layers = around(walls, tool);
        const ProxyStep rest =
            settle(Proxy(layers), {{0, 0, 0}, upright}, {{0, 0, 0}, tilted(0.6)}, without(0.025), 100);
        QVERIFY(rest.axisHeld);
        // A rectangle of 6 mm by 30 between lines 6.4 mm apart.
        const double angle = tilt(rest.pose.axis);
        QVERIFY2(std::abs(6.0 * std::cos(angle) + 30.0 * std::sin(angle) - 6.4) < 4e-3, qPrintable(text("", angle)));
    }

    void withTorqueTheToolRestsWhereTheSpringsHoldLeastEnergy() {
        const Tool& tool = toolOf(tools_, "flat-6");
        BoundaryLayers layers = around(shapes::box({-100, -100, -100}, {100, 100, 0}), tool);
        const double pressed = -1.5, wanted = 0.5, turnLength = 8.0;
        const ProxyStep rest =
            settle(Proxy(layers), {{0, 0, 2}, upright}, {{0, 0, pressed}, tilted(wanted)}, withTorque(turnLength), 400);
        double best = 1e300, angle = 0.0;
        for (double a = 0.0; a <= wanted; a += 1e-5) {
            const double way = 3.0 * std::sin(a) - pressed, turn = turnLength * (wanted - a);
            if (way * way + turn * turn >= best) continue;
            best = way * way + turn * turn;
            angle = a;
        }
        QVERIFY2(std::abs(tilt(rest.pose.axis) - angle) < 1e-3, qPrintable(text("", tilt(rest.pose.axis) - angle)));
        QVERIFY(std::abs(rest.pose.tip.z - 3.0 * std::sin(angle)) < 3e-3);
    }

    void aTurnSweepsNothingUnseen() {
        // A wall where the holder would pass: the tip may stay, the axis may not pass.
        const Tool& tool = toolOf(tools_, "ball-1");
        BoundaryLayers layers = around(shapes::box({19.9, -50, 20}, {20.0, 50, 60}), tool);
        const Proxy proxy(layers);
        ToolPose pose{{0, 0, 0}, upright};
        for (int tick = 0; tick < 200; ++tick) {
            pose = proxy.advance(pose, {{0, 0, 0}, tilted(1.5)}, tick % 2 ? withTorque(30.0) : without(0.2)).pose;
            QVERIFY(tilt(pose.axis) < 0.9);
        }
    }
};

BURIN_TEST(TestPushBack, NoApplication)

} // namespace burin::tst_push_back

#include "tst_push_back.moc"
