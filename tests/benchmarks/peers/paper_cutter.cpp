// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/voxel_runs.h"
#include "tests/benchmarks/peers/cutting_peer.h"

#include <limits>
#include <vector>

namespace burin::benchmarks {

namespace {

using RunList = std::vector<Run>;

class PaperCutter final : public CuttingPeer {
public:
    PaperCutter(const VolumeSnapshot& workpiece, const LineBlock& block, const EndMill& tool)
        : grid_(workpiece.grid())
        , block_(block)
        , tool_(tool, grid_)
        , lines_(static_cast<std::size_t>(grid_.lineCountU()) * static_cast<std::size_t>(grid_.lineCountV()))
        , swept_(lines_.size()) {
        for (std::int32_t v = 0; v < grid_.lineCountV(); ++v)
            for (std::int32_t u = 0; u < grid_.lineCountU(); ++u) {
                RunList& list = lines_[place({u, v})];
                forEachVoxelRun(workpiece.line({u, v}), [&](const Run& run) {
                    if (run.property != airProperty) list.push_back(run);
                });
            }
        forBlock([&](std::size_t line) { start_.push_back(lines_[line]); });
    }

    void restart() override {
        std::size_t next = 0;
        forBlock([&](std::size_t line) { lines_[line] = start_[next++]; });
    }

    void cut(const glm::dvec3& from, const glm::dvec3& to, VoxelCounts& removed) override {
        touched_.clear();
        forEachPose(from, to, [&](const glm::dvec3& tip, const glm::dvec3&) {
            tool_.forEachLine(tip, [&](LineIndex line, VoxelSpan span) {
                if (!span.empty()) unite(place(line), {span.first, span.end - 1, 0});
            });
        });
        for (const std::size_t line : touched_) {
            for (const Run& run : swept_[line]) take(lines_[line], run, removed);
            swept_[line].clear();
        }
    }

    PropertyIndex at(VoxelIndex voxel) const override {
        for (const Run& run : lines_[place(grid_.lineOf(voxel))])
            if (voxel.k >= run.first && voxel.k <= run.last) return run.property;
        return airProperty;
    }

private:
    std::size_t place(LineIndex line) const noexcept {
        return static_cast<std::size_t>(line.v) * static_cast<std::size_t>(grid_.lineCountU()) +
               static_cast<std::size_t>(line.u);
    }
    template <class Visit>
    void forBlock(Visit&& visit) {
        for (std::int32_t v = block_.low.v; v <= block_.high.v; ++v)
            for (std::int32_t u = block_.low.u; u <= block_.high.u; ++u) visit(place({u, v}));
    }
    /// Union (the paper's algorithm 2): merges intersecting and adjacent runs, adds separate ones.
    void unite(std::size_t line, Run run) {
        RunList& list = swept_[line];
        if (list.empty()) touched_.push_back(line);
        auto first = list.begin();
        while (first != list.end() && first->last + 1 < run.first) ++first;
        auto behind = first;
        for (; behind != list.end() && behind->first <= run.last + 1; ++behind) {
            run.first = std::min(run.first, behind->first);
            run.last = std::max(run.last, behind->last);
        }
        if (first == behind) {
            list.insert(first, run);
        } else {
            *first = run;
            list.erase(first + 1, behind);
        }
    }
    /// Intersection with the workpiece's runs, counted, and its removal.
    static void take(RunList& list, const Run& tool, VoxelCounts& removed) {
        for (std::size_t i = 0; i < list.size() && list[i].first <= tool.last;) {
            Run& run = list[i];
            const std::int32_t low = std::max(run.first, tool.first), high = std::min(run.last, tool.last);
            if (low > high) {
                ++i;
                continue;
            }
            removed[run.property] += static_cast<std::uint64_t>(high - low + 1);
            const Run rest{high + 1, run.last, run.property};
            if (low > run.first) {
                run.last = low - 1;
                ++i;
                if (rest.first <= rest.last) list.insert(list.begin() + static_cast<std::ptrdiff_t>(i++), rest);
            } else if (rest.first <= rest.last) {
                run.first = rest.first;
                ++i;
            } else {
                list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
    }

    Grid grid_;
    LineBlock block_;
    VoxelTool tool_;
    std::vector<RunList> lines_, swept_;
    std::vector<RunList> start_; ///< of the block's lines
    std::vector<std::size_t> touched_;
};

} // namespace

std::unique_ptr<CuttingPeer> paperCutter(const VolumeSnapshot& workpiece, const LineBlock& block, const EndMill& tool) {
    return std::make_unique<PaperCutter>(workpiece, block, tool);
}

LineBlock blockOf(std::span<const glm::dvec3> tips, double radius, const Grid& grid) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    glm::dvec2 low(infinity), high(-infinity);
    for (const glm::dvec3& tip : tips) {
        low = glm::min(low, glm::dvec2(tip));
        high = glm::max(high, glm::dvec2(tip));
    }
    const auto clamped = [](double place, std::int32_t count) {
        return static_cast<std::int32_t>(std::clamp(std::floor(place), 0.0, static_cast<double>(count) - 1.0));
    };
    return {{clamped(low.x - radius - 1.0, grid.lineCountU()), clamped(low.y - radius - 1.0, grid.lineCountV())},
            {clamped(high.x + radius + 1.0, grid.lineCountU()), clamped(high.y + radius + 1.0, grid.lineCountV())}};
}

} // namespace burin::benchmarks
