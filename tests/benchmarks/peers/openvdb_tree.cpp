// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/peers/openvdb_tree.h"

#include "core/volume/runs/voxel_runs.h"
#include "tests/benchmarks/peers/openvdb.h"

#include <openvdb/tools/Prune.h>

#include <cstring>
#include <vector>

namespace burin::benchmarks {

namespace {

constexpr std::int32_t leafSide = 8;
constexpr std::size_t linesPerLeaf = 64;

/// Eight voxels of one line in the layout of a leaf's buffer.
std::uint64_t eightVoxels(const PropertyIndex* voxels) noexcept {
    std::uint64_t word = 0;
    std::memcpy(&word, voxels, sizeof word);
    return word;
}

/// The voxels of 8 × 8 lines, u slowest, in the order of a leaf.
class LeafColumn {
public:
    explicit LeafColumn(std::int32_t length)
        : length_(static_cast<std::size_t>(length)), voxels_(linesPerLeaf * length_) {}

    void read(const VolumeSnapshot& volume, LineIndex low) {
        PropertyIndex* line = voxels_.data();
        for (std::int32_t u = 0; u < leafSide; ++u)
            for (std::int32_t v = 0; v < leafSide; ++v, line += length_)
                forEachVoxelRun(volume.line({low.u + u, low.v + v}), [&](const Run& run) {
                    std::memset(line + run.first, run.property, static_cast<std::size_t>(run.last - run.first + 1));
                });
    }
    /// Whether the leaf that starts at `k` contains a single property.
    bool isUniform(std::int32_t k) const noexcept {
        const PropertyIndex* voxels = voxels_.data() + k;
        const std::uint64_t expected = 0x0101010101010101U * *voxels;
        for (std::size_t line = 0; line < linesPerLeaf; ++line)
            if (eightVoxels(voxels + line * length_) != expected) return false;
        return true;
    }
    PropertyIndex at(std::int32_t k) const noexcept { return voxels_[static_cast<std::size_t>(k)]; }
    void write(std::int32_t k, PropertyTree::LeafNodeType& leaf) const {
        std::int8_t* const buffer = leaf.buffer().data();
        const PropertyIndex* voxels = voxels_.data() + k;
        for (std::size_t line = 0; line < linesPerLeaf; ++line)
            std::memcpy(buffer + leafSide * line, voxels + line * length_, leafSide);
        for (openvdb::Index i = 0; i < PropertyTree::LeafNodeType::SIZE; ++i) leaf.setActiveState(i, buffer[i] != 0);
    }

private:
    std::size_t length_;
    std::vector<PropertyIndex> voxels_;
};

} // namespace

bool hasOpenVdb() noexcept {
    return true;
}

PropertyTree::Ptr propertyTree(const VolumeSnapshot& volume) {
    const Grid& grid = volume.grid();
    auto tree = std::make_shared<PropertyTree>(std::int8_t{0});
    openvdb::tree::ValueAccessor<PropertyTree> access(*tree);
    LeafColumn column(grid.voxelsPerLine());
    for (std::int32_t u = 0; u < grid.lineCountU(); u += leafSide)
        for (std::int32_t v = 0; v < grid.lineCountV(); v += leafSide) {
            column.read(volume, {u, v});
            for (std::int32_t k = 0; k < grid.voxelsPerLine(); k += leafSide) {
                const openvdb::Coord place(u, v, k);
                if (!column.isUniform(k))
                    column.write(k, *access.touchLeaf(place));
                else if (column.at(k) != airProperty)
                    access.addTile(1, place, static_cast<std::int8_t>(column.at(k)), true);
            }
        }
    openvdb::tools::prune(*tree);
    return tree;
}

std::optional<std::uint64_t> openVdbBytes(const VolumeSnapshot& volume) {
    return propertyTree(volume)->memUsage();
}

} // namespace burin::benchmarks
