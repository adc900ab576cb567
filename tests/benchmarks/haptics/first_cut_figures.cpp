// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/first_cut.h"
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/benchmarks/scenes/part_meshes.h"
#include "tests/core/job/session_milling.h"

namespace burin::benchmarks {

namespace {

/// A bumpy freeform part of 100,000 triangles, 100 × 100 × 25 mm, in a stock of the given width in voxels.
MillingContext millingOf(int voxels) {
    constexpr double side = 100.0, flatness = 0.25, margin = 2.0;
    Body body;
    body.name = "bumpy";
    body.mesh = bumpyPart(side, 1e5);
    for (glm::dvec3& vertex : body.mesh.vertices) vertex.z *= flatness;
    body.box = boundingBox(body.mesh);
    Model model;
    model.bodies = {body};
    Setup setup;
    setup.stockMaterial = "machinable-wax";
    setup.stock = body.box.grown(margin);
    setup.voxel = setup.stock.size().x / voxels;
    setup.workOffset = {setup.stock.centre().x, setup.stock.centre().y, setup.stock.high.z};
    Progress progress;
    return require(makeMillingContext({std::make_shared<const Model>(model),
                                       setup,
                                       require(loadTool("ball-6"), "a tool"),
                                       "linuxcnc-mill",
                                       {},
                                       {}},
                                      progress),
                   "a benchmark's workpiece");
}

} // namespace

void firstCutFigures(Session& session) {
    for (const int voxels : {500, 1000, 2000}) {
        const std::string name = "first_cut." + std::to_string(voxels);
        if (!session.wants(name)) continue;
        session.stage(name);
        MillingContext milling = millingOf(voxels);
        Progress progress;
        const FirstCut first = require(firstCut(milling, progress), "a first cut");
        session.add(figure(name, session.least(name, first.cut - first.hand), "s", 1.0));
        session.add(figure(name + ".field", static_cast<double>(first.fieldBytes) * 1e-6, "MB", 256.0));
    }
}

} // namespace burin::benchmarks
