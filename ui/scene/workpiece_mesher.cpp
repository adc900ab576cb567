// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/workpiece_mesher.h"

#include "core/volume/runs/alike.h"
#include "ui/scene/skirt_depth.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace burin {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// The time without changes after which full detail is meshed.
constexpr auto restDelay = 100ms;
/// The number of groups that a tool changes at once: they are finished before the next snapshot is taken.
constexpr std::size_t fewGroups = 4;
/// Changed tiles are meshed at full detail as long as this takes no longer than this, s.
constexpr double timeForFull = 0.015;
/// Groups of full detail that a tool changes at once, and the factor by which they have more triangles than finished
/// groups, because their tiles are not joined.
constexpr std::size_t changedGroups = 2, unjoined = 2;
constexpr double rimTolerance = 0.01; ///< voxels: permitted gap at the upper edge of a skirt
constexpr double skirtCells = 1.5;    ///< cells of the coarser layer: as deep as the two layers may differ

// Levels of detail by which a layer is reduced to its limit of triangles; tolerances in voxels.
constexpr std::array<SurfaceDetail, 6> movingDetails{{{1, 0.5}, {1, 1.0}, {2, 1.0}, {2, 2.0}, {3, 4.0}, {3, 8.0}}};
constexpr std::array<SurfaceDetail, 6> restDetails{{{0, 0.1}, {0, 0.2}, {1, 0.4}, {1, 0.8}, {2, 1.6}, {3, 3.2}}};

constexpr const std::array<SurfaceDetail, 6>& details(SurfaceLayer which) {
    return which == SurfaceLayer::moving ? movingDetails : restDetails;
}

/// Tens of thousands of tiles are stored: frees the memory that simplification no longer needs.
void giveBackUnused(SurfaceMesh& mesh) {
    const auto fit = [](auto& values) {
        if (values.capacity() > 2 * values.size()) values.shrink_to_fit();
    };
    fit(mesh.points);
    fit(mesh.normals);
    fit(mesh.properties);
    fit(mesh.triangles);
}

} // namespace

void WorkpieceMesher::Layer::start(const WorkpieceGroups& groups) {
    step = 0;
    tiles.assign(groups.tileCount(), {});
    bare.assign(groups.tileCount(), {});
    triangles.assign(groups.count(), 0);
    excess.assign(groups.count(), {});
    staleTiles.resize(groups.tileCount());
    staleGroups.resize(groups.count());
    markAll();
}

void WorkpieceMesher::Layer::markAll() {
    rims.clear();
    std::fill(staleTiles.begin(), staleTiles.end(), std::uint8_t{1});
    std::fill(staleGroups.begin(), staleGroups.end(), std::uint8_t{1});
}

std::size_t WorkpieceMesher::Layer::staleCount() const {
    return static_cast<std::size_t>(std::count(staleGroups.begin(), staleGroups.end(), 1));
}

std::size_t WorkpieceMesher::Layer::triangleCount() const {
    return std::accumulate(triangles.begin(), triangles.end(), std::size_t{0});
}

bool WorkpieceMesher::Layer::hasStale() const {
    return std::find(staleGroups.begin(), staleGroups.end(), 1) != staleGroups.end();
}

