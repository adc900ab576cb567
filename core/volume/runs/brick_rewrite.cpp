// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/volume/runs/line_count.h"
#include "core/volume/runs/run_volume_impl.h"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <vector>

namespace burin {

namespace {

using LineContent = std::vector<Segment>;

struct ContentOrder {
    using is_transparent = void;
    template <class A, class B>
    bool operator()(const A& a, const B& b) const noexcept {
        return std::ranges::lexicographical_compare(a, b, {}, key, key);
    }
    static std::uint64_t key(Segment segment) noexcept {
        return std::uint64_t{segment.end()} << 8 | segment.property();
    }
};

void sum(RunAmounts& amounts, const RunAmounts& change) noexcept {
    for (std::size_t i = 0; i < amounts.units.size(); ++i) amounts.units[i] += change.units[i]; // modulo 2^64: may fall
}

} // namespace

/// New bricks are written to blocks of their own in addition to the current ones, by several threads; then one thread
/// updates the table. Rows for which the memory was insufficient are retried with the memory that the others' old
/// blocks released.
class RunVolume::Impl::BrickRewrite {
public:
    explicit BrickRewrite(Impl& volume)
        : volume_(volume)
        , columns_(static_cast<std::size_t>(volume.store_->table.tilesU))
        , fresh_(columns_ * static_cast<std::size_t>(volume.store_->table.tilesV), noBlock) {}
    BrickRewrite(const BrickRewrite&) = delete;
    BrickRewrite& operator=(const BrickRewrite&) = delete;
    ~BrickRewrite() {
        for (BlockIndex& block : fresh_) discard(block);
        for (auto& [content, block] : uniform_) {
            if (block != noBlock) --volume_.header(block).users;
            discard(block);
        }
    }

    bool run(const std::function<void(std::int32_t row, BrickSink& sink)>& describe) {
        std::vector<std::int32_t> rows(static_cast<std::size_t>(volume_.store_->table.tilesV));
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<std::int32_t>(i);
        while (!rows.empty()) {
            std::vector<RowResult> results(rows.size());
            parallelFor(std::size_t{0}, rows.size(), [&](std::size_t i) {
                Row bricks(*this, results[i]);
                describe(rows[i], bricks);
                bricks.finish();
            });
            std::vector<std::int32_t> left;
            for (std::size_t i = 0; i < rows.size(); ++i)
                if (results[i].outOfMemory || !commit(rows[i], results[i])) {
                    for (BlockIndex& block : row(rows[i])) discard(block);
                    left.push_back(rows[i]);
                }
            if (left.size() == rows.size()) return false;
            rows = std::move(left);
        }
        return true;
    }

private:
    struct RowResult {
        bool outOfMemory = false;
        RunAmounts change;
    };

    /// Collects one row of bricks on one thread.
    class Row final : public BrickSink {
    public:
        Row(BrickRewrite& all, RowResult& result) noexcept : all_(all), result_(result) {}
        void put(LineIndex low, const BrickLines& lines) override {
            assert(lines.complete() && low.u % tileSide == 0 && low.v % tileSide == 0);
            if (result_.outOfMemory) return;
            const BlockIndex present = all_.present(low);
            const Tile tile = all_.volume_.store_->tile(present);
            if (tile == lines) return;
            const BlockIndex block = all_.makeBlock(lines);
            if (block == noBlock) {
                result_.outOfMemory = true;
                return;
            }
            all_.fresh_[all_.placeOf(low)] = block;
            count(low, present, tile, lines);
        }
        void finish() noexcept { subtractReplaced(); }

