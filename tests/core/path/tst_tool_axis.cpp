// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/evaluate.h"
#include "tests/core/path/path_fixture.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_tool_axis {

using namespace burin::test;

namespace {

constexpr double degree = pi / 180.0;
constexpr double exact = 1e-6;
constexpr double speed = 50.0; // mm/s; 0.05 mm a tick

/// A floor below z = 0, far wider than the path.
const MeshDistance& floorPart() {
    static const MeshDistance floor{boxMesh({{-100, -100, -50}, {100, 100, 0}})};
    return floor;
}

PathContext tilting(const Tool& tool, const MeshDistance& part = floorPart()) {
    PathContext context = contextOf(part, tool, {{-100, -100, -50}, {100, 100, 5}});
    context.machine.name = "Mill";
    RotaryAxis c, a;
    c.axis = Axis::c;
    a.axis = Axis::a;
    context.machine.rotaryAxes = {c, a};
    return context;
}

Tool shortTool(Tool tool) {
    tool.cutter.holder.clear();
    return tool;
}

/// A stroke along X from 0 to 40 mm at a height, 0.05 mm a tick.
Result<EvaluatedPath> tilted(const ToolAxis& axis, const PathContext& context, double height = 0.0) {
    return run({takeOf(along({{0, 0, height}, {40, 0, height}}, speed))}, {{Simplify{}}, {Link{}}, {SetFeed{}}, {axis}},
               context);
}

/// The pose at a position along X of the cut.
ToolPose poseAt(const EvaluatedPath& path, double x) {
    for (std::size_t i = 1; i < path.path.points.size(); ++i) {
        const PathPoint &from = path.path.points[i - 1], &to = path.path.points[i];
        if (to.kind != MoveKind::cut || from.pose.tip.x > x || to.pose.tip.x < x) continue;
        const double share = (x - from.pose.tip.x) / (to.pose.tip.x - from.pose.tip.x);
        return {glm::mix(from.pose.tip, to.pose.tip, share),
                glm::normalize(glm::mix(from.pose.axis, to.pose.axis, share))};
    }
    return {glm::dvec3(1e9)};
}

} // namespace

/// Axis of a part of a path: poses by closed formulas, for motion along +X over a floor, whose normal is +Z.
class TestToolAxis : public QObject {
    Q_OBJECT
private slots:
    void leadAndTiltAreCountedFromTheMotion_data() {
        QTest::addColumn<double>("lead");
        QTest::addColumn<double>("side");
        QTest::addColumn<bool>("normal");
        for (const bool normal : {false, true}) {
            QTest::addRow("lead %d", normal) << 15.0 << 0.0 << normal;
            QTest::addRow("lag %d", normal) << -10.0 << 0.0 << normal;
            QTest::addRow("left %d", normal) << 0.0 << 20.0 << normal;
            QTest::addRow("both %d", normal) << 10.0 << -25.0 << normal;
        }
    }
    /// The axis is cos t (cos l Z + sin l X) + sin t Y; a ball keeps its centre, so its tip is R (Z - axis) away.
    void leadAndTiltAreCountedFromTheMotion() {
        QFETCH(double, lead);
        QFETCH(double, side);
        QFETCH(bool, normal);
        ToolAxis axis;
        axis.from = normal ? ToolAxis::From::normal : ToolAxis::From::upright;
        axis.lead = lead * degree;
        axis.tilt = side * degree;
        const auto path = tilted(axis, tilting(shortTool(ballTool())));
        QVERIFY2(path, path ? "" : (path.error().subject + path.error().place).c_str());
        const double l = axis.lead, t = axis.tilt;
        const glm::dvec3 wanted(std::cos(t) * std::sin(l), std::sin(t), std::cos(t) * std::cos(l));
        const glm::dvec3 shift = 3.0 * (glm::dvec3(0.0, 0.0, 1.0) - wanted);
        for (const double x : {1.0, 20.0, 39.0}) {
            const ToolPose pose = poseAt(*path, x + shift.x);
            QVERIFY2(glm::distance(pose.axis, wanted) < exact, qPrintable(QString::number(pose.axis.x)));
            QVERIFY(glm::distance(pose.tip, glm::dvec3(x, 0.0, 0.0) + shift) < exact);
        }
    }

    /// A flat end mill that leans ahead by l rises by R sin l: the front of its edge touches the floor.
    void aFlatEndMillTouchesThePlaneWithItsEdge() {
        ToolAxis axis;
        axis.lead = 12.0 * degree;
        const auto path = tilted(axis, tilting(shortTool(flatTool())));
        QVERIFY(path);
        QVERIFY(std::abs(poseAt(*path, 20.0).tip.z - 3.0 * std::sin(axis.lead)) < exact);
    }

