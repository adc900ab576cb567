// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/boundary.h"

#include "core/base/parallel.h"
#include "core/volume/stretches.h"

#include <utility>

namespace burin {

namespace {

/// Finds the boundary of one line after the other; keeps its working memory between them.
class BoundaryFinder {
public:
    explicit BoundaryFinder(const VolumeSnapshot& volume) : volume_(volume) {}

    /// Calls visit(VoxelStretch) for each boundary stretch.
    template <class Visit>
    void onLine(LineIndex line, Visit&& visit) {
        materialVoxels(volume_.line(line), material_);
        if (material_.empty()) return;
        findInner(line);
        auto inner = inner_.begin();
        for (const Stretch& run : material_) {
            std::int64_t from = run.from;
            for (; inner != inner_.end() && inner->from < run.to; ++inner) {
                emit(from, inner->from, visit);
                from = inner->to;
            }
            emit(from, run.to, visit);
        }
    }

private:
    template <class Visit>
    static void emit(std::int64_t from, std::int64_t to, Visit& visit) {
        if (from < to) visit(VoxelStretch{static_cast<std::int32_t>(from), static_cast<std::int32_t>(to - 1)});
    }

    /// A voxel is not on the boundary where all nine lines around it are full from the voxel before to the one after:
    /// the common part of their runs, each shorter by one voxel at both ends.
    void findInner(LineIndex line) {
        inner_.clear();
        for (const Stretch& run : material_)
            if (run.from + 1 < run.to - 1) inner_.push_back({run.from + 1, run.to - 1});
        for (std::int32_t dv = -1; dv <= 1; ++dv)
            for (std::int32_t du = -1; du <= 1 && !inner_.empty(); ++du) {
                if (du == 0 && dv == 0) continue;
                const LineIndex neighbour{line.u + du, line.v + dv};
                if (volume_.grid().contains(neighbour))
                    materialVoxels(volume_.line(neighbour), neighbour_);
                else
                    neighbour_.clear();
                keepCommon();
            }
    }

    void keepCommon() {
        common_.clear();
        std::size_t i = 0;
        for (const Stretch& run : neighbour_) {
            const Stretch shorter{run.from + 1, run.to - 1};
            while (i < inner_.size() && inner_[i].to <= shorter.from) ++i;
            for (std::size_t k = i; k < inner_.size() && inner_[k].from < shorter.to; ++k) {
                const Stretch both{std::max(inner_[k].from, shorter.from), std::min(inner_[k].to, shorter.to)};
                if (both.from < both.to) common_.push_back(both);
            }
        }
        std::swap(inner_, common_);
    }

    const VolumeSnapshot& volume_;
    std::vector<Stretch> material_, neighbour_, inner_, common_;
};

} // namespace

std::vector<VoxelStretch> boundaryOfLine(const VolumeSnapshot& volume, LineIndex line) {
    std::vector<VoxelStretch> found;
    BoundaryFinder(volume).onLine(line, [&](VoxelStretch stretch) { found.push_back(stretch); });
    return found;
}

std::vector<VoxelIndex> boundaryVoxels(const VolumeSnapshot& volume) {
    const Grid& grid = volume.grid();
    std::vector<std::vector<VoxelIndex>> rows(static_cast<std::size_t>(grid.lineCountV()));
    parallelFor(std::int32_t{0}, grid.lineCountV(), [&](std::int32_t v) {
        BoundaryFinder finder(volume);
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u)
            finder.onLine({u, v}, [&](VoxelStretch stretch) {
                for (std::int32_t along = stretch.first; along <= stretch.last; ++along)
                    rows[static_cast<std::size_t>(v)].push_back(grid.voxel({u, v}, along));
            });
    });
    std::vector<VoxelIndex> all;
    for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
    return all;
}

} // namespace burin