WorkpieceMesher::WorkpieceMesher(const Limits& limits, std::function<void()> ready)
    : limits_(limits), ready_(std::move(ready)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

WorkpieceMesher::~WorkpieceMesher() = default; // the thread is first asked to stop, and joined

// ---- Any thread

void WorkpieceMesher::show(const VolumeSnapshot& workpiece, std::optional<CutTime> oldestCut) {
    VolumeSnapshot skipped = workpiece; // its final content is released outside the lock
    {
        const std::lock_guard lock(mutex_);
        std::swap(newest_, skipped);
        if (oldestCut && (!newestCut_ || *oldestCut < *newestCut_)) newestCut_ = oldestCut;
        newestWaits_ = true;
        busy_.store(true, std::memory_order_release);
    }
    wake_.notify_one();
}

void WorkpieceMesher::setPartColour(const RgbColour& colour) {
    {
        const std::lock_guard lock(mutex_);
        if (partColour_ == colour) return;
        partColour_ = colour;
        recolour_ = true;
        busy_.store(true, std::memory_order_release);
    }
    wake_.notify_one();
}

void WorkpieceMesher::setExcess(std::optional<ExcessColours> left) {
    {
        const std::lock_guard lock(mutex_);
        if (wantedExcess_ == left) return;
        std::swap(wantedExcess_, left); // its previous content is released outside the lock
        recolour_ = true;
        busy_.store(true, std::memory_order_release);
    }
    wake_.notify_one();
}

void WorkpieceMesher::setPartDrawn(bool drawn) {
    {
        const std::lock_guard lock(mutex_);
        if (partDrawn_ == drawn) return;
        partDrawn_ = drawn;
        remesh_ = true;
        busy_.store(true, std::memory_order_release);
    }
    wake_.notify_one();
}

void WorkpieceMesher::setFocus(const glm::dvec3& focus) {
    const std::lock_guard lock(mutex_);
    focus_ = focus;
}

SurfaceDelivery WorkpieceMesher::take() {
    const std::lock_guard lock(mutex_);
    SurfaceDelivery taken = delivery_;
    delivery_.updates.clear();
    delivery_.cut.reset();
    return taken;
}

// ---- The worker

void WorkpieceMesher::run(const std::stop_token& stop) {
    stop_ = stop;
    while (true) {
        waitForWork();
        if (stop.stop_requested()) return;
        takeNewest();
        refreshMoving();
        refreshRest();
    }
}

void WorkpieceMesher::waitForWork() {
    std::unique_lock lock(mutex_);
    const auto called = [this] { return newestWaits_ || recolour_ || remesh_; };
    if (layer(SurfaceLayer::moving).hasStale()) return;
    const Layer& rest = layer(SurfaceLayer::rest);
    if (rest.hasStale()) {
        Moment first = Moment::max();
        for (std::size_t group = 0; group < groups_.count(); ++group)
            if (rest.staleGroups[group] != 0) first = std::min(first, changed_[group]);
        wake_.wait_until(lock, stop_, first + restDelay, called);
        return;
    }
    busy_.store(called(), std::memory_order_release);
    wake_.wait(lock, stop_, called);
}

bool WorkpieceMesher::interrupted() {
    const std::lock_guard lock(mutex_);
    return newestWaits_ || stop_.stop_requested();
}

void WorkpieceMesher::takeNewest() {
    VolumeSnapshot before;
    std::array<std::vector<ExcessMemory>, 2> forgotten; // released outside the lock
    {
        const std::lock_guard lock(mutex_);
        if (std::exchange(recolour_, false))
            for (Layer& one : layers_) std::fill(one.staleGroups.begin(), one.staleGroups.end(), std::uint8_t{1});
        if (std::exchange(remesh_, false))
            for (Layer& one : layers_) one.markAll();
        colour_ = partColour_;
        if (left_ != wantedExcess_) // distances from another part, or in another range
            for (std::size_t i = 0; i < layers_.size(); ++i)
                forgotten[i] = std::exchange(layers_[i].excess, std::vector<ExcessMemory>(groups_.count()));
        left_ = wantedExcess_;
        withoutPart_ = partDrawn_;
        if (!std::exchange(newestWaits_, false)) return;
        before = std::exchange(shown_, std::exchange(newest_, {}));
        if (newestCut_ && (!cut_ || *newestCut_ < *cut_)) cut_ = newestCut_;
        newestCut_.reset();
    }
    // A workpiece of the past is a separate volume: what it shares with the drawn one stays drawn.
    const bool other = before.empty() || shown_.empty() || !alike(before.grid(), shown_.grid()) ||
                       !alike(before.properties(), shown_.properties());
    if (!other)
        markChanges(before);
    else
        startVolume();
}

void WorkpieceMesher::startVolume() {
    groups_ = shown_.empty() ? WorkpieceGroups() : WorkpieceGroups(shown_.grid());
    for (Layer& one : layers_) one.start(groups_);
    changed_.assign(groups_.count(), Clock::now() - restDelay); // full detail can follow without a pause
    fullFits_ = false;
    {
        const std::lock_guard lock(mutex_);
        ++delivery_.volume;
        delivery_.grid = shown_.empty() ? Grid() : shown_.grid();
        delivery_.groups = groups_.centres();
        delivery_.updates.clear();
    }
    sharpening_ = shown_.empty() ? StockSharpening() : StockSharpening(stockOf(shown_), shown_.grid());
    ready_();
}

void WorkpieceMesher::markChanges(const VolumeSnapshot& before) {
    const int level = std::max(detail(SurfaceLayer::moving).level, detail(SurfaceLayer::rest).level);
    for (const SurfaceTile tile : changedSurface(before, shown_, level)) {
        const std::size_t group = groups_.groupOf(tile);
        changed_[group] = Clock::now();
        for (Layer& one : layers_) one.staleTiles[groups_.place(tile)] = one.staleGroups[group] = 1;
    }
}

void WorkpieceMesher::refreshMoving() {
    Layer& moving = layer(SurfaceLayer::moving);
    const bool many = moving.staleCount() > fewGroups, inFull = fullFitsInTime();
    while (moving.hasStale()) {
        if (many && interrupted()) return;
        const std::size_t group = nearestStale(moving, Moment::max());
        if (!refreshMovingTiles(group, many, inFull)) return;
        deliver({makeGroup(SurfaceLayer::moving, group, fullFits_)});
        if (!moving.hasStale()) settleMoving();
    }
    deliverCut();
}

/// A tile that is already at full detail needs no coarse one. Returns false if it was interrupted for a newer snapshot;
/// tiles that are already meshed are kept.
bool WorkpieceMesher::refreshMovingTiles(std::size_t group, bool mayStop, bool inFull) {
    bool complete = true;
    groups_.eachTile(group, [&](SurfaceTile tile) {
        const std::size_t place = groups_.place(tile);
        const bool inFullAlready = fullFits_ && layer(SurfaceLayer::rest).staleTiles[place] == 0;
        if (!complete || inFullAlready || layer(SurfaceLayer::moving).staleTiles[place] == 0) return;
        complete = !mayStop || !interrupted();
        if (complete) makeTile(inFull ? SurfaceLayer::rest : SurfaceLayer::moving, tile);
    });
    return complete;
}

/// Processes one group at a time, since cuts have priority. The group's moving surface becomes completely coarse again,
/// to make room for the next groups.
void WorkpieceMesher::refreshRest() {
    Layer& rest = layer(SurfaceLayer::rest);
    const std::size_t group = nearestStale(rest, Clock::now() - restDelay);
    if (group == groups_.count() || interrupted()) return;
    if (!refreshTiles(SurfaceLayer::rest, group) || !refreshTiles(SurfaceLayer::moving, group)) return;
    std::vector<SurfaceUpdate> updates;
    updates.push_back(makeGroup(SurfaceLayer::moving, group, false));
    updates.push_back(makeGroup(SurfaceLayer::rest, group, false));
    deliver(std::move(updates));
    if (!rest.hasStale()) settleRest();
}

/// Returns false if it was interrupted for a newer snapshot; tiles that are already meshed are kept.
bool WorkpieceMesher::refreshTiles(SurfaceLayer which, std::size_t group) {
    bool complete = true;
    groups_.eachTile(group, [&](SurfaceTile tile) {
        if (!complete || layer(which).staleTiles[groups_.place(tile)] == 0) return;
        complete = !interrupted();
        if (complete) makeTile(which, tile);
    });
    return complete;
}

void WorkpieceMesher::makeTile(SurfaceLayer which, SurfaceTile tile) {
    const Moment start = Clock::now();
    const SurfaceDetail wanted = detail(which);
    const double edge = shown_.grid().edge();
    const std::size_t place = groups_.place(tile);
    SurfaceMesh& mesh = layer(which).tiles[place];
    const auto extract = [&](SurfaceTile of, SurfaceMesh& to) {
        extractor_.extract(shown_, of, {wanted.level, 0.0}, to);
        sharpening_.sharpen(of, wanted.level, to);
    };
    extract(tile, mesh);
    layer(which).bare[place].clear();
    if (withoutPart_) {
        findBareBricks(shown_, wanted.level, mesh, layer(which).bare[place]);
        border_.draw(shown_, tile, wanted.level, extract, layer(which).rims, mesh);
    }
    simplifier_.simplify(mesh, 0.5 * wanted.tolerance * edge, // the other half is for the whole group
                         edge * (1 << wanted.level), sharpening_.faces());
    giveBackUnused(mesh);
    layer(which).staleTiles[place] = 0;
    if (which == SurfaceLayer::rest) {
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        fullTileSeconds_ += 0.1 * (seconds - fullTileSeconds_);
    }
}

/// @param mixed whether to use tiles at full detail where they exist, unchanged
SurfaceUpdate WorkpieceMesher::makeGroup(SurfaceLayer which, std::size_t group, bool mixed) {
    const Layer& rest = layer(SurfaceLayer::rest);
    std::vector<const SurfaceMesh*> pieces;
    std::vector<SurfaceBrick> bare;
    groups_.eachTile(group, [&](SurfaceTile tile) {
        const std::size_t place = groups_.place(tile);
        const Layer& from = mixed && rest.staleTiles[place] == 0 ? rest : layer(which);
        pieces.push_back(&from.tiles[place]);
        bare.insert(bare.end(), from.bare[place].begin(), from.bare[place].end());
    });
    simplifier_.join(pieces, joined_);
    const SurfaceDetail wanted = detail(which);
    const double edge = shown_.grid().edge(), cell = edge * (1 << wanted.level);
    if (!mixed) simplifier_.simplify(joined_, 0.5 * wanted.tolerance * edge, cell, sharpening_.faces());
    const double deepest = skirtCells * edge * (1 << detail(SurfaceLayer::moving).level);
    std::vector<std::uint32_t> rim = simplifier_.rim(joined_, rimTolerance * edge);
    if (withoutPart_) leaveOutBarePart(joined_, rim, shown_.properties());
    const std::vector<float> skirt = skirtDepths(shown_, joined_, rim, static_cast<float>(deepest));
    const std::vector<RgbColour> colours =
        coloursOf(joined_, ExcessDetail::of(cell, which == SurfaceLayer::moving), layer(which).excess[group]);
    SurfaceUpdate update{group, which, {}, joined_.triangles.size() / 3 + rim.size(), std::move(bare)};
    update.data = surfacePolyData(joined_, colours, rim, skirt);
    layer(which).triangles[group] = update.triangles;
    layer(which).staleGroups[group] = 0;
    return update;
}

/// @param mesh points may be added to it
std::vector<RgbColour> WorkpieceMesher::coloursOf(SurfaceMesh& mesh, const ExcessDetail& detail,
                                                  ExcessMemory& memory) const {
    return left_ ? colourByExcess(mesh, shown_.properties(), *left_, detail, memory)
                 : colourByMaterial(mesh, shown_.properties(), colour_);
}

/// Whether the tiles changed by a cut can be meshed at full detail at once.
bool WorkpieceMesher::fullFitsInTime() {
    const std::vector<std::uint8_t>& stale = layer(SurfaceLayer::rest).staleTiles;
    const auto tiles = static_cast<double>(std::count(stale.begin(), stale.end(), 1));
    return fullFits_ && tiles * fullTileSeconds_ <= timeForFull;
}

bool WorkpieceMesher::roomForFull() {
    const std::vector<std::size_t>& rest = layer(SurfaceLayer::rest).triangles;
    const std::size_t largest = rest.empty() ? 0 : *std::max_element(rest.begin(), rest.end());
    return layer(SurfaceLayer::moving).triangleCount() + changedGroups * unjoined * largest <= limits_.moving;
}

/// Called when all groups are meshed: checks whether they keep to the limit.
void WorkpieceMesher::settleMoving() {
    Layer& moving = layer(SurfaceLayer::moving);
    if (!moving.tooMany(limits_.moving)) return;
    if (fullFits_) { // first without tiles of full detail
        fullFits_ = false;
        std::fill(moving.staleGroups.begin(), moving.staleGroups.end(), std::uint8_t{1});
    } else
        coarsen(SurfaceLayer::moving);
}

void WorkpieceMesher::settleRest() {
    if (layer(SurfaceLayer::rest).tooMany(limits_.rest)) coarsen(SurfaceLayer::rest);
    fullFits_ = roomForFull();
}

void WorkpieceMesher::coarsen(SurfaceLayer which) {
    if (layer(which).step + 1 == details(which).size()) return;
    ++layer(which).step;
    layer(which).markAll();
}

void WorkpieceMesher::deliver(std::vector<SurfaceUpdate> updates) {
    {
        const std::lock_guard lock(mutex_);
        for (SurfaceUpdate& update : updates) {
            std::erase_if(delivery_.updates, [&](const SurfaceUpdate& older) {
                return older.group == update.group &&
                       (older.layer == update.layer || update.layer == SurfaceLayer::moving);
            });
            delivery_.updates.push_back(std::move(update));
        }
    }
    ready_();
}

void WorkpieceMesher::deliverCut() {
    if (!cut_) return;
    {
        const std::lock_guard lock(mutex_);
        if (!delivery_.cut || *cut_ < *delivery_.cut) delivery_.cut = cut_;
        cut_.reset();
    }
    ready_();
}

/// Returns groups_.count() if there is none that hasn't changed since.
std::size_t WorkpieceMesher::nearestStale(const Layer& layer, Moment changedBefore) {
    glm::dvec3 focus;
    {
        const std::lock_guard lock(mutex_);
        focus = focus_;
    }
    std::size_t nearest = groups_.count();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t group = 0; group < groups_.count(); ++group) {
        const double distance = glm::length(groups_.centres()[group] - focus);
        if (layer.staleGroups[group] == 0 || changed_[group] > changedBefore || distance >= least) continue;
        least = distance;
        nearest = group;
    }
    return nearest;
}

SurfaceDetail WorkpieceMesher::detail(SurfaceLayer which) {
    return details(which)[layer(which).step];
}

} // namespace burin
