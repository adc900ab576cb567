// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/handover.h"
#include "core/base/mailbox.h"
#include "core/haptics/haptic_step.h"
#include "core/haptics/loop/loop_figures.h"
#include "core/job/recent_cut.h"
#include "core/job/recorder.h"
#include "core/job/removal_rate.h"
#include "core/job/session_state.h"
#include "core/job/stroke_history.h"
#include "core/job/tool_bounds.h"

#include <atomic>

namespace burin {

/// The state of the layers that bound the tool, one bit per layer number.
struct LayersNews {
    std::uint64_t on = 0;                                        ///< in force, or waiting
    std::uint64_t force = 0;                                     ///< in force
    std::uint64_t held = 0;                                      ///< held the tool in this tick
    std::array<std::uint64_t, ToolBounds::capacity> ticksHeld{}; ///< of the take

    /// @param layer below 64
    static bool has(std::uint64_t bits, std::size_t layer) noexcept { return (bits >> layer & 1) != 0; }
    bool holds(std::size_t layer) const noexcept { return has(held, layer); }
    BoundaryLayers::State state(std::size_t layer) const noexcept {
        using State = BoundaryLayers::State;
        return has(force, layer) ? State::inForce : has(on, layer) ? State::waiting : State::off;
    }
};

/// The loop's report of its newest tick.
struct TickNews {
    Sample sample;
    TickTiming timing;
    std::uint64_t ticks = 0;
    std::int64_t take = 0;
    double removalRate = 0.0; ///< run units (Grid::unitVolume) per second
    SmoothedCut cut;          ///< at present
    SmoothedCut heaviestCut;  ///< of the take
    bool cutting = false;
    ShankContact shank;
    std::array<GuideNews, GuideSettings::capacity> guides{};
    double workspaceScale = 1.0; ///< mm of setup per mm of device
    bool clutched = false;
    LayersNews layers{};
};

/// The loop's side of a session: follows takes and strokes from tick to tick, and carries out its owner's requests
/// between ticks. `edge` and `tick` do not allocate, block or free memory: objects that own memory are passed to the
/// owner.
class SessionLoop final : public TickSink {
public:
    /// A take to record: the recorder reads `samples()`.
    struct Recording {
        std::int64_t take = 0;
        const Recorder* recorder = nullptr;
    };
    enum class Request : std::uint8_t { none, begin, finish, stand, goOn };

    /// @param step its spindle stays off until a take begins. @param stop set when the recorder fails
    /// @param waits whether the loop waits for its owner to take ended strokes: only in simulated time
    SessionLoop(HapticStep& step, RunVolume& workpiece, bool undoable, std::atomic<bool>& stop, bool waits = false);

    // ---- Loop's thread
    AtEdge edge() noexcept override;
    void tick(const Sample& sample, const TickTiming& timing) noexcept override;

    // ---- Owner's thread, at any time
    Ring<Sample>& samples() noexcept { return samples_; }
    /// Makes a request, which the loop fulfils at one of its next edges; one at a time.
    void request(Request what) noexcept { request_.store(what, std::memory_order_release); }
    void requestTake(const Recording& recording) noexcept;
    /// Whether the last request is fulfilled: its changes to the workpiece and the step are then visible to the owner.
    bool fulfilled() const noexcept { return request_.load(std::memory_order_acquire) == Request::none; }
    /// Queues a change for the step before the next tick; changes are applied in order. Returns false, and queues
    /// nothing, if the queue is full because the loop is paused; try again later.
    bool tell(const StepChange& change) noexcept { return changes_.push(change); }
    /// Thread-safe.
    bool strokeUnderWay() const noexcept { return strokeOpen_.load(std::memory_order_acquire); }
    /// Gets the newest report. Returns false if there was none since the last call; overtaken reports are lost.
    bool takeNews(TickNews& news) noexcept { return news_.take(news); }
    bool takeFigures(LiveFigures& figures) noexcept { return figuresOut_.take(figures); }
    /// Returns true once for each time that the force was reduced to spare the device's motors.
    bool takeHeat() noexcept { return heated_.exchange(false, std::memory_order_relaxed); }
    /// Whether the loop has ended because the recorder failed.
    bool gaveUp() const noexcept { return gaveUp_.load(std::memory_order_relaxed); }
    /// Gets the oldest ended stroke. Returns false if there is none. Strokes that are not taken are merged.
    bool takeStroke(Stroke& stroke) noexcept { return strokes_.take(stroke); }
    std::size_t takeTrace(std::span<TracePoint> points) noexcept { return trace_.pop(points); }
    /// Requests a view of the workpiece, which is made at one of the next edges; `takeView` gets it, with ownership.
    void requestView() noexcept { viewRequest_.store(true, std::memory_order_release); }
    bool takeView(WorkpieceView& view) noexcept { return views_.take(view); }

    // ---- Owner's thread, while the loop is paused or after it has ended
    /// Fulfils a pending request, as at an edge.
    void fulfil() noexcept;
    /// Ends the stroke in progress, if there is one. Returns false if too many strokes wait to be taken.
    bool endStroke() noexcept;
    /// Call after the workpiece was set to another state.
    void workpieceChanged(const WorkpieceChange& change) noexcept;
    WorkpieceView finalView() { return view(); }

private:
    bool recording() const noexcept { return recording_.take != 0; }
    void begin() noexcept;
    void takeChanges() noexcept;
    void giveView();
    WorkpieceView view();
    void follow(const Sample& sample, bool cutting) noexcept;
    void noteLayers() noexcept;

    static constexpr std::size_t sampleCapacity = 16384; ///< several seconds of ticks, to bridge delays of the disk
    static constexpr std::size_t traceCapacity = 65536;
    static constexpr std::size_t changeCapacity = 256; ///< what a user can request during a slow tick

    HapticStep& step_;
    RunVolume& workpiece_;
    const bool undoable_, waits_;
    std::atomic<bool>& stop_;

    std::atomic<Request> request_{Request::none};
    Recording requested_;
    std::atomic<bool> viewRequest_{false}, heated_{false}, gaveUp_{false};
    Ring<StepChange> changes_{changeCapacity};

    Ring<Sample> samples_{sampleCapacity};
    Ring<TracePoint> trace_{traceCapacity};
    Handover<Stroke, 8> strokes_;
    Handover<WorkpieceView, 1> views_;
    Mailbox<TickNews> news_;
    Mailbox<LiveFigures> figuresOut_;

    // Used only by the loop.
    Recording recording_;
    bool standing_ = false;
    std::uint64_t recorded_ = 0; ///< samples of the take
    /// While no stroke is in progress: the present workpiece, since only strokes change it.
    VolumeSnapshot before_;
    std::atomic<bool> strokeOpen_{false};
    std::uint64_t strokeFirst_ = 0;
    bool traceBegins_ = true;
    std::int64_t oldestCut_ = 0; ///< ns; 0: none
    bool hot_ = false;           ///< in the newest tick
    std::uint64_t ticks_ = 0;
    RemovalRate rate_;
    RecentCut recentCut_;
    LayersNews layers_;
    LoopFigures figures_;
};

} // namespace burin
