// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_simplification.h"
#include "ui/scene/bare_bricks.h"
#include "ui/scene/bare_part.h"
#include "ui/scene/excess_colours.h"
#include "ui/scene/stock_sharpening.h"
#include "ui/scene/workpiece_groups.h"
#include "ui/scene/workpiece_polydata.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace burin {

using CutTime = std::chrono::steady_clock::time_point;

/// Which of its two surfaces a group of tiles shows.
enum class SurfaceLayer : std::uint8_t { moving, rest };

/// A group of tiles that the worker has made.
struct SurfaceUpdate {
    std::size_t group = 0;
    SurfaceLayer layer = SurfaceLayer::moving; ///< `moving` puts what the group has at rest out of date
    vtkSmartPointer<vtkPolyData> data;
    std::size_t triangles = 0;
    std::vector<SurfaceBrick> bare; ///< where bare part was left out, some of them more than once
};

/// What the worker hands over.
struct SurfaceDelivery {
    std::uint64_t volume = 0;           ///< counts volumes: with another one, all groups are new
    Grid grid;                          ///< the volume's; of no meaning without groups
    std::vector<glm::dvec3> groups;     ///< centre of each group, mm
    std::vector<SurfaceUpdate> updates; ///< at most one a group and layer
    std::optional<CutTime> cut;         ///< the oldest of the cuts that the updates show for the first time
};

/// Meshes a workpiece on a thread of its own: at once, and after every change, so that it can be drawn while things
/// move; groups in which nothing has changed for a moment, at full detail. Only changed tiles are made anew. Where
/// the limit for things that move leaves room and time allows, changed tiles are made in full at once. Holds two
/// snapshots at most: the one that is meshed and the newest.
class WorkpieceMesher {
public:
    /// Triangles in all that a layer is brought down to, by coarser details if need be.
    struct Limits {
        std::size_t moving = 0, rest = 0;
    };

    /// @param ready called on the worker's thread after each delivery
    WorkpieceMesher(const Limits& limits, std::function<void()> ready);
    /// Waits for the tile that is being made.
    ~WorkpieceMesher();
    WorkpieceMesher(const WorkpieceMesher&) = delete;
    WorkpieceMesher& operator=(const WorkpieceMesher&) = delete;

    // ---- Any thread; none of these waits for meshing.

    /// @param workpiece empty: nothing is to be shown
    void show(const VolumeSnapshot& workpiece, std::optional<CutTime> oldestCut);
    void setPartColour(const RgbColour& colour);
    /// By what is left on the part, instead of by material; nothing: by material.
    void setExcess(std::optional<ExcessColours> left);
    /// Whether the part's own mesh is drawn as well: bare part is left out then.
    void setPartDrawn(bool drawn);
    /// Groups near this place come first, mm.
    void setFocus(const glm::dvec3& focus);
    SurfaceDelivery take();
    /// Whether a delivery is to come.
    bool busy() const { return busy_.load(std::memory_order_acquire); }

private:
    /// The tiles of one layer.
    struct Layer {
        std::size_t step = 0; ///< on the ladder of details
        std::vector<SurfaceMesh> tiles;
        std::vector<std::vector<SurfaceBrick>> bare; ///< by tile: where bare part is to be left out
        BareRims rims;
        std::vector<std::uint8_t> staleTiles, staleGroups;
        std::vector<std::size_t> triangles; ///< by group
        void start(const WorkpieceGroups& groups);
        void markAll();
        bool hasStale() const;
        std::size_t staleCount() const;
        std::size_t triangleCount() const;
        bool tooMany(std::size_t limit) const { return triangleCount() > limit; }
    };
    using Moment = std::chrono::steady_clock::time_point;

    void run(const std::stop_token& stop);
    void waitForWork();
    bool interrupted();
    void takeNewest();
    void startVolume();
    void markChanges(const VolumeSnapshot& before);
    void refreshMoving();
    bool refreshMovingTiles(std::size_t group, bool mayStop, bool inFull);
    void refreshRest();
    bool refreshTiles(SurfaceLayer which, std::size_t group);
    void makeTile(SurfaceLayer which, SurfaceTile tile);
    std::vector<RgbColour> coloursOf(SurfaceMesh& mesh, const ExcessDetail& detail) const;
    SurfaceUpdate makeGroup(SurfaceLayer which, std::size_t group, bool mixed);
    bool fullFitsInTime();
    bool roomForFull();
    void settleMoving();
    void settleRest();
    void coarsen(SurfaceLayer which);
    void deliver(std::vector<SurfaceUpdate> updates);
    void deliverCut();
    std::size_t nearestStale(const Layer& layer, Moment changedBefore);
    Layer& layer(SurfaceLayer which) { return layers_[static_cast<std::size_t>(which)]; }
    SurfaceDetail detail(SurfaceLayer which);

    const Limits limits_;
    const std::function<void()> ready_;

    std::mutex mutex_; ///< guards the next eleven
    std::condition_variable_any wake_;
    bool newestWaits_ = false, recolour_ = false, remesh_ = false;
    VolumeSnapshot newest_;
    std::optional<CutTime> newestCut_;
    RgbColour partColour_ = barePartColour;
    std::optional<ExcessColours> wantedExcess_;
    bool partDrawn_ = false;
    glm::dvec3 focus_{0.0};
    SurfaceDelivery delivery_;
    std::atomic<bool> busy_ = false;

    // The worker's own.
    std::stop_token stop_;
    VolumeSnapshot shown_;
    std::optional<CutTime> cut_; ///< in what is shown, not delivered yet
    RgbColour colour_ = barePartColour;
    std::optional<ExcessColours> left_;
    bool withoutPart_ = false; ///< bare part is left out
    WorkpieceGroups groups_;
    std::array<Layer, 2> layers_;
    std::vector<Moment> changed_;  ///< when each group changed last
    bool fullFits_ = false;        ///< there is room for full detail where a tool cuts, in what is drawn while it does
    double fullTileSeconds_ = 0.0; ///< that a tile at full detail takes, running mean
    SurfaceExtractor extractor_;
    StockSharpening sharpening_;
    BareBorder border_;
    SurfaceSimplifier simplifier_;
    SurfaceMesh joined_;

    std::jthread thread_; ///< last, so that it ends first
};

} // namespace burin
