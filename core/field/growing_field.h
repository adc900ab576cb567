// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/field/brick_field.h"
#include "core/field/tile_feed.h"
#include "core/field/tile_layout.h"
#include "core/field/tool_field.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <thread>
#include <vector>

namespace burin {

/// Limits of the resources of a growing field.
struct GrowthLimits {
    std::size_t bytes = std::size_t{256} << 20U; ///< for tiles except those around the tool; others make room
    unsigned threads = 1;                        ///< background threads, one tile each; all processors help them
};

/// A ToolField that is available almost at once whatever its size: coarse everywhere, and fine first where the tool is.
/// Its box of tips is cut into tiles of 8 bricks per side, or 16 or more if there would be too many tiles. Each tile
/// that the fine band passes through is built as a field of its own, in the background; its content depends only on its
/// number and the request. Where the tile is missing, the outline is used: a lower bound of the clearance from corners
/// far apart, less a cell, so that no tool that it admits is inside the boundary once the tile is available. It never
/// exceeds the clearance.
///
/// A loop that must not wait reads tiles as its TileFeed hands them over (GrowingBoundary, core/haptics). All other
/// callers use it as a ClearanceField: `at` then waits while a tile is being inserted. Thread-safe.
class GrowingField final : public ClearanceField {
public:
    /// Builds the outline; no tile is made yet. Cost: some tenths of a second; parallel. Errors: those of
    /// ToolField::build.
    /// @param part never null
    static Result<std::shared_ptr<GrowingField>> lay(std::shared_ptr<const MeshDistance> part,
                                                     const ToolFieldRequest& request, const GrowthLimits& limits,
                                                     Progress& progress);
    ~GrowingField() override; ///< stops the background work
    GrowingField(const GrowingField&) = delete;
    GrowingField& operator=(const GrowingField&) = delete;

    /// Starts making tiles in the background, those nearest to the tip first; nearest to the tool as soon as there is a
    /// feed.
    void grow(const glm::dvec3& tip);
    /// For one loop at a time; existing tiles are handed over at once, the nearest first. Starts growing.
    std::shared_ptr<TileFeed> feed();
    /// Makes all tiles, with all processors, and keeps them regardless of the memory limit. Errors: cancelled,
    /// outOfMemory.
    Result<void> finish(Progress& progress);
    /// Waits until no work is left for the current position of the tool. False: cancelled, or `seconds` have passed.
    /// @param progress  receives the share of the tiles that are available
    bool waitUntilQuiet(Progress& progress, double seconds) const;
    /// Returns a tile, made on the calling thread if it is missing; null if no tile is needed. Errors: cancelled,
    /// outOfMemory, argumentInvalid (a number out of range).
    Result<std::shared_ptr<const BrickField>> tile(std::uint32_t number, Progress& progress);
    /// Whether all tiles are available and will stay: `finish` has succeeded.
    bool whole() const noexcept { return whole_.load(std::memory_order_acquire); }
    /// Whether all tiles are available now.
    bool complete() const;
    /// The error that kept tiles from being made: outOfMemory.
    std::optional<Error> failure() const;

    const TileLayout& layout() const noexcept { return layout_; }
    /// Value used where there is no tile. @param tip  in the box. Any thread; no allocation, never waits.
    FieldSample outline(const glm::dvec3& tip) const noexcept;
    /// Memory of the outline and of the tiles that are available now. Any thread; waits for the holder of the lock.
    std::size_t memoryBytes() const;

    FieldSample at(const glm::dvec3& tip) const noexcept override;
    double errorBound() const noexcept override { return errorBound_; }
    double errorBoundAt(const glm::dvec3& tip) const noexcept override;
    double spacing() const noexcept override { return spacing_; }

private:
    using Bricks = std::shared_ptr<const BrickField>;
    struct Tile {
        enum class State : std::uint8_t { unneeded, absent, making, there, leaving } state = State::unneeded;
        Bricks bricks; ///< written while both locks are held
    };
    GrowingField(std::shared_ptr<const MeshDistance> part, const ToolFieldRequest& request, const GrowthLimits& limits);

    Result<void> layOutline(Progress& progress);
    Result<Bricks> make(std::uint32_t number, Progress& progress) const;
    void makeClaimed(std::uint32_t number, std::unique_lock<std::mutex>& lock);
    void work(const std::stop_token& stop);
    void start();
    void listen();
    std::optional<std::uint32_t> claim();
    bool makeRoom(double forDistance);
    bool isUrgent(double distance) const noexcept;
    void publish(std::uint32_t number, Result<Bricks> made);
    void drop(Tile& tile);
    std::shared_ptr<TileFeed> reader() const { return feed_.lock(); }

    const std::shared_ptr<const MeshDistance> part_;
    const ToolFieldRequest request_;
    TileLayout layout_;
    BrickField outline_;
    std::vector<std::uint8_t> isNeeded_;      ///< by tile: 1 if the fine band passes through it, otherwise 0
    double spacing_ = 0.0, errorBound_ = 0.0; ///< mm
    const unsigned threads_;
    std::atomic<bool> whole_{false};
    Progress background_; ///< cancelled in the destructor

    mutable std::mutex mutex_; ///< guards the members below
    mutable std::condition_variable changed_;
    mutable std::shared_mutex table_; ///< locked after the mutex: guards the tiles' bricks, for `at`
    std::vector<Tile> tiles_;
    std::size_t bytes_ = 0, limit_;
    std::uint32_t needed_ = 0, there_ = 0, making_ = 0;
    bool keepsAll_ = false, quiet_ = false;
    std::optional<Error> failure_;
    glm::dvec3 tool_{0.0};
    std::weak_ptr<TileFeed> feed_;
    std::vector<std::jthread> workers_; // last: they use the above
};

} // namespace burin
