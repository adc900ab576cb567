// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/push_back_scenes.h"

#include "core/cutting/pose_steps.h"
#include "core/haptics/boundary/fixed_axis_boundary.h"
#include "core/haptics/boundary/mesh_boundary.h"
#include "core/haptics/boundary/pose_vector.h"
#include "core/haptics/boundary/proxy.h"
#include "core/haptics/boundary/turned_field.h"
#include "tests/core/geometry/shapes.h"

#include <cstdlib>
#include <ctime>
#include <random>

namespace burin::oracles {
namespace {

const glm::dvec3 upright(0.0, 0.0, 1.0);
const glm::dvec3 chosenAxis = glm::normalize(glm::dvec3(0.35, -0.2, 0.9));

std::vector<glm::dvec3> alongEdges(const glm::dvec3& low, const glm::dvec3& high) {
    std::vector<glm::dvec3> points;
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 4; ++corner) {
            glm::dvec3 from = low;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            if (corner & 1) from[u] = high[u];
            if (corner & 2) from[v] = high[v];
            const int count = static_cast<int>((high[axis] - low[axis]) / 0.05);
            for (int i = 0; i <= count; ++i) {
                glm::dvec3 point = from;
                point[axis] = low[axis] + (high[axis] - low[axis]) * i / count;
                points.push_back(point);
            }
        }
    return points;
}

PushBackScene scene(std::string name, bool smooth, const TriangleMesh& mesh, SolidDistance distance, Box region,
                    const glm::dvec3& start) {
    PushBackScene made;
    made.name = std::move(name);
    made.smooth = smooth;
    made.mesh = std::make_shared<const MeshDistance>(mesh);
    made.distance = std::move(distance);
    made.region = region;
    made.start = start;
    return made;
}

/// Distance to a block with a pocket in its top, both about the z axis.
double pocketDistance(const glm::dvec3& p, double outer, double height, double inner, double depth) {
    const double block = shapes::boxDistance({-outer, -outer, -height}, {outer, outer, 0.0}, p);
    // The pocket is continued above the block.
    const double hole = shapes::boxDistance({-inner, -inner, -depth}, {inner, inner, 1e3}, p);
    if (block > 0.0 && hole > 0.0) return block;
    if (hole <= 0.0) { // in the pocket or above it: distance to its floor and to its walls, up to their upper edge
        const double wall = inner - std::max(std::abs(p.x), std::abs(p.y));
        return std::min(p.z + depth, p.z > 0.0 ? std::hypot(wall, p.z) : wall);
    }
    return -std::min(-block, hole);
}

class Hand {
public:
    Hand(const PushBackScene& scene, const PushBackRun& run) : scene_(scene), run_(run), engine_(run.seed) {
        for (double& phase : phases_) phase = number(0.0, 6.28);
        for (double& rate : rates_) rate = number(0.5, 1.5);
        pose_ = {scene.start, upright};
        goal_ = pose_;
    }

    ToolPose next(int tick) { return run_.pressing ? pressing(0.001 * tick) : hostile(tick); }

private:
    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    double wave(std::size_t i, double time, double frequency) const {
        return std::sin(phases_[i] + 6.28 * frequency * rates_[i] * time);
    }

    /// Moves smoothly back and forth through the solid while its axis tilts back and forth.
    ToolPose pressing(double time) const {
        const glm::dvec3 half = 0.5 * scene_.region.size();
        const glm::dvec3 tip =
            scene_.region.centre() + half * glm::dvec3(wave(0, time, 0.5), wave(1, time, 0.7), wave(2, time, 0.9));
        const glm::dvec3 nod(0.8 * wave(3, time, 0.6), 0.8 * wave(4, time, 0.8), 0.0);
        return {tip, turned(upright, nod)};
    }
    /// Slams, jumps and tremor.
    ToolPose hostile(int tick) {
        if (tick % 40 == 0) {
            const glm::dvec3 size = scene_.region.size();
            goal_.tip = scene_.region.low + size * glm::dvec3(number(0, 1), number(0, 1), number(0, 1));
            goal_.axis = turned(upright, {number(-1.2, 1.2), number(-1.2, 1.2), 0.0});
        }
        const double pull = tick % 240 < 40 ? 1.0 : 0.06; // a jump now and then
        pose_.tip += pull * (goal_.tip - pose_.tip) + 0.05 * glm::dvec3(number(-1, 1), number(-1, 1), number(-1, 1));
        pose_.axis = turned(pose_.axis, pull * turnBetween(pose_.axis, goal_.axis));
        return pose_;
    }

