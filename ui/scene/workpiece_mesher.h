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

/// A group of tiles meshed by the worker.
struct SurfaceUpdate {
    std::size_t group = 0;
    SurfaceLayer layer = SurfaceLayer::moving; ///< `moving` makes the group's `rest` surface outdated
    vtkSmartPointer<vtkPolyData> data;
    std::size_t triangles = 0;
    std::vector<SurfaceBrick> bare; ///< where bare part was left out; may contain duplicates
};

/// A delivery of the worker.
struct SurfaceDelivery {
    std::uint64_t volume = 0;           ///< number of the volume: when it changes, all groups are new
    Grid grid;                          ///< grid of the volume; meaningless without groups
    std::vector<glm::dvec3> groups;     ///< centre of each group, mm
    std::vector<SurfaceUpdate> updates; ///< at most one per group and layer
    std::optional<CutTime> cut;         ///< time of the oldest cut that the updates show for the first time
};

/// Meshes a workpiece on a separate thread: coarsely at once and after every change, so that it can be drawn while
/// things move; and at full detail for groups in which nothing has changed for a moment. Only changed tiles are meshed
/// again. If the triangle limit for moving scenes and the time allow, changed tiles are meshed at full detail at once.
/// Holds at most two snapshots: the one being meshed and the newest.
class WorkpieceMesher {
public:
    /// The maximum total number of triangles of each layer; coarser detail is used if necessary.
    struct Limits {
        std::size_t moving = 0, rest = 0;
    };

    /// @param ready called on the worker's thread after each delivery
    WorkpieceMesher(const Limits& limits, std::function<void()> ready);
    /// Waits for the tile that is being meshed.
    ~WorkpieceMesher();
    WorkpieceMesher(const WorkpieceMesher&) = delete;
    WorkpieceMesher& operator=(const WorkpieceMesher&) = delete;

    // ---- Any thread; none of these waits for meshing.

    /// @param workpiece empty: nothing is shown
    void show(const VolumeSnapshot& workpiece, std::optional<CutTime> oldestCut);
    void setPartColour(const RgbColour& colour);
    /// Colours the surface by the stock left on the part; std::nullopt: by material.
    void setExcess(std::optional<ExcessColours> left);
    /// Whether the part's own mesh is drawn as well: bare part is then left out.
    void setPartDrawn(bool drawn);
    /// Groups near this point are meshed first, mm.
    void setFocus(const glm::dvec3& focus);
    SurfaceDelivery take();
    /// Whether a delivery is pending.
    bool busy() const { return busy_.load(std::memory_order_acquire); }

private:
    /// The tiles of one layer.
    struct Layer {
        std::size_t step = 0; ///< index in the sequence of details
        std::vector<SurfaceMesh> tiles;
        std::vector<std::vector<SurfaceBrick>> bare; ///< by tile: where bare part must be left out
        BareRims rims;
        std::vector<std::uint8_t> staleTiles, staleGroups;
        std::vector<std::size_t> triangles; ///< by group
        std::vector<ExcessMemory> excess;   ///< by group
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
    std::vector<RgbColour> coloursOf(SurfaceMesh& mesh, const ExcessDetail& detail, ExcessMemory& memory) const;
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

    std::mutex mutex_; ///< guards the next eleven members
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

    // Used only by the worker thread.
    std::stop_token stop_;
    VolumeSnapshot shown_;
    std::optional<CutTime> cut_; ///< in the snapshot that is shown, not delivered yet
    RgbColour colour_ = barePartColour;
    std::optional<ExcessColours> left_;
    bool withoutPart_ = false; ///< whether bare part is left out
    WorkpieceGroups groups_;
    std::array<Layer, 2> layers_;
    std::vector<Moment> changed_;  ///< when each group changed last
    bool fullFits_ = false;        ///< whether the moving layer has room for full detail where a tool cuts
    double fullTileSeconds_ = 0.0; ///< time to mesh a tile at full detail, running mean
    SurfaceExtractor extractor_;
    StockSharpening sharpening_;
    BareBorder border_;
    SurfaceSimplifier simplifier_;
    SurfaceMesh joined_;

    std::jthread thread_; ///< last member, so that it is destroyed first
};

} // namespace burin
