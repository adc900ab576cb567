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

/// What a growing field may take.
struct GrowthLimits {
    std::size_t bytes = std::size_t{256} << 20U; ///< of tiles, but for those around the tool; others make room
    unsigned threads = 1;                        ///< in the background, a tile each; all processors help them
};

/// A ToolField that is there in a moment whatever its size: coarse everywhere, and fine where the tool is, first. Its
/// box of tips is cut into tiles of 8 bricks a side, or 16 or more where they would be too many. Each that the fine
/// band passes through is made as a field of its own, in the background; what a tile says depends on nothing but its
/// number and the request. Where its tile is not there, the outline answers: what is certain of the clearance from
/// corners far apart, less a cell, so that no tool which it lets be is inside the boundary once the tile has come. It
/// never exceeds the clearance.
///
/// A loop that must not wait reads tiles as its TileFeed hands them over (GrowingBoundary, core/haptics). As a
/// ClearanceField it is for everybody else: `at` then waits while a tile is being put in its place.
/// Thread-safe.
class GrowingField final : public ClearanceField {
public:
    /// Lays the outline; no tile is made yet. Cost: some tenths of a second; parallel. Errors: those of
    /// ToolField::build.
    /// @param part never null
    static Result<std::shared_ptr<GrowingField>> lay(std::shared_ptr<const MeshDistance> part,
                                                     const ToolFieldRequest& request, const GrowthLimits& limits,
                                                     Progress& progress);
    ~GrowingField() override; ///< stops what is made in the background
    GrowingField(const GrowingField&) = delete;
    GrowingField& operator=(const GrowingField&) = delete;

    /// Begins to make tiles in the background, those nearest to a tip first; the tool's as soon as there is a feed.
    void grow(const glm::dvec3& tip);
    /// For one loop, one at a time; tiles that are there come at once, the nearest first. Grows.
    std::shared_ptr<TileFeed> feed();
    /// Makes all tiles, with all processors, and keeps them whatever they take. Errors: cancelled, outOfMemory.
    Result<void> finish(Progress& progress);
    /// Waits until nothing is left to do for the tool where it is. False: cancelled, or `seconds` are over.
    /// @param progress gets the share of the tiles that are there
    bool waitUntilQuiet(Progress& progress, double seconds) const;
    /// A tile, made by the caller's thread where it is not there; null where none is needed. Errors: cancelled,
    /// outOfMemory, argumentInvalid (a number that there is not).
    Result<std::shared_ptr<const BrickField>> tile(std::uint32_t number, Progress& progress);
    /// All tiles are there, and stay: `finish` has succeeded.
    bool whole() const noexcept { return whole_.load(std::memory_order_acquire); }
    /// All tiles are there now.
    bool complete() const;
    /// What kept tiles from being made: outOfMemory.
    std::optional<Error> failure() const;

    const TileLayout& layout() const noexcept { return layout_; }
    /// Where no tile is there. @param tip in the box. Any thread; no allocation, never waits.
    FieldSample outline(const glm::dvec3& tip) const noexcept;
    /// Of the outline and of the tiles that are there now. Any thread; waits for whoever holds the lock.
    std::size_t memoryBytes() const;

    FieldSample at(const glm::dvec3& tip) const noexcept override;
    double errorBound() const noexcept override { return errorBound_; }
    double errorBoundAt(const glm::dvec3& tip) const noexcept override;
    double spacing() const noexcept override { return spacing_; }

private:
    using Bricks = std::shared_ptr<const BrickField>;
    struct Tile {
        enum class State : std::uint8_t { unneeded, absent, making, there, leaving } state = State::unneeded;
        Bricks bricks; ///< written under both locks
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
    std::vector<std::uint8_t> isNeeded_;      ///< by tile: the fine band passes through it; 1 or 0
    double spacing_ = 0.0, errorBound_ = 0.0; ///< mm
    const unsigned threads_;
    std::atomic<bool> whole_{false};
    Progress background_; ///< cancelled at the end

    mutable std::mutex mutex_; ///< of what follows
    mutable std::condition_variable changed_;
    mutable std::shared_mutex table_; ///< taken after the mutex: of the tiles' bricks, for `at`
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
