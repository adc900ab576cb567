// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/import.h"
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/oracles/push_back_scenes.h"

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
}

} // namespace burin::benchmarks