    /// Inside the stroke the axis turns evenly over the blend, by the angle from upright; a second tool that keeps its
    /// tip high above the floor turns about it.
    void theAxisTurnsEvenlyAtTheBorders() {
        ToolAxis axis;
        axis.interval = {1, 200, 600}; // 10 to 30 mm
        axis.from = ToolAxis::From::fixed;
        axis.inclination = 30.0 * degree;
        axis.azimuth = 90.0 * degree;
        axis.blend = 6.0;
        axis.keep = ToolAxis::Keep::tip;
        const auto path = tilted(axis, tilting(ballTool()), 30.0);
        QVERIFY2(path, path ? "" : (path.error().subject + path.error().place).c_str());
        for (const auto& [x, angle] : {std::pair{5.0, 0.0},
                                       {9.9, 0.0},
                                       {12.0, 10.0},
                                       {14.5, 22.5},
                                       {16.0, 30.0},
                                       {24.0, 30.0},
                                       {27.0, 15.0},
                                       {30.1, 0.0},
                                       {39.0, 0.0}}) {
            const ToolPose pose = poseAt(*path, x);
            QVERIFY2(glm::distance(pose.axis, {0.0, std::sin(angle * degree), std::cos(angle * degree)}) < 2e-5,
                     qPrintable(QString("%1: %2").arg(x).arg(pose.axis.y)));
            QVERIFY(glm::distance(pose.tip, {x, 0.0, 30.0}) < exact);
        }
        double before = 0.0;
        for (const PathPoint& point : path->path.points) {
            const double now = std::asin(point.pose.axis.y);
            QVERIFY(std::abs(now - before) < 1.0001 * degree);
            before = now;
        }
    }

    /// Where there is no room for two blends, each takes half of the part: the axis is reached in its middle.
    void aShortPartTurnsOverItsHalves() {
        ToolAxis axis;
        axis.interval = {1, 360, 440}; // 18 to 22 mm
        axis.from = ToolAxis::From::fixed;
        axis.inclination = 20.0 * degree;
        axis.blend = 6.0;
        axis.keep = ToolAxis::Keep::tip;
        const auto path = tilted(axis, tilting(ballTool()), 30.0);
        QVERIFY(path);
        for (const auto& [x, angle] : {std::pair{17.9, 0.0}, {19.0, 10.0}, {20.0, 20.0}, {21.5, 5.0}, {22.1, 0.0}}) {
            const ToolPose pose = poseAt(*path, x);
            QVERIFY2(glm::distance(pose.axis, {std::sin(angle * degree), 0.0, std::cos(angle * degree)}) < 2e-5,
                     qPrintable(QString("%1: %2").arg(x).arg(pose.axis.x)));
        }
    }

    /// At ends of strokes the axis turns in the rapids at the height across: plunge and retract are made tilted.
    void atEndsOfStrokesItTurnsInTheRapids() {
        ToolAxis axis;
        axis.tilt = 20.0 * degree;
        const auto path = tilted(axis, tilting(shortTool(ballTool())));
        QVERIFY(path);
        std::size_t plunges = 0;
        for (std::size_t i = 1; i < path->path.points.size(); ++i) {
            const PathPoint &from = path->path.points[i - 1], &to = path->path.points[i];
            if (to.kind == MoveKind::rapid) continue;
            ++plunges;
            QVERIFY(glm::distance(from.pose.axis, to.pose.axis) < exact);
        }
        QVERIFY(plunges >= 2);
        axis.ends = ToolAxis::Ends::blend;
        const auto blended = tilted(axis, tilting(shortTool(ballTool())));
        QVERIFY(blended);
        for (const PathPoint& point : blended->path.points)
            if (point.kind == MoveKind::rapid) QVERIFY(glm::distance(point.pose.axis, {0.0, 0.0, 1.0}) < exact);
    }

