// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/peers/openvdb.h"
#include "tests/benchmarks/peers/openvdb_tree.h"

namespace burin::benchmarks {

namespace {

using Leaf = PropertyTree::LeafNodeType;

class OpenVdbCutter final : public CuttingPeer {
public:
    OpenVdbCutter(const VolumeSnapshot& workpiece, const EndMill& tool)
        : grid_(workpiece.grid())
        , tool_(tool, grid_)
        , start_(propertyTree(workpiece))
        , leaves_(static_cast<std::size_t>(grid_.voxelsPerLine()) / 8) {}

    void restart() override {
        access_.reset();
        tree_ = std::make_shared<PropertyTree>(*start_);
        access_ = std::make_unique<Access>(*tree_);
        fresh_ = true;
    }
    void cut(const glm::dvec3& from, const glm::dvec3& to, VoxelCounts& removed) override {
        forEachPose(from, to, [&](const glm::dvec3& tip, const glm::dvec3& before) {
            const auto low = [](double place) { return std::max(0, static_cast<std::int32_t>(place)) & ~7; };
            const auto high = [](double place, std::int32_t count) {
                return std::min(count, static_cast<std::int32_t>(place) + 1);
            };
            const double radius = tool_.radius();
            for (std::int32_t u = low(tip.x - radius); u < high(tip.x + radius, grid_.lineCountU()); u += 8)
                for (std::int32_t v = low(tip.y - radius); v < high(tip.y + radius, grid_.lineCountV()); v += 8)
                    cutColumn({u, v}, tip, before, removed);
            fresh_ = false;
        });
    }
    PropertyIndex at(VoxelIndex voxel) const override {
        return static_cast<PropertyIndex>(tree_->getValue({voxel.i, voxel.j, voxel.k}));
    }

private:
    using Access = openvdb::tree::ValueAccessor<PropertyTree>;

    void cutColumn(LineIndex low, const glm::dvec3& tip, const glm::dvec3& before, VoxelCounts& removed) {
        known_.clear();
        for (std::int32_t u = low.u; u < low.u + 8; ++u)
            for (std::int32_t v = low.v; v < low.v + 8; ++v) {
                const LineIndex line{u, v};
                const VoxelSpan reached = fresh_ ? VoxelSpan{} : tool_.at(before, line);
                forEachNew(tool_.at(tip, line), reached, [&](VoxelSpan part) { clear(line, part, removed); });
            }
        for (const std::size_t leaf : known_) leaves_[leaf] = {};
    }
    void clear(LineIndex line, VoxelSpan part, VoxelCounts& removed) {
        for (std::int32_t k = part.first; k < part.end;) {
            const std::int32_t first = k & 7, end = std::min(8, first + part.end - k);
            if (Leaf* const leaf = leafAt(line, k)) {
                std::int8_t* const voxels = leaf->buffer().data() + ((line.u & 7) << 6 | (line.v & 7) << 3);
                for (std::int32_t i = first; i < end; ++i) {
                    ++removed[static_cast<PropertyIndex>(voxels[i])];
                    voxels[i] = 0;
                }
                const std::uint64_t ones = ((std::uint64_t{1} << (end - first)) - 1) << first;
                leaf->getValueMask().getWord<std::uint64_t>(static_cast<openvdb::Index>(line.u & 7)) &=
                    ~(ones << ((line.v & 7) << 3));
            }
            k += end - first;
        }
    }
    /// Null where there is only air. Looked up once per column.
    Leaf* leafAt(LineIndex line, std::int32_t k) {
        const auto place = static_cast<std::size_t>(k) / 8;
        Known& known = leaves_[place];
        if (known.asked) return known.leaf;
        const openvdb::Coord coordinate(line.u, line.v, k);
        known.leaf = access_->probeLeaf(coordinate);
        if (known.leaf == nullptr && access_->getValue(coordinate) != 0) known.leaf = access_->touchLeaf(coordinate);
        known.asked = true;
        known_.push_back(place);
        return known.leaf;
    }

    struct Known {
        bool asked = false;
        Leaf* leaf = nullptr;
    };
    Grid grid_;
    VoxelTool tool_;
    PropertyTree::Ptr start_, tree_;
    std::unique_ptr<Access> access_;
    std::vector<Known> leaves_; ///< of the column that is being cut
    std::vector<std::size_t> known_;
    bool fresh_ = true; ///< no pose has been cut yet
};

} // namespace

std::unique_ptr<CuttingPeer> openVdbCutter(const VolumeSnapshot& workpiece, const EndMill& tool) {
    return std::make_unique<OpenVdbCutter>(workpiece, tool);
}

} // namespace burin::benchmarks
