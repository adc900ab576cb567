// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/voxel_runs.h"
#include "tests/benchmarks/peers/cutting_peer.h"

#include <bit>
#include <cstring>
#include <vector>

namespace burin::benchmarks {

namespace {

/// A block of lines, `perLine` elements each, with a copy to restart from. Lines outside the block are never cut, so
/// they need no memory here; the distance between neighbouring lines is as in the array of the whole grid.
template <class Element>
class LineArray {
public:
    LineArray(const LineBlock& block, std::size_t perLine)
        : block_(block)
        , width_(static_cast<std::size_t>(block.high.u - block.low.u + 1))
        , perLine_(perLine)
        , elements_(width_ * static_cast<std::size_t>(block.high.v - block.low.v + 1) * perLine) {}

    Element* line(LineIndex index) noexcept { return elements_.data() + place(index); }
    const Element* line(LineIndex index) const noexcept { return elements_.data() + place(index); }
    void keep() { start_ = elements_; }
    void restart() { elements_ = start_; }

private:
    std::size_t place(LineIndex index) const noexcept {
        return (static_cast<std::size_t>(index.v - block_.low.v) * width_ +
                static_cast<std::size_t>(index.u - block_.low.u)) *
               perLine_;
    }
    LineBlock block_;
    std::size_t width_, perLine_;
    std::vector<Element> elements_, start_;
};

/// Goes through the poses and passes each line's newly covered voxels to the storage.
template <class Storage>
class DeltaCutter final : public CuttingPeer {
public:
    DeltaCutter(const VolumeSnapshot& workpiece, const LineBlock& block, const EndMill& tool)
        : grid_(workpiece.grid()), tool_(tool, grid_), storage_(workpiece, block) {}

    void restart() override {
        storage_.restart();
        fresh_ = true;
    }
    void cut(const glm::dvec3& from, const glm::dvec3& to, VoxelCounts& removed) override {
        forEachPose(from, to, [&](const glm::dvec3& tip, const glm::dvec3& before) {
            tool_.forEachLine(tip, [&](LineIndex line, VoxelSpan span) {
                const VoxelSpan known = fresh_ ? VoxelSpan{} : tool_.at(before, line);
                forEachNew(span, known, [&](VoxelSpan part) { storage_.clear(line, part, removed); });
            });
            fresh_ = false;
        });
    }
    PropertyIndex at(VoxelIndex voxel) const override { return storage_.at(grid_.lineOf(voxel), voxel.k); }

private:
    Grid grid_;
    VoxelTool tool_;
    Storage storage_;
    bool fresh_ = true; ///< no pose has been cut yet
};

template <class Visit>
void forBlockRuns(const VolumeSnapshot& workpiece, const LineBlock& block, Visit&& visit) {
    for (std::int32_t v = block.low.v; v <= block.high.v; ++v)
        for (std::int32_t u = block.low.u; u <= block.high.u; ++u)
            forEachVoxelRun(workpiece.line({u, v}), [&](const Run& run) { visit(LineIndex{u, v}, run); });
}

class Bytes {
public:
    Bytes(const VolumeSnapshot& workpiece, const LineBlock& block)
        : array_(block, static_cast<std::size_t>(workpiece.grid().voxelsPerLine())) {
        forBlockRuns(workpiece, block, [&](LineIndex line, const Run& run) {
            std::memset(array_.line(line) + run.first, run.property,
                        static_cast<std::size_t>(run.last - run.first + 1));
        });
        array_.keep();
    }
    void restart() { array_.restart(); }
    void clear(LineIndex line, VoxelSpan part, VoxelCounts& removed) noexcept {
        PropertyIndex* const voxels = array_.line(line);
        for (std::int32_t k = part.first; k < part.end; ++k) {
            ++removed[voxels[k]]; // air has an entry too, which is never read
            voxels[k] = airProperty;
        }
    }
    PropertyIndex at(LineIndex line, std::int32_t k) const noexcept { return array_.line(line)[k]; }

private:
    LineArray<PropertyIndex> array_;
};

class Bits {
public:
    Bits(const VolumeSnapshot& workpiece, const LineBlock& block)
        : array_(block, (static_cast<std::size_t>(workpiece.grid().voxelsPerLine()) + 63) / 64) {
        forBlockRuns(workpiece, block, [&](LineIndex line, const Run& run) {
            if (run.property == airProperty) return;
            forWords({run.first, run.last + 1},
                     [&](std::size_t word, std::uint64_t mask) { array_.line(line)[word] |= mask; });
        });
        array_.keep();
    }
    void restart() { array_.restart(); }
    void clear(LineIndex line, VoxelSpan part, VoxelCounts& removed) noexcept {
        std::uint64_t* const words = array_.line(line);
        forWords(part, [&](std::size_t word, std::uint64_t mask) {
            removed[1] += static_cast<std::uint64_t>(std::popcount(words[word] & mask));
            words[word] &= ~mask;
        });
    }
    PropertyIndex at(LineIndex line, std::int32_t k) const noexcept {
        const auto place = static_cast<std::size_t>(k);
        return static_cast<PropertyIndex>(array_.line(line)[place / 64] >> (place % 64) & 1);
    }

private:
    template <class Visit>
    static void forWords(VoxelSpan part, Visit&& visit) noexcept {
        for (std::int32_t k = part.first; k < part.end;) {
            const std::int32_t first = k % 64, count = std::min(64 - first, part.end - k);
            const std::uint64_t ones = count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
            visit(static_cast<std::size_t>(k / 64), ones << first);
            k += count;
        }
    }
    LineArray<std::uint64_t> array_;
};

} // namespace

std::unique_ptr<CuttingPeer> denseByteCutter(const VolumeSnapshot& workpiece, const LineBlock& block,
                                             const EndMill& tool) {
    return std::make_unique<DeltaCutter<Bytes>>(workpiece, block, tool);
}

std::unique_ptr<CuttingPeer> denseBitCutter(const VolumeSnapshot& workpiece, const LineBlock& block,
                                            const EndMill& tool) {
    return std::make_unique<DeltaCutter<Bits>>(workpiece, block, tool);
}

} // namespace burin::benchmarks