    /// On a circle, lead follows the tangent: the axis has a constant angle to it.
    void leadFollowsACurve() {
        std::vector<glm::dvec3> circle;
        for (int i = 0; i <= 360; ++i)
            circle.push_back({20.0 * std::cos(i * degree), 20.0 * std::sin(i * degree), 0.0});
        ToolAxis axis;
        axis.lead = 15.0 * degree;
        axis.blend = 2.0;
        const auto path =
            run({takeOf(along(circle, speed))}, {{Simplify{}}, {FitArcs{}}, {Link{}}, {SetFeed{}}, {axis}},
                tilting(shortTool(ballTool())));
        QVERIFY2(path, path ? "" : (path.error().subject + path.error().place).c_str());
        int looked = 0;
        for (const PathPoint& point : path->path.points) {
            if (point.kind != MoveKind::cut) continue;
            QVERIFY(!point.arc);
            const glm::dvec3 centre = point.pose.tip + 3.0 * point.pose.axis;
            const double angle = std::atan2(centre.y, centre.x);
            if (std::abs(std::remainder(angle, 2.0 * pi)) < 10.0 * degree) continue; // near the ends
            const glm::dvec3 tangent(-std::sin(angle), std::cos(angle), 0.0);
            QVERIFY2(std::abs(glm::dot(point.pose.axis, tangent) - std::sin(axis.lead)) < 0.01,
                     qPrintable(QString::number(glm::dot(point.pose.axis, tangent))));
            QVERIFY(std::abs(std::hypot(centre.x, centre.y) - 20.0) < 0.02 && std::abs(centre.z - 3.0) < 0.001);
            ++looked;
        }
        QVERIFY(looked > 100);
    }

    /// A part beside the stroke: leaning away from the wall is made, by brute force at no place in the part; leaning
    /// into it is refused, as is a tip that stays while a ball beside the wall tilts.
    void noPoseEntersThePart() {
        const MeshDistance walled{[] {
            TriangleMesh mesh = boxMesh({{-100, -100, -50}, {100, 100, 0}});
            const TriangleMesh wall = boxMesh({{-100, 3.0, -1.0}, {100, 20, 30}});
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.insert(mesh.vertices.end(), wall.vertices.begin(), wall.vertices.end());
            for (auto triangle : wall.triangles) {
                for (auto& corner : triangle) corner += first;
                mesh.triangles.push_back(triangle);
            }
            return mesh;
        }()};
        const PathContext context = tilting(shortTool(ballTool()), walled);
        ToolAxis axis;
        axis.tilt = -20.0 * degree; // to the right of +X: away from the wall
        const auto away = tilted(axis, context);
        QVERIFY2(away, away ? "" : (away.error().subject + away.error().place).c_str());
        const std::vector<RevolvedPiece> tool = pieces(context.tool.cutter);
        for (std::size_t i = 1; i < away->path.points.size(); ++i) {
            const ToolPose &from = away->path.points[i - 1].pose, &to = away->path.points[i].pose;
            for (int k = 0; k <= 20; ++k) {
                const ToolPose pose{glm::mix(from.tip, to.tip, k / 20.0),
                                    glm::normalize(glm::mix(from.axis, to.axis, k / 20.0))};
                QVERIFY(walled.clearance(tool, pose, 5.0).clearance > -0.005);
            }
        }
        axis.tilt = 20.0 * degree;
        const auto into = tilted(axis, context);
        QCOMPARE(into.error().code, ErrorCode::checkFailed);
        axis.tilt = -20.0 * degree;
        axis.keep = ToolAxis::Keep::tip;
        QCOMPARE(tilted(axis, context).error().code, ErrorCode::checkFailed);
    }

    void aFixtureIsKeptClear() {
        PathContext context = tilting(shortTool(ballTool()));
        const auto column = std::make_shared<const MeshDistance>(boxMesh({{15, 8, 10}, {25, 12, 60}}));
        context.obstacles = {{column, 1.0, true}};
        ToolAxis axis;
        axis.tilt = 25.0 * degree;
        QCOMPARE(tilted(axis, context).error().code, ErrorCode::checkFailed);
        axis.tilt = -25.0 * degree;
        QVERIFY(tilted(axis, context));
    }

    void machinesToolsAndOrderAreChecked() {
        ToolAxis axis;
        axis.lead = 10.0 * degree;
        PathContext upright = tilting(ballTool());
        upright.machine.rotaryAxes.clear();
        QCOMPARE(tilted(axis, upright).error().code, ErrorCode::notSupported);
        PathContext narrow = tilting(ballTool());
        narrow.machine.rotaryAxes[1].low = -5.0;
        narrow.machine.rotaryAxes[1].high = 5.0;
        QCOMPARE(tilted(axis, narrow, 60.0).error().code, ErrorCode::programLimit);
        axis.from = ToolAxis::From::program;
        QCOMPARE(tilted(axis, tilting(ballTool())).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(
            run({takeOf(along({{0, 0, 0}, {9, 0, 0}}, speed))}, {{Link{}}, {axis}, {SetFeed{}}}, upright).error().code,
            ErrorCode::editMisplaced);
        axis = ToolAxis{}; // tilts nothing: any machine
        QVERIFY(tilted(axis, upright));
    }
};

BURIN_TEST(TestToolAxis, NoApplication)

} // namespace burin::tst_tool_axis

#include "tst_tool_axis.moc"
