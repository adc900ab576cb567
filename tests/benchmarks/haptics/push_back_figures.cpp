// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/import.h"
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/oracles/push_back_scenes.h"
#include "tests/places.h"

namespace burin::benchmarks {

namespace {

oracles::PushBackScene partScene(const std::string& file) {
    ImportOptions options;
    options.worker = BURIN_BUILD_DIRECTORY "/burin-import";
    Progress progress;
    const Model model = require(importModel(BURIN_FIXTURES "/models/" + file, options, progress), "a part");
    TriangleMesh mesh;
    for (const Body& body : model.bodies) append(mesh, body.mesh);
    return oracles::partPushBackScene(file, mesh);
}

/// The cost of a tick's tool with a free axis, whose boundary is the part's mesh itself.
void freeAxisFigures(Session& session, const std::vector<oracles::PushBackScene>& parts) {
    constexpr double voxel = 0.5, noAllowance = 0.0; // mm
    for (const bool pressing : {true, false}) {
        const std::string name = pressing ? "proxy.free.cpu_us" : "proxy.free.hostile.cpu_us";
        session.stage(name);
        std::vector<double> times;
        for (const oracles::PushBackScene& part : parts)
            for (const Tool& tool : oracles::pushBackTools()) {
                const auto axis = oracles::PushBackAxis::freeWithoutTorque;
                BoundaryLayers layers = oracles::pushBackLayers(part, tool, axis, voxel, noAllowance);
                const oracles::PushBackRun run{.axis = axis, .voxel = voxel, .ticks = 150, .pressing = pressing};
                const oracles::PushBackFigures figures = oracles::measurePushBack(part, tool, layers, run);
                times.insert(times.end(), figures.microseconds.begin(), figures.microseconds.end());
            }
        session.add(figure(name + ".p50", percentile(times, 0.5), "us"));
        session.add(figure(name + ".p999", percentile(times, 0.999), "us"));
        session.add(figure(name + ".max", percentile(times, 1.0), "us"));
    }
}

} // namespace

void pushBackFigures(Session& session) {
    if (!session.wants("proxy.")) return;
    session.stage("proxy.gouge_voxel");
    const std::vector<oracles::PushBackScene> shapes = oracles::analyticPushBackScenes();
    const oracles::PushBackGouges onShapes = oracles::pushBackGouges(shapes, 300);
    session.stage("proxy.gouge_voxel on parts from CAD");
    const std::vector<oracles::PushBackScene> parts{partScene("pocket-test.stl"), partScene("mouse-cover.stl")};
    const oracles::PushBackGouges onParts = oracles::pushBackGouges(parts, 20);
    session.add(figure("proxy.gouge_voxel.smooth", onShapes.smooth, "voxel", oracles::smoothGougeLimit));
    session.add(
        figure("proxy.gouge_voxel.edge", std::max(onShapes.edge, onParts.edge), "voxel", oracles::edgeGougeLimit));
    session.add(figure("proxy.gouge_voxel.parts", onParts.edge, "voxel"));
    freeAxisFigures(session, parts);
}

} // namespace burin::benchmarks
