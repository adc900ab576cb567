// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/voxel_runs.h"
#include "core/volume/surface/surface.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/peers/flying_edges.h"
#include "tests/benchmarks/scenes/cutting_scene.h"

#include <cstdlib>

namespace burin::benchmarks {

namespace {

/// The bricks of a tile, from the low end on, through which its surface passes: those whose corner voxels'
/// neighbourhood, one voxel wider than the brick, contains both material and air.
std::vector<Brick> mixedBricks(const VolumeSnapshot& volume, SurfaceTile tile) {
    const Grid& grid = volume.grid();
    std::vector<std::uint8_t> air(static_cast<std::size_t>(grid.voxelsPerLine() / flyingBrickSide)), material = air;
    const auto mark = [&](std::vector<std::uint8_t>& marks, std::int32_t first, std::int32_t last) {
        const std::int32_t low = std::max(0, (first - 1) / flyingBrickSide);
        const std::int32_t high = std::min(static_cast<std::int32_t>(marks.size()) - 1, (last + 1) / flyingBrickSide);
        for (std::int32_t i = low; i <= high; ++i) marks[static_cast<std::size_t>(i)] = 1;
    };
    for (std::int32_t v = tile.v * flyingBrickSide - 1; v <= (tile.v + 1) * flyingBrickSide; ++v)
        for (std::int32_t u = tile.u * flyingBrickSide - 1; u <= (tile.u + 1) * flyingBrickSide; ++u) {
            if (!grid.contains(LineIndex{u, v})) continue;
            forEachVoxelRun(volume.line({u, v}), [&](const Run& run) {
                mark(run.property == airProperty ? air : material, run.first, run.last);
            });
        }
    std::vector<Brick> bricks;
    for (std::size_t i = 0; i < air.size(); ++i)
        if (air[i] != 0 && material[i] != 0)
            bricks.push_back(
                {tile.u * flyingBrickSide, tile.v * flyingBrickSide, static_cast<std::int32_t>(i) * flyingBrickSide});
    return bricks;
}

struct Peer {
    double expanding = 0.0, meshing = 0.0; ///< µs, median over bricks
    double total() const { return expanding + meshing; }
};

Peer flyingEdges(Session& session, const VolumeSnapshot& volume, const std::vector<Brick>& bricks,
                 FlyingEdges::Kind kind) {
    FlyingEdges filter(kind);
    const ReplayRule rule{4, 6, 0.5};
    Peer peer;
    std::int64_t triangles = 0;
    // Both parts in one replay: the filter works only on new samples.
    std::vector<double> expanding(bricks.size(), 1e9), meshing(bricks.size(), 1e9);
    for (int replay = 0; replay < rule.least; ++replay)
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            Session::throwIfCancelled();
            const Clock::time_point start = Clock::now();
            filter.expand(volume, bricks[i]);
            const Clock::time_point expanded = Clock::now();
            triangles += filter.mesh();
            expanding[i] = std::min(expanding[i], microseconds(expanded - start));
            meshing[i] = std::min(meshing[i], microseconds(Clock::now() - expanded));
        }
    if (triangles == 0) throw std::runtime_error("flying edges found no surface");
    const std::string name = kind == FlyingEdges::Kind::discrete ? "discrete flying edges" : "flying edges";
    peer.expanding = percentile(session.least(name + ", expanding", std::move(expanding)), 0.5);
    peer.meshing = percentile(session.least(name, std::move(meshing)), 0.5);
    return peer;
}

} // namespace

void meshFigures(Session& session) {
    if (!session.wants("mesh.")) return;
    session.stage("mesh.brick_us");
    RunVolume volume = scallopedFreeform(512);
    const VolumeSnapshot snapshot = volume.snapshot();
    const glm::ivec2 count = surfaceTiles(snapshot.grid());
    std::vector<Brick> bricks;
    for (std::int32_t v = 0; v < count.y; ++v)
        for (std::int32_t u = 0; u < count.x; ++u) {
            const std::vector<Brick> mixed = mixedBricks(snapshot, {u, v});
            bricks.insert(bricks.end(), mixed.begin(), mixed.end());
        }
    SurfaceExtractor extractor;
    SurfaceMesh mesh;
    std::size_t triangles = 0;
    const auto brickAt = [](const Brick& brick) {
        return SurfaceBrick{brick.u / flyingBrickSide, brick.v / flyingBrickSide, brick.along / flyingBrickSide};
    };
    std::vector<double> least = leastOfReplays(
        bricks.size(), [&] { triangles = 0; },
        [&](std::size_t i) {
            extractor.extractBrick(snapshot, brickAt(bricks[i]), mesh);
            triangles += mesh.triangles.size() / 3;
        });
    const double ours = percentile(session.least("mesh.brick_us", std::move(least)), 0.5);
    session.check(triangles > 0, "the surface has triangles");
    session.stage("mesh.brick_us, VTK");
    const Peer discrete = flyingEdges(session, snapshot, bricks, FlyingEdges::Kind::discrete);
    const Peer continuous = flyingEdges(session, snapshot, bricks, FlyingEdges::Kind::continuous);
    session.add(against(figure("mesh.brick_us", ours, "us", 18.0), "vtkDiscreteFlyingEdges3D with expanding the runs",
                        discrete.total(), 3.5));
    session.add(against(figure("mesh.brick_us.against_flying_edges", ours, "us"),
                        "vtkFlyingEdges3D with expanding the runs", continuous.total(), 3.5));
    session.add(against(figure("mesh.brick_us.against_filter_alone", ours, "us"), "vtkDiscreteFlyingEdges3D alone",
                        discrete.meshing));
    session.add(
        figure("mesh.triangles_per_brick", static_cast<double>(triangles) / static_cast<double>(bricks.size()), "1"));
}

} // namespace burin::benchmarks
