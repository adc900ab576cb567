// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/stock_sharpening.h"

#include <algorithm>
#include <array>
#include <utility>

namespace burin {

namespace {

/// How much a surface made of cells may bevel the edges and corners of a solid, cells.
constexpr double reachOfBevels = 1.25;
/// Points that are nearer to the shape than this are not moved, mm.
constexpr float nearEnough = 1e-4F;

/// The memory needed for the untouched stock: of its bricks of 8 × 8 scanlines all inner ones are identical, those on
/// its sides may differ.
std::size_t reserveFor(const Grid& grid) {
    constexpr std::size_t bytesPerBrick = 2048, bricksInside = 64, linesPerBrick = 8;
    const auto aroundIt = 2 * static_cast<std::size_t>(grid.lineCountU() + grid.lineCountV()) / linesPerBrick;
    return bytesPerBrick * (bricksInside + aroundIt);
}

/// Splits quadrilaterals (two triangles each) along the diagonal that keeps both triangles in faces of the stock.
void splitAlongEdges(const KnownFaces& faces, SurfaceMesh& mesh) {
    const auto offFaces = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const std::array corners{mesh.points[a], mesh.points[b], mesh.points[c]};
        const bool empty = corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
        return !empty && faces.faceOf(corners) == KnownFaces::none ? 1 : 0;
    };
    for (std::size_t corner = 0; corner + 5 < mesh.triangles.size(); corner += 6) {
        std::uint32_t* const at = &mesh.triangles[corner];
        const std::uint32_t a = at[0], b = at[1], c = at[2], d = at[5];
        const int asIs = offFaces(a, b, c) + offFaces(a, c, d);
        if (asIs == 0 || offFaces(b, c, d) + offFaces(b, d, a) >= asIs) continue;
        const std::array turned{b, c, d, b, d, a};
        std::copy(turned.begin(), turned.end(), at);
    }
}

/// These occur where two rows of points have met in an edge.
void dropTrianglesWithoutArea(SurfaceMesh& mesh) {
    std::size_t kept = 0;
    for (std::size_t corner = 0; corner < mesh.triangles.size(); corner += 3) {
        const std::uint32_t a = mesh.triangles[corner], b = mesh.triangles[corner + 1], c = mesh.triangles[corner + 2];
        if (mesh.points[a] == mesh.points[b] || mesh.points[b] == mesh.points[c] || mesh.points[c] == mesh.points[a])
            continue;
        for (const std::uint32_t point : {a, b, c}) mesh.triangles[kept++] = point;
    }
    mesh.triangles.resize(kept);
}

} // namespace

std::shared_ptr<const StockShape> stockOf(const VolumeSnapshot& workpiece) {
    const Grid& grid = workpiece.grid();
    glm::ivec2 low(grid.lineCountU(), grid.lineCountV()), high(-1);
    RunPosition from = grid.lineEnd(), to = 0;
    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
            RunPosition begin = 0;
            for (const Segment segment : workpiece.line({u, v})) {
                if (segment.property() != airProperty) {
                    low = glm::min(low, glm::ivec2(u, v));
                    high = glm::max(high, glm::ivec2(u, v));
                    from = std::min(from, begin);
                    to = std::max(to, segment.end());
                }
                begin = segment.end();
            }
        }
    if (from >= to) return nullptr;
    Box box;
    for (const auto& [lines, add] : {std::pair(low, 0), std::pair(high, 1)}) {
        glm::dvec3 corner(0.0);
        corner[grid.axisOfU()] = grid.low()[grid.axisOfU()] + (lines.x + add) * grid.edge();
        corner[grid.axisOfV()] = grid.low()[grid.axisOfV()] + (lines.y + add) * grid.edge();
        corner[grid.axisOfRuns()] = grid.toMillimetres(add == 0 ? from : to);
        box.include(corner);
    }
    return std::make_shared<BoxStock>(box);
}

StockSharpening::StockSharpening(std::shared_ptr<const StockShape> stock, const Grid& grid) {
    PropertyList properties;
    const Result<PropertyIndex> material =
        properties.add(Property{.id = "stock", .name = {}, .base = {}, .values = {}});
    Result<RunVolume> volume = RunVolume::make(grid, properties, reserveFor(grid));
    if (!stock || !material || !volume || !stock->fill(*volume, *material)) return; // the bevelled edges are acceptable
    stock_ = std::move(stock);
    volume_ = *std::move(volume);
    untouched_ = volume_->snapshot();
}

void StockSharpening::sharpen(SurfaceTile tile, int level, SurfaceMesh& mesh) {
    if (!stock_) return;
    const Moves& moves = movesOf(tile, level);
    if (moves.empty()) return;
    for (glm::vec3& point : mesh.points)
        if (const auto move = moves.find(point); move != moves.end()) point = move->second;
    splitAlongEdges(*stock_, mesh);
    dropTrianglesWithoutArea(mesh);
}

const StockSharpening::Moves& StockSharpening::movesOf(SurfaceTile tile, int level) {
    const auto [entry, isNew] = moves_.try_emplace({level, tile.u, tile.v});
    if (!isNew) return entry->second;
    extractor_.extract(untouched_, tile, {level, 0.0}, mesh_);
    const Grid& grid = untouched_.grid();
    const double cell = grid.edge() * (1 << level);
    const SharpeningRaster raster{static_cast<float>(reachOfBevels * cell), glm::vec3(grid.low()),
                                  static_cast<float>(cell)};
    for (const glm::vec3& point : mesh_.points) {
        const glm::vec3 sharp = stock_->sharpened(point, raster);
        if (glm::length(sharp - point) > nearEnough) entry->second.emplace(point, sharp);
    }
    return entry->second;
}

} // namespace burin