    private:
        void subtractReplaced() noexcept {
            for (std::size_t i = 0; i < replaced_.units.size(); ++i)
                result_.change.units[i] -= replacedBricks_ * std::exchange(replaced_.units[i], 0);
            replacedBricks_ = 0;
        }
        void count(LineIndex low, BlockIndex present, const Tile& tile, const BrickLines& lines) noexcept {
            const Grid& grid = all_.volume_.store_->grid;
            const int width = std::min(tileSide, grid.lineCountU() - low.u);
            const int height = std::min(tileSide, grid.lineCountV() - low.v);
            const auto eachLine = [&](auto&& visit) {
                for (int v = 0; v < height; ++v)
                    for (int u = 0; u < width; ++u) visit(v * tileSide + u);
            };
            if (width == tileSide && height == tileSide)
                addLines(lines.segments(), lines.offsets(), result_.change);
            else
                eachLine([&](int line) { addLine(lines.line(line), result_.change); });
            // Neighbours often had the same block before: air, or the inside of the stock.
            if (present != counted_ || width * height != countedLines_) {
                subtractReplaced();
                counted_ = present;
                countedLines_ = width * height;
                eachLine([&](int line) { addLine(tile.line(line), replaced_); });
            }
            ++replacedBricks_;
        }
        BrickRewrite& all_;
        RowResult& result_;
        BlockIndex counted_ = noBlock;
        int countedLines_ = 0;
        RunAmounts replaced_; ///< in brick `counted_`
        std::uint64_t replacedBricks_ = 0;
    };

    std::span<BlockIndex> row(std::int32_t index) noexcept {
        return std::span(fresh_).subspan(static_cast<std::size_t>(index) * columns_, columns_);
    }
    /// Releases a block that is not needed.
    void discard(BlockIndex& block) noexcept {
        const BlockIndex gone = std::exchange(block, noBlock);
        if (gone != noBlock && volume_.header(gone).users == 0) volume_.store_->arena->release(gone);
    }
    BlockIndex present(LineIndex low) const noexcept {
        const VolumeStore& store = *volume_.store_;
        return store.page(volume_.pages_[store.table.pageOf(low)])[static_cast<std::size_t>(TileTable::entryOf(low))];
    }
    std::size_t placeOf(LineIndex low) const noexcept {
        return static_cast<std::size_t>(low.v / tileSide) * columns_ + static_cast<std::size_t>(low.u / tileSide);
    }

    /// Any thread.
    BlockIndex makeBlock(const BrickLines& lines) {
        const bool uniform = lines.uniform();
        BlockIndex block = noBlock;
        {
            const std::lock_guard lock(mutex_);
            block = uniform ? uniformBlock(lines) : volume_.allocateTile(lines.segmentCount());
        }
        if (block != noBlock && !uniform) volume_.store_->tile(block).copyFrom(lines);
        return block;
    }
    BlockIndex uniformBlock(const BrickLines& lines) {
        const std::span<const Segment> line = lines.line(0);
        const auto known = uniform_.find(line);
        if (known != uniform_.end() && known->second != noBlock) return known->second;
        BlockIndex& block = known != uniform_.end()
                                ? known->second
                                : uniform_.emplace(LineContent(line.begin(), line.end()), noBlock).first->second;
        block = volume_.allocateTile(lines.segmentCount());
        if (block == noBlock) return noBlock;
        volume_.header(block).users = 1; // held by this object until the end
        volume_.store_->tile(block).copyFrom(lines);
        return block;
    }

    /// Updates the table to the new bricks of a row. False: no memory for a page of the table, or the row had none.
    bool commit(std::int32_t row, const RowResult& result) noexcept {
        for (LineIndex low{0, row * tileSide}; low.u < volume_.store_->grid.lineCountU(); low.u += tileSide)
            if (fresh_[placeOf(low)] != noBlock && volume_.writableEntry(low) == nullptr) return false;
        for (LineIndex low{0, row * tileSide}; low.u < volume_.store_->grid.lineCountU(); low.u += tileSide) {
            const BlockIndex block = std::exchange(fresh_[placeOf(low)], noBlock);
            if (block == noBlock) continue;
            ++volume_.header(block).users;
            volume_.drop(std::exchange(*volume_.writableEntry(low), block));
        }
        sum(volume_.amounts_, result.change);
        return true;
    }

    Impl& volume_;
    std::size_t columns_;
    std::vector<BlockIndex> fresh_; ///< by brick: its replacement; written only by the thread of its row
    std::mutex mutex_;              ///< for the arena and for:
    std::map<LineContent, BlockIndex, ContentOrder> uniform_; ///< bricks of 64 equal lines, by such a line
};

bool RunVolume::Impl::rewriteBricks(const std::function<void(std::int32_t row, BrickSink& sink)>& describe) {
    return BrickRewrite(*this).run(describe);
}

} // namespace burin
