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

/// The layers that bound the tool, by bit of their number.
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

/// What the loop tells of its newest tick.
struct TickNews {
    Sample sample;
    TickTiming timing;
    std::uint64_t ticks = 0;
    std::int64_t take = 0;
    double removalRate = 0.0; ///< run units (Grid::unitVolume) a second
    SmoothedCut cut;          ///< as it is now
    SmoothedCut heaviestCut;  ///< of the take
    bool cutting = false;
    ShankContact shank;
    std::array<GuideNews, GuideSettings::capacity> guides{};
    double workspaceScale = 1.0; ///< mm of setup per mm of device
    bool clutched = false;
    LayersNews layers{};
};

/// The loop's side of a session: follows takes and strokes from tick to tick, and does at a tick's edge what its owner
/// requests. Nothing in `edge` and `tick` allocates, waits or frees: what owns memory is handed to the owner.
class SessionLoop final : public TickSink {
public:
    /// A take to record: the recorder reads `samples()`.
    struct Recording {
        std::int64_t take = 0;
        const Recorder* recorder = nullptr;
    };
    enum class Wish : std::uint8_t { none, begin, finish, stand, goOn };

    /// @param step whose spindle stands until a take begins. @param stop set when the recorder fails
    SessionLoop(HapticStep& step, RunVolume& workpiece, bool undoable, std::atomic<bool>& stop);

    // ---- Loop's thread
    AtEdge edge() noexcept override;
    void tick(const Sample& sample, const TickTiming& timing) noexcept override;

    // ---- Owner's thread, at any time
    Ring<Sample>& samples() noexcept { return samples_; }
    /// The loop fulfils a request at one of its next edges; one at a time.
    void wish(Wish what) noexcept { wish_.store(what, std::memory_order_release); }
    void wishTake(const Recording& recording) noexcept;
    /// The last wish is done: what it changed of the workpiece and of the step is visible to the owner.
    bool fulfilled() const noexcept { return wish_.load(std::memory_order_acquire) == Wish::none; }
    /// What the step is told before the next tick, in the order in which it was said here. False, and nothing was
    /// said: too much waits, since the loop stands; ask again later.
    bool tell(const StepChange& change) noexcept { return changes_.push(change); }
    /// Any thread.
    bool strokeUnderWay() const noexcept { return strokeOpen_.load(std::memory_order_acquire); }
    /// False: there is nothing since the last call; what was overtaken is lost.
    bool takeNews(TickNews& news) noexcept { return news_.take(news); }
    bool takeFigures(LiveFigures& figures) noexcept { return figuresOut_.take(figures); }
    /// True once for each time that the device's motors began to be spared.
    bool takeHeat() noexcept { return heated_.exchange(false, std::memory_order_relaxed); }
    /// True once the loop has ended because the recorder failed.
    bool gaveUp() const noexcept { return gaveUp_.load(std::memory_order_relaxed); }
    /// The oldest that has ended. False: there is none. Strokes that nobody takes grow together.
    bool takeStroke(Stroke& stroke) noexcept { return strokes_.take(stroke); }
    std::size_t takeTrace(std::span<TracePoint> points) noexcept { return trace_.pop(points); }
    /// A view of the workpiece is made at one of the next edges; `takeView` gets it, and owns it.
    void wishView() noexcept { viewWish_.store(true, std::memory_order_release); }
    bool takeView(WorkpieceView& view) noexcept { return views_.take(view); }

    // ---- Owner's thread, while the loop stands or after it has ended
    /// As at an edge: what was requested and not fulfilled yet.
    void fulfil() noexcept;
    /// Ends the stroke under way, if there is one. False: too many wait to be taken.
    bool endStroke() noexcept;
    /// Another state of the workpiece was put in place.
    void workpieceChanged() noexcept;
    WorkpieceView finalView() { return view(); }

private:
    bool recording() const noexcept { return recording_.take != 0; }
    void begin() noexcept;
    void takeChanges() noexcept;
    void giveView();
    WorkpieceView view();
    void follow(const Sample& sample, bool cutting) noexcept;
    void noteLayers() noexcept;

    static constexpr std::size_t sampleCapacity = 16384; ///< seconds of ticks that the disk may keep us waiting for
    static constexpr std::size_t traceCapacity = 65536;
    static constexpr std::size_t changeCapacity = 256; ///< what a user may wish for while a slow tick lasts

    HapticStep& step_;
    RunVolume& workpiece_;
    const bool undoable_;
    std::atomic<bool>& stop_;

    std::atomic<Wish> wish_{Wish::none};
    Recording wished_;
    std::atomic<bool> viewWish_{false}, heated_{false}, gaveUp_{false};
    Ring<StepChange> changes_{changeCapacity};

    Ring<Sample> samples_{sampleCapacity};
    Ring<TracePoint> trace_{traceCapacity};
    Handover<Stroke, 8> strokes_;
    Handover<WorkpieceView, 1> views_;
    Mailbox<TickNews> news_;
    Mailbox<LiveFigures> figuresOut_;

    // Loop's alone.
    Recording recording_;
    bool standing_ = false;
    std::uint64_t recorded_ = 0; ///< samples of the take
    /// While no stroke is under way: the workpiece as it is, since only strokes change it.
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
