// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/growing_field.h"

#include "core/base/background.h"
#include "core/base/guarded.h"
#include "core/field/field_builder.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace burin {

namespace {

constexpr const char* subject = "boundary field of a tool";
constexpr double mostTiles = 1U << 24U;
constexpr int fewestBricks = 8;              ///< along a tile: samples on its upper faces are evaluated twice
constexpr double mostSmallestTiles = 4000.0; ///< more of them cost more than having the first one sooner gains
/// Maximum number of corners of the outline that is worth computing before the first cut.
constexpr double mostCorners = 24000.0;
/// How much nearer, in tiles, the tool has to be to a missing tile than to the tile that is dropped for it.
constexpr double tilesNearer = 2.0;
constexpr std::chrono::milliseconds glance{5};  // interval between polls of a loop's answers
constexpr std::chrono::milliseconds rest{1000}; // interval if nobody answers

double tilesIn(const Box& box, double edge) noexcept {
    double count = 1.0;
    for (int axis = 0; axis < 3; ++axis) count *= std::max(1.0, std::ceil((box.high[axis] - box.low[axis]) / edge));
    return count;
}

/// Number of bricks along a tile's edge.
int bricksPerTile(const Box& tips, double brick) noexcept {
    int bricks = fewestBricks;
    double most = mostSmallestTiles;
    while (tilesIn(tips, brick * bricks) > most && bricks < 1024) {
        bricks *= 2;
        most = mostCorners;
    }
    return bricks;
}

/// Number of the outline's cells along a tile's edge: as many as the number of corners permits.
int cellsPerTile(const TileLayout& layout) noexcept {
    int cells = 1;
    while (cells < fewestBricks && 8.0 * cells * cells * cells * static_cast<double>(layout.count()) <= mostCorners)
        cells *= 2;
    return cells;
}

} // namespace

GrowingField::GrowingField(std::shared_ptr<const MeshDistance> part, const ToolFieldRequest& request,
                           const GrowthLimits& limits)
    : part_(std::move(part)), request_(request), threads_(std::max(limits.threads, 1U)), limit_(limits.bytes) {}

GrowingField::~GrowingField() {
    background_.cancel();
    {
        const std::scoped_lock lock(mutex_); // no worker is between checking for the stop and waiting
        for (std::jthread& worker : workers_) worker.request_stop();
    }
    changed_.notify_all();
}

Result<std::shared_ptr<GrowingField>> GrowingField::lay(std::shared_ptr<const MeshDistance> part,
                                                        const ToolFieldRequest& request, const GrowthLimits& limits,
                                                        Progress& progress) {
    if (Result<void> usable = checkFieldRequest(request); !usable) return std::move(usable).error();
    return guarded(subject, [&]() -> Result<std::shared_ptr<GrowingField>> {
        const std::shared_ptr<GrowingField> field(new GrowingField(std::move(part), request, limits));
        if (Result<void> laid = field->layOutline(progress); !laid) return std::move(laid).error();
        return field;
    });
}

Result<void> GrowingField::layOutline(Progress& progress) {
    const FieldResolution resolution = fieldResolution(request_);
    spacing_ = resolution.spacing;
    errorBound_ = resolution.errorBound();
    const double brickEdge = spacing_ * BrickField::cells;
    const double edge = brickEdge * bricksPerTile(request_.tips, brickEdge);
    if (!(tilesIn(request_.tips, edge) <= mostTiles))
        return Error{ErrorCode::outOfMemory, subject, "", "more tiles than a field can count"};
    layout_ = TileLayout(request_.tips, edge);
    const int cells = cellsPerTile(layout_);
    Result<CoarseBricks> coarse = buildCoarseBricks(*part_, request_, edge / cells, progress);
    if (!coarse) return std::move(coarse).error();
    outline_ = std::move(coarse->field);
    tiles_.resize(layout_.count());
    isNeeded_.assign(layout_.count(), 0);
    for (std::size_t brick = 0; brick < outline_.brickCount(); ++brick) {
        if (coarse->band[brick] == 0) continue;
        const std::uint32_t number = layout_.tileAt(glm::min(outline_.brickOf(brick) / cells, layout_.tiles - 1));
        if (isNeeded_[number] == 0) ++needed_;
        isNeeded_[number] = 1;
        tiles_[number].state = Tile::State::absent;
    }
    tool_ = {0.5 * (request_.tips.low.x + request_.tips.high.x), 0.5 * (request_.tips.low.y + request_.tips.high.y),
             request_.tips.high.z};
    return {};
}

FieldSample GrowingField::outline(const glm::dvec3& tip) const noexcept {
    FieldSample sample = outline_.sample(tip);
    // Where no tile will come, the outline means that the tool is clear, or deep inside: less would hold it
    // permanently.
    if (isNeeded_[layout_.tileOf(tip)] != 0) sample.clearance -= spacing_;
    return sample;
}