    const PushBackScene& scene_;
    const PushBackRun& run_;
    std::mt19937 engine_;
    std::array<double, 5> phases_{}, rates_{};
    ToolPose pose_, goal_;
};

double processorMicroseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

Tool tool(CutterType type, double diameter, double corner) {
    Tool made;
    made.cutter.type = type;
    made.cutter.diameter = diameter;
    made.cutter.cornerRadius = corner;
    made.cutter.fluteLength = 3.0 * diameter;
    made.cutter.shankDiameter = diameter;
    made.cutter.stickOut = 30.0;
    made.cutter.holder = {{20.0, 25.0, 20.0}};
    return made;
}

} // namespace

std::vector<PushBackScene> analyticPushBackScenes() {
    std::vector<PushBackScene> scenes;
    // No tool reaches the edges of the plane's block.
    scenes.push_back(scene("plane", true, shapes::box({-100, -100, -100}, {100, 100, 0}),
                           [](const glm::dvec3& p) { return p.z; }, {{-15, -15, -3}, {15, 15, 1}}, {0, 0, 3}));
    scenes.push_back(scene("sphere", true, shapes::sphere(12.0, 400, 200),
                           [](const glm::dvec3& p) { return glm::length(p) - 12.0; }, {{-11, -11, -2}, {11, 11, 14}},
                           {0, 0, 14}));
    scenes.push_back(scene("torus", true, shapes::torus(14.0, 5.0, 400, 240),
                           [](const glm::dvec3& p) { return std::hypot(std::hypot(p.x, p.y) - 14.0, p.z) - 5.0; },
                           {{-17, -17, -4}, {17, 17, 5}}, {0, 0, 7}));
    const glm::dvec3 low(-8, -6, -10), high(8, 6, 0);
    scenes.push_back(scene("box", false, shapes::box(low, high),
                           [=](const glm::dvec3& p) { return shapes::boxDistance(low, high, p); },
                           {{-10, -8, -6}, {10, 8, 1}}, {0, 0, 3}));
    scenes.back().points = alongEdges(low, high);
    scenes.push_back(scene("pocket", false, shapes::pocket(16.0, 14.0, 5.0, 8.0),
                           [](const glm::dvec3& p) { return pocketDistance(p, 16.0, 14.0, 5.0, 8.0); },
                           {{-9, -9, -11}, {9, 9, 2}}, {0, 0, 3}));
    scenes.back().points = alongEdges({-16, -16, -14}, {16, 16, 0});
    const std::vector<glm::dvec3> rim = alongEdges({-5, -5, -8}, {5, 5, 0});
    for (const glm::dvec3& point : rim) // edges at the floor and between the walls are concave
        if (point.z == 0.0) scenes.back().points.push_back(point);
    return scenes;
}

PushBackScene partPushBackScene(std::string name, const TriangleMesh& mesh) {
    const Box box = boundingBox(mesh);
    const glm::dvec3 middle = box.centre();
    Box region = box.grown(1.0);
    region.low.z = middle.z;
    PushBackScene made = scene(std::move(name), false, mesh, {}, region, {middle.x, middle.y, box.high.z + 2.0});
    made.distance = [solid = made.mesh](const glm::dvec3& p) { return solid->closest(p, 15.0).signedDistance; };
    made.points = mesh.vertices;
    return made;
}

std::vector<Tool> pushBackTools() {
    std::vector<Tool> tools{tool(CutterType::ball, 6.0, 3.0), tool(CutterType::ball, 1.0, 0.5),
                            tool(CutterType::flat, 6.0, 0.0), tool(CutterType::bullNose, 6.0, 1.0),
                            tool(CutterType::taper, 6.0, 0.3)};
    tools[0].id = "ball-6";
    tools[1].id = "ball-1";
    tools[2].id = "flat-6";
    tools[3].id = "bull-6";
    tools[4].id = "taper-6";
    tools[4].cutter.tipDiameter = 2.0;
    tools[4].cutter.taperAngle = 0.15;
    return tools;
}

std::string nameOf(PushBackAxis axis) {
    switch (axis) {
    case PushBackAxis::upright:
        return "upright";
    case PushBackAxis::chosen:
        return "chosen";
    case PushBackAxis::freeWithoutTorque:
        return "free";
    default:
        return "torque";
    }
}

