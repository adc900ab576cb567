// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/voxelisation/voxelisation.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/peers/mesh_level_set.h"
#include "tests/benchmarks/scenes/cutting_scene.h"
#include "tests/benchmarks/scenes/part_meshes.h"

namespace burin::benchmarks {

namespace {

struct Task {
    std::string name;
    double triangles = 0.0;
    std::int32_t side = 0;
    double limit = 0.0; ///< s
};

/// @return  number of lines with an odd number of crossings
std::size_t voxeliseMesh(Session& session, const Task& task) {
    if (!session.wants(task.name)) return 0;
    session.stage(task.name);
    const TriangleMesh mesh = bumpyPart(task.side, task.triangles);
    const Grid grid = sceneGrid(task.side);
    std::optional<RunVolume> volume;
    VoxelisationReport report;
    Progress progress;
    const double spent = leastSeconds(
        5,
        [&] {
            volume.reset();
            volume = require(RunVolume::make(grid, sceneMaterials()), "a benchmark's volume");
        },
        [&] { report = require(voxelise(mesh, 1, *volume, progress), "voxelisation"); });
    const double inside = static_cast<double>(report.filledUnits) * grid.unitVolume();
    const double exact = signedVolume(mesh);
    session.check(std::abs(inside - exact) < 1e-5 * exact,
                  task.name + " fills the volume of the mesh (" + std::to_string(inside / exact) + " of it)");
    Figure entry = figure(task.name, session.least(task.name, spent), "s", task.limit);
    const std::optional<double> theirs =
        task.side <= 1024 ? meshLevelSetSeconds(session, task.side, task.triangles) : std::nullopt;
    session.add(theirs ? against(std::move(entry), "OpenVDB meshToLevelSet, half width 3", *theirs) : std::move(entry));
    return report.linesWithOddCrossings;
}

} // namespace

void voxelisationFigures(Session& session) {
    if (!session.wants("voxelise.")) return;
    const std::size_t odd = voxeliseMesh(session, {"voxelise.1m.1024", 1e6, 1024, 0.05}) +
                            voxeliseMesh(session, {"voxelise.1m.2048", 1e6, 2048, 0.1}) +
                            voxeliseMesh(session, {"voxelise.10m.2048", 1e7, 2048, 0.4});
    session.add(figure("voxelise.odd_lines", static_cast<double>(odd), "lines", 0.0));
}

} // namespace burin::benchmarks