FieldSample GrowingField::at(const glm::dvec3& tip) const noexcept {
    const glm::dvec3 kept = layout_.kept(tip);
    const Tile& tile = tiles_[layout_.tileOf(kept)];
    const std::shared_lock lock(table_);
    FieldSample sample = tile.bricks ? tile.bricks->sampleInside(kept) : outline(kept);
    sample.fine = sample.fine && kept == tip;
    return sample;
}

/// The outline is never too high.
double GrowingField::errorBoundAt(const glm::dvec3& tip) const noexcept {
    const glm::dvec3 kept = layout_.kept(tip);
    const Tile& tile = tiles_[layout_.tileOf(kept)];
    const std::shared_lock lock(table_);
    return (tile.bricks ? tile.bricks->bound(kept) : 0.0) + glm::length(tip - kept);
}

std::size_t GrowingField::memoryBytes() const {
    const std::scoped_lock lock(mutex_);
    return sizeof(GrowingField) + outline_.memoryBytes() + tiles_.capacity() * sizeof(Tile) + bytes_;
}

bool GrowingField::complete() const {
    const std::scoped_lock lock(mutex_);
    return there_ == needed_;
}

std::optional<Error> GrowingField::failure() const {
    const std::scoped_lock lock(mutex_);
    return failure_;
}

Result<GrowingField::Bricks> GrowingField::make(std::uint32_t number, Progress& progress) const {
    return guarded(subject, [&]() -> Result<Bricks> {
        ToolFieldRequest request = request_;
        request.tips = layout_.boxOf(number);
        Result<BrickField> bricks = buildBrickField(*part_, request, progress);
        if (!bricks) return std::move(bricks).error();
        return Bricks(std::make_shared<const BrickField>(std::move(*bricks)));
    });
}

void GrowingField::grow(const glm::dvec3& tip) {
    const std::scoped_lock lock(mutex_);
    tool_ = tip;
    start();
}

void GrowingField::start() {
    quiet_ = false;
    helpInBackground(); // milling has precedence meanwhile
    while (workers_.size() < threads_) workers_.emplace_back([this](const std::stop_token& stop) { work(stop); });
    changed_.notify_all();
}

std::shared_ptr<TileFeed> GrowingField::feed() {
    const std::scoped_lock lock(mutex_);
    listen(); // requests to a loop that is gone
    auto feed = std::make_shared<TileFeed>(tiles_.size());
    std::vector<std::pair<double, std::uint32_t>> there;
    for (std::uint32_t number = 0; number < tiles_.size(); ++number)
        if (tiles_[number].bricks) there.emplace_back(layout_.distance(number, tool_), number);
    std::ranges::sort(there);
    for (const auto& [distance, number] : there) feed->news_.push({number, tiles_[number].bricks.get()});
    feed_ = feed;
    start();
    return feed;
}

/// Processes the loop's answers and the position of its tool; drops tiles that wait for the answer of a loop that is
/// gone.
void GrowingField::listen() {
    const std::shared_ptr<TileFeed> feed = reader();
    if (!feed) {
        for (Tile& tile : tiles_)
            if (tile.state == Tile::State::leaving) drop(tile);
        return;
    }
    if (glm::dvec3 tip; feed->tool_.take(tip)) tool_ = tip;
    for (TileFeed::Answer answer; feed->answers_.pop({&answer, 1}) == 1;) {
        Tile& tile = tiles_[answer.tile];
        if (answer.letGo)
            drop(tile);
        else
            tile.state = Tile::State::there;
    }
}

void GrowingField::drop(Tile& tile) {
    const std::unique_lock lock(table_);
    bytes_ -= tile.bricks->memoryBytes();
    tile.bricks.reset();
    tile.state = Tile::State::absent;
    --there_;
}

/// The next tile to make, nearest to the tool; none if there is no room or nothing left to do.
std::optional<std::uint32_t> GrowingField::claim() {
    std::optional<std::uint32_t> nearest;
    double least = 0.0;
    for (std::uint32_t number = 0; number < tiles_.size(); ++number) {
        if (tiles_[number].state != Tile::State::absent) continue;
        const double distance = layout_.distance(number, tool_);
        if (nearest && !(distance < least)) continue;
        nearest = number;
        least = distance;
    }
    if (nearest && (keepsAll_ || bytes_ < limit_ || makeRoom(least) || isUrgent(least))) {
        tiles_[*nearest].state = Tile::State::making;
        ++making_;
        return nearest;
    }
    return std::nullopt;
}