BoundaryLayers pushBackLayers(const PushBackScene& scene, const Tool& tool, PushBackAxis axis, double voxel,
                              double maximumAllowance) {
    std::vector<RevolvedPiece> whole = pieces(tool.cutter);
    if (axis == PushBackAxis::freeWithoutTorque || axis == PushBackAxis::freeWithTorque)
        return BoundaryLayers(std::make_unique<MeshBoundary>(scene.mesh, std::move(whole), voxel));
    Box tips = scene.region;
    tips.include(scene.start);
    const ToolFieldRequest request{std::move(whole), tips.grown(10.0), voxel, maximumAllowance};
    Progress progress;
    std::unique_ptr<const ClearanceField> field;
    if (axis == PushBackAxis::upright) {
        Result<ToolField> built = ToolField::build(*scene.mesh, request, progress);
        if (!built) std::abort(); // the scene's numbers are constants
        field = std::make_unique<ToolField>(std::move(*built));
    } else {
        Result<TurnedField> built = TurnedField::build(*scene.mesh, chosenAxis, request, progress);
        if (!built) std::abort();
        field = std::make_unique<TurnedField>(std::move(*built));
    }
    return BoundaryLayers(std::make_unique<FixedAxisBoundary>(std::move(field)));
}

PushBackFigures measurePushBack(const PushBackScene& scene, const Tool& tool, BoundaryLayers& layers,
                                const PushBackRun& run) {
    const std::vector<RevolvedPiece> whole = pieces(tool.cutter);
    const ToolDepth depth(whole, 0.25 * run.voxel);
    const auto gougeAt = [&](const ToolPose& pose) {
        if (run.allowance == 0.0) return depth.at(pose, scene.distance, scene.points);
        const auto grown = [&](const glm::dvec3& p) { return scene.distance(p) - run.allowance; };
        return depth.at(pose, grown, {});
    };
    layers.setAllowance(run.allowance);
    const Proxy proxy(layers);
    ProxyStride stride;
    const bool free = run.axis == PushBackAxis::freeWithoutTorque || run.axis == PushBackAxis::freeWithTorque;
    stride.travel = (free ? 2.2 : 6.0) * run.voxel; // as in the tool mover
    stride.turn = free ? 0.025 : 0.0;
    stride.yields = run.axis == PushBackAxis::freeWithTorque ? ProxyStride::Yields::both : ProxyStride::Yields::tip;
    stride.turnLength = 30.0;
    stride.room = 2.0 * run.voxel;
    PushBackFigures figures;
    Hand hand(scene, run);
    ToolPose pose{scene.start, run.axis == PushBackAxis::chosen ? chosenAxis : upright};
    if (!proxy.feasible(pose)) std::abort(); // the scene's start is a constant
    for (int tick = 0; tick < run.ticks; ++tick) {
        const ToolPose goal = hand.next(tick);
        const double before = processorMicroseconds();
        const ProxyStep step = proxy.advance(pose, goal, stride);
        figures.microseconds.push_back(processorMicroseconds() - before);
        figures.mostIterations = std::max(figures.mostIterations, step.iterations);
        if (step.onBoundary) ++figures.touching;
        if (step.onBoundary && step.pose.axis != pose.axis) ++figures.turning;
        figures.deepestPress = std::max(figures.deepestPress, glm::length(step.pose.tip - goal.tip));
        figures.gouge = std::max(figures.gouge, gougeAt(step.pose));
        const PoseSteps way(pose, step.pose, reachOf(whole), run.voxel);
        if (tick % 4 == 0)
            figures.gougeOnTheWay =
                std::max({figures.gougeOnTheWay, gougeAt(way.poseAt(0.5)), gougeAt(way.poseAt(0.8))});
        pose = step.pose;
    }
    return figures;
}

PushBackGouges pushBackGouges(std::span<const PushBackScene> scenes, int ticks, double voxel) {
    PushBackGouges gouges;
    double worstShare = -1.0;
    for (const PushBackScene& scene : scenes)
        for (const Tool& tool : pushBackTools())
            for (const PushBackAxis axis : {PushBackAxis::upright, PushBackAxis::chosen,
                                            PushBackAxis::freeWithoutTorque, PushBackAxis::freeWithTorque}) {
                BoundaryLayers layers = pushBackLayers(scene, tool, axis, voxel, 0.5);
                for (const bool pressing : {true, false}) {
                    PushBackRun run;
                    run.axis = axis;
                    run.voxel = voxel;
                    run.ticks = ticks;
                    run.pressing = pressing;
                    const PushBackFigures figures = measurePushBack(scene, tool, layers, run);
                    const double deepest = std::max(figures.gouge, figures.gougeOnTheWay) / voxel;
                    double& greatest = scene.smooth ? gouges.smooth : gouges.edge;
                    greatest = std::max(greatest, deepest);
                    const double share = deepest / (scene.smooth ? smoothGougeLimit : edgeGougeLimit);
                    if (share <= worstShare) continue;
                    worstShare = share;
                    gouges.worst =
                        scene.name + ", " + tool.id + ", " + nameOf(axis) + (pressing ? ", pressing" : ", at random");
                }
            }
    return gouges;
}

} // namespace burin::oracles
