// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/voxelisation.h"

#include "core/base/parallel.h"
#include "core/volume/line_crossings.h"

#include <algorithm>
#include <new>
#include <vector>

namespace burin {

namespace {

constexpr std::int32_t rowsPerSlab = 8;
constexpr std::int32_t slabsAtOnce = 16;

/// A stretch of one scanline inside the mesh.
struct InnerSpan {
    LineIndex line;
    RunPosition from = 0, to = 0;
};

/// What was found in a slab of rows.
struct Slab {
    std::vector<InnerSpan> inside;
    VoxelisationReport report;
};

/// Which triangles reach into which slab.
class SlabBins {
public:
    SlabBins(const ProjectedMesh& mesh, std::int32_t slabCount) : firsts_(static_cast<std::size_t>(slabCount) + 1) {
        const auto forEachSlab = [&](std::size_t triangle, auto&& visit) {
            const ProjectedMesh::Rows rows = mesh.rows(triangle);
            if (rows.first < rows.end)
                for (std::int32_t slab = rows.first / rowsPerSlab; slab <= (rows.end - 1) / rowsPerSlab; ++slab)
                    visit(static_cast<std::size_t>(slab));
        };
        for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
            forEachSlab(t, [&](std::size_t slab) { ++firsts_[slab + 1]; });
        for (std::size_t slab = 1; slab < firsts_.size(); ++slab) firsts_[slab] += firsts_[slab - 1];
        triangles_.resize(firsts_.back());
        std::vector<std::size_t> next(firsts_.begin(), firsts_.end() - 1);
        for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
            forEachSlab(t, [&](std::size_t slab) { triangles_[next[slab]++] = static_cast<std::uint32_t>(t); });
    }
    std::span<const std::uint32_t> in(std::int32_t slab) const {
        const auto at = static_cast<std::size_t>(slab);
        return std::span(triangles_).subspan(firsts_[at], firsts_[at + 1] - firsts_[at]);
    }

private:
    std::vector<std::size_t> firsts_;
    std::vector<std::uint32_t> triangles_;
};

/// Turns the crossings of one line into the stretches inside.
void addInside(std::span<LineCrossing> crossings, LineIndex line, RunPosition lineEnd, Slab& slab) {
    if (crossings.empty()) return;
    if (crossings.size() % 2 != 0) {
        ++slab.report.linesWithOddCrossings;
        return;
    }
    std::ranges::sort(crossings, {}, &LineCrossing::position);
    std::int32_t winding = 0;
    for (const LineCrossing crossing : crossings) winding += crossing.turn;
    const bool turned = winding != 0;
    if (turned) ++slab.report.linesWithTurnedFaces;
    const auto end = static_cast<std::int32_t>(lineEnd);
    if (crossings.front().position < 0 || crossings.back().position > end) ++slab.report.clippedLines;
    winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += turned ? (i % 2 == 0 ? 1 : -1) : crossings[i].turn;
        const auto from = static_cast<RunPosition>(std::clamp(crossings[i].position, 0, end));
        const auto to = static_cast<RunPosition>(std::clamp(crossings[i + 1].position, 0, end));
        if (winding == 0 || from == to) continue;
        slab.report.filledUnits += to - from;
        if (!slab.inside.empty() && slab.inside.back().line == line && slab.inside.back().to == from)
            slab.inside.back().to = to;
        else
            slab.inside.push_back({line, from, to});
    }
}

Slab crossSlab(const ProjectedMesh& mesh, std::span<const std::uint32_t> triangles, std::int32_t slabIndex,
               const Grid& grid) {
    const std::int32_t low = slabIndex * rowsPerSlab, high = std::min(low + rowsPerSlab, grid.lineCountV());
    const auto width = static_cast<std::size_t>(grid.lineCountU());
    struct Placed {
        std::uint32_t line;
        LineCrossing crossing;
    };
    std::vector<Placed> found;
    std::vector<std::uint32_t> firsts(width * rowsPerSlab + 1, 0);
    for (const std::uint32_t triangle : triangles) {
        const ProjectedMesh::Rows rows = mesh.rows(triangle);
        for (std::int32_t v = std::max(rows.first, low); v < std::min(rows.end, high); ++v)
            mesh.forEachCrossing(triangle, v, [&](std::int32_t u, LineCrossing crossing) {
                const auto line =
                    static_cast<std::uint32_t>(static_cast<std::size_t>(v - low) * width + static_cast<std::size_t>(u));
                ++firsts[line + 1];
                found.push_back({line, crossing});
            });
    }
    for (std::size_t line = 1; line < firsts.size(); ++line) firsts[line] += firsts[line - 1];
    std::vector<LineCrossing> ordered(found.size());
    std::vector<std::uint32_t> next(firsts.begin(), firsts.end() - 1);
    for (const Placed& placed : found) ordered[next[placed.line]++] = placed.crossing;

    Slab slab;
    slab.inside.reserve(found.size() / 2);
    for (std::size_t line = 0; line + 1 < firsts.size(); ++line)
        addInside(std::span(ordered).subspan(firsts[line], firsts[line + 1] - firsts[line]),
                  {static_cast<std::int32_t>(line % width), low + static_cast<std::int32_t>(line / width)},
                  grid.lineEnd(), slab);
    return slab;
}

void add(VoxelisationReport& sum, const VoxelisationReport& part) {
    sum.linesWithOddCrossings += part.linesWithOddCrossings;
    sum.linesWithTurnedFaces += part.linesWithTurnedFaces;
    sum.filledUnits += part.filledUnits;
    sum.clippedLines += part.clippedLines;
}

Result<VoxelisationReport> fillInside(const TriangleMesh& mesh, PropertyIndex property, RunVolume& volume,
                                      Progress& progress) {
    const Grid& grid = volume.grid();
    const Result<ProjectedMesh> projected = ProjectedMesh::make(mesh, grid);
    if (!projected) return projected.error();
    const std::int32_t slabCount = (grid.lineCountV() + rowsPerSlab - 1) / rowsPerSlab;
    const SlabBins bins(*projected, slabCount);
    VoxelisationReport report;
    // Crossings are found in parallel, a few slabs at once to bound the memory; the volume has one writer.
    for (std::int32_t first = 0; first < slabCount; first += slabsAtOnce) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "voxelisation", {}, {}};
        std::vector<Slab> slabs(static_cast<std::size_t>(std::min(slabsAtOnce, slabCount - first)));
        parallelFor(std::size_t{0}, slabs.size(), [&](std::size_t i) {
            const std::int32_t slab = first + static_cast<std::int32_t>(i);
            slabs[i] = crossSlab(*projected, bins.in(slab), slab, grid);
        });
        for (const Slab& slab : slabs) {
            for (const InnerSpan& span : slab.inside)
                if (!volume.fillSpan(span.line, span.from, span.to, property))
                    return Error{ErrorCode::volumeOutOfMemory, std::to_string(volume.reservedBytes()), {}, {}};
            add(report, slab.report);
        }
        progress.report(static_cast<double>(first + slabsAtOnce) / slabCount);
    }
    return report;
}

} // namespace

Result<VoxelisationReport> voxelise(const TriangleMesh& mesh, PropertyIndex property, RunVolume& volume,
                                    Progress& progress) {
    try {
        return fillInside(mesh, property, volume, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, "voxelisation", {}, std::to_string(mesh.triangles.size()) + " triangles"};
    }
}

} // namespace burin
