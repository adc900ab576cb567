// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/tick_scene.h"

#include "core/volume/voxelisation/voxelisation.h"
#include "tests/benchmarks/measure/session.h"
#include "tests/benchmarks/scenes/part_meshes.h"
#include "tests/benchmarks/scenes/tool_paths.h"
#include "tests/core/haptics/haptic_rig.h"

namespace burin::benchmarks {

namespace {

constexpr double speed = 0.2; // voxels per tick: 50 mm/s with a voxel of a quarter of a millimetre

Tool toolOf(double radius) {
    Tool tool;
    tool.id = "benchmark-ball";
    tool.cutter = cutterOf(CutterType::ball, radius, fluteLengthFromAbove);
    return tool;
}

/// Stock that fills a grid of voxels of 1 mm, with a part in it.
RunVolume stockAround(const TriangleMesh& part, const glm::ivec3& extent) {
    PropertyList properties;
    const PropertyIndex stock =
        require(properties.add(test::material("stock", Machinability::machinable)), "a benchmark's material");
    const PropertyIndex kept =
        require(properties.add(test::material("part", Machinability::isProtected)), "a benchmark's material");
    const Grid grid = require(Grid::make(glm::dvec3(0.0), 1.0, extent), "a benchmark's grid");
    RunVolume volume = require(RunVolume::make(grid, properties), "a benchmark's volume");
    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u)
            if (!volume.fillSpan({u, v}, 0, grid.lineEnd(), stock)) throw std::bad_alloc();
    Progress progress;
    (void)require(voxelise(part, kept, volume, progress), "voxelisation");
    return volume;
}

TickScene sceneOf(const TriangleMesh& part, const glm::ivec3& extent, double radius, std::vector<glm::dvec3> hand) {
    TickScene scene{stockAround(part, extent), nullptr, toolOf(radius), test::Rig::settings(), std::move(hand)};
    ToolFieldRequest request;
    request.tool = pieces(scene.tool.cutter);
    request.tips = scene.workpiece.grid().box().grown(2.0 * radius);
    request.voxel = 1.0;
    Progress progress;
    scene.field = std::make_unique<ToolField>(
        require(ToolField::build(MeshDistance(part), request, progress), "a benchmark's field"));
    return scene;
}

} // namespace

TickScene paperBlock(double radius, std::size_t ticks) {
    const glm::ivec3 extent(40, 32, 40);
    const glm::dvec3 size(extent);
    const TriangleMesh plate = shapes::box({1.0, 1.0, 0.5}, {size.x - 1.0, size.y - 1.0, 4.5});
    std::vector<glm::dvec3> hand = walk(size.x, 2.0, speed, ticks);
    for (glm::dvec3& tip : hand) tip.y *= size.y / size.x;
    return sceneOf(plate, extent, radius, std::move(hand));
}

TickScene buriedPart(std::int32_t side, double radius, std::size_t ticks) {
    constexpr double top = 0.92; // of the part, as a share of the side
    const TriangleMesh part = bumpyPart(side, 1e5);
    std::vector<glm::dvec3> hand = walkFromAbove(side, radius, speed, ticks);
    double mean = 0.0;
    for (const glm::dvec3& tip : hand) mean += tip.z / static_cast<double>(hand.size());
    for (glm::dvec3& tip : hand) tip.z += top * side - mean;
    return sceneOf(part, glm::ivec3(side), radius, std::move(hand));
}

} // namespace burin::benchmarks