/// The tile that the tool is about to enter is made whatever the limit, unless memory ran out.
bool GrowingField::isUrgent(double distance) const noexcept {
    return distance < 0.5 * layout_.edge && !failure_;
}

/// Drops the tile farthest from the tool, if it is farther than the missing one. False: there is no room yet.
bool GrowingField::makeRoom(double forDistance) {
    Tile* farthest = nullptr;
    std::uint32_t number = 0;
    double most = forDistance + tilesNearer * layout_.edge;
    for (std::uint32_t i = 0; i < tiles_.size(); ++i) {
        if (tiles_[i].state == Tile::State::leaving) return false; // the loop is about to answer
        if (tiles_[i].state != Tile::State::there) continue;
        const double distance = layout_.distance(i, tool_);
        if (!(distance > most)) continue;
        most = distance;
        farthest = &tiles_[i];
        number = i;
    }
    if (farthest == nullptr) return false;
    if (const std::shared_ptr<TileFeed> feed = reader()) {
        farthest->state = Tile::State::leaving;
        feed->news_.push({number, nullptr});
        return false;
    }
    drop(*farthest);
    return bytes_ < limit_ || makeRoom(forDistance);
}

void GrowingField::publish(std::uint32_t number, Result<Bricks> made) {
    Tile& tile = tiles_[number];
    --making_;
    if (!made) {
        tile.state = Tile::State::absent;
        if (made.error().code != ErrorCode::cancelled) {
            failure_ = made.error();
            limit_ = std::min(limit_, bytes_); // no more than fits into memory
        }
        return;
    }
    bytes_ += (*made)->memoryBytes();
    ++there_;
    tile.state = Tile::State::there;
    const std::unique_lock lock(table_);
    tile.bricks = std::move(*made);
    if (const std::shared_ptr<TileFeed> feed = reader()) feed->news_.push({number, tile.bricks.get()});
}

/// @param lock  of the mutex; unlocked while the tile is made
void GrowingField::makeClaimed(std::uint32_t number, std::unique_lock<std::mutex>& lock) {
    lock.unlock();
    Result<Bricks> made = make(number, background_);
    lock.lock();
    publish(number, std::move(made));
}

void GrowingField::work(const std::stop_token& stop) {
    workInBackground();
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        listen();
        if (const std::optional<std::uint32_t> number = claim()) {
            makeClaimed(*number, lock);
        } else {
            const bool quiet = making_ == 0 && std::ranges::none_of(tiles_, [](const Tile& tile) {
                                   return tile.state == Tile::State::leaving;
                               });
            if (std::exchange(quiet_, quiet) != quiet) changed_.notify_all();
            const bool answers = reader() && there_ < needed_; // all other events wake this thread
            changed_.wait_for(lock, answers ? glance : rest);
        }
    }
}

Result<void> GrowingField::finish(Progress& progress) {
    std::unique_lock lock(mutex_);
    keepsAll_ = true;
    failure_.reset();
    while (there_ < needed_ && !failure_) {
        if (progress.cancelled()) break;
        progress.report(static_cast<double>(there_) / static_cast<double>(needed_));
        listen();
        if (const std::optional<std::uint32_t> number = claim()) {
            makeClaimed(*number, lock);
        } else {
            changed_.wait_for(lock, glance); // others are making the remaining tiles
        }
    }
    if (there_ == needed_) {
        whole_.store(true, std::memory_order_release);
        return {};
    }
    keepsAll_ = false;
    return failure_ ? *failure_ : Error{ErrorCode::cancelled, subject, "", ""};
}

bool GrowingField::waitUntilQuiet(Progress& progress, double seconds) const {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                     std::chrono::duration<double>(std::min(seconds, 1e6)));
    std::unique_lock lock(mutex_);
    while (!quiet_ && there_ < needed_) {
        if (progress.cancelled() || Clock::now() >= end) return false;
        progress.report(static_cast<double>(there_) / static_cast<double>(needed_));
        changed_.wait_for(lock, glance);
    }
    return true;
}

Result<GrowingField::Bricks> GrowingField::tile(std::uint32_t number, Progress& progress) {
    if (number >= tiles_.size()) return Error{ErrorCode::argumentInvalid, "tile", std::to_string(number), ""};
    std::unique_lock lock(mutex_);
    for (;;) {
        Tile& tile = tiles_[number];
        if (isNeeded_[number] == 0 || tile.bricks) return tile.bricks;
        if (progress.cancelled()) return Error{ErrorCode::cancelled, subject, "", ""};
        if (tile.state == Tile::State::absent) break;
        changed_.wait_for(lock, glance); // a worker is making it
    }
    tiles_[number].state = Tile::State::making;
    ++making_;
    lock.unlock();
    Result<Bricks> made = make(number, progress);
    lock.lock();
    publish(number, made);
    return made;
}

} // namespace burin
