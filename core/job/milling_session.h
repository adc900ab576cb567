// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/trace/replayed_changes.h"
#include "core/haptics/trace/trace_recorder.h"
#include "core/job/milling_context.h"
#include "core/job/session_faults.h"
#include "core/job/session_loop.h"
#include "core/job/session_request.h"
#include "core/job/session_state.h"
#include "core/job/stroke_history.h"
#include "core/job/tool_bounds.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace burin {

/// Mills with a stylus on a separate thread while its owner displays the state; shared by the window and the command
/// line. The loop owns the milling context's workpiece until `end`. Call all functions on the owner's thread (the user
/// interface); none takes longer than some ticks and one flush of the disk. The loop waits only for undo and redo,
/// without force. The spindle turns only while a take is recorded: nothing is cut without being recorded, so that the
/// workpiece always equals the result of replaying the takes.
class MillingSession final {
public:
    /// Opens the stylus and starts the loop. Project, milling context, stylus and strokes must outlive the session, and
    /// so must the data that the bounds were made from.
    /// @param bounds of the milling context's tool; they also define the tool axis.
    /// Errors: those of StylusDevice::open and TraceRecorder::begin; with `takeName` also those of startRecording.
    static Result<std::unique_ptr<MillingSession>> begin(Project& project, MillingContext& milling,
                                                         const ToolBounds& bounds, const StylusHandle& stylus,
                                                         StrokeHistory& strokes, const SessionRequest& request);
    MillingSession(const MillingSession&) = delete;
    MillingSession& operator=(const MillingSession&) = delete;
    ~MillingSession(); ///< as `end`; its result is discarded

    /// Starts a take: the stock's layer is switched off, and every tick from the next one on is recorded; ticks and
    /// time of its samples begin with 0. Errors: those of Project::setTool and beginTake, argumentInvalid (a take is
    /// being recorded, or the loop has ended).
    Result<void> startRecording(const std::string& name);
    /// Ends the take; all of it is on the disk when this returns. Errors: those of Recorder::finish, argumentInvalid
    /// (no take is being recorded).
    Result<void> stopRecording();
    /// Returns the take that is being recorded, or the last one that was; 0: none.
    std::int64_t take() const noexcept { return take_; }
    /// Undoes or redoes the newest stroke: changes the workpiece between two ticks, and marks the recording in the
    /// project (nothing is erased). A stroke in progress is ended first. While the mark is written to the disk, the
    /// loop is paused without force; afterwards forces fade in. Also works after the loop has ended. Errors:
    /// argumentInvalid (there is no such stroke), those of Project.
    Result<void> undoStroke();
    Result<void> redoStroke();
    /// Changes the allowance without a jump in force. @param allowance mm, >= 0
    void setAllowance(double allowance);

    /// Switches a fixture, a keep-out volume or the machine's travel on or off, from the next tick on and without a
    /// jump in force: a layer that the tool is inside of takes effect once the tool has left it. @param layer its
    /// number in ToolBounds::layers Errors: argumentInvalid (there is no such layer, or it is the part, which is always
    /// on; the stock during a recording: a tool that it holds could not cut it).
    Result<void> setLayer(std::size_t layer, bool on);

    /// Switches the layer that keeps shank and holder away from the stock (SessionRequest::stock), like `setLayer`.
    /// Errors: argumentInvalid (the session has no such layer).
    Result<void> setStockLayer(bool on);

    /// Takes effect from the next tick on, without a jump in force. The guides' curves must outlive the session.
    /// Errors: those of checkGuides.
    Result<void> setGuides(const GuideSettings& guides);
    /// Moves the guides that hold a level to the next one; ends a pass. @param levels +1: along their normal
    void stepGuides(int levels) { tell(LevelStep{levels}); }
    /// Takes effect from the next tick on, without a jump in force: see Workspace.
    void setWorkspace(const WorkspaceSettings& workspace) { tell(workspace); }

    /// Undoes or redoes a stroke where the played trace (SessionRequest::replayed) has done so. Call often: the loop
    /// waits for it. Errors: traceInvalid (a stroke from before the trace), those of undoStroke and redoStroke.
    Result<void> followTrace();

    /// Gets the newest tick. Returns false if there was none since the last call.
    bool newest(SessionState& state);
    /// Gets the workpiece after the next tick, for which this waits (a view requested one frame ahead would be one
    /// frame old). Returns false if none came within some ticks; ask again at the next frame. After the loop has ended,
    /// the view is the final state.
    bool newestView(WorkpieceView& view);
    /// Gets the positions of the proxy since the last call, for drawing the path as it grows: one tip for each tick
    /// that was recorded with the spindle turning, in order; `strokeBegins` marks a gap between strokes. If this is not
    /// called for a minute, some points are lost, and the stroke begins anew there. @param points replaced
    void takeTrace(std::vector<TracePoint>& points);

    /// Returns the oldest fault that was not taken yet, of the stylus or of the loop that drives it; the session
    /// continues by itself when the fault is over. Error::place: the file with its last two seconds, empty if there is
    /// none. A simulated stylus reports no faults that it would not feel. Hot motors are reported as well (deviceHot):
    /// the session continues with less force.
    std::optional<Error> takeFault();
    /// Returns the health of the stylus, including whether it is connected.
    DeviceHealth health() const { return stylus_.device().health(); }

    /// Whether the loop has ended by itself: the stylus finished, or a fault occurred, which `end` then returns.
    bool ended() const noexcept { return ended_.load(std::memory_order_acquire); }
    /// Ends the recording and the loop, and closes the stylus. Errors: those of the recorder and of the trace, the
    /// fault that ended the loop. Further calls return the same result.
    Result<LoopStatistics> end();

private:
    MillingSession(Project& project, MillingContext& milling, const ToolBounds& bounds, const StylusHandle& stylus,
                   StrokeHistory& strokes, const SessionRequest& request);
    Result<void> start(const ToolBounds& bounds, const SessionRequest& request);
    Result<void> beginTrace(const ToolBounds& bounds, const SessionRequest& request, TickSink& next);
    std::optional<Error> takeTraceFault();
    Result<void> beginTake(const std::string& name);
    void tell(const StepChange& change);
    void tellWhatWaits();
    bool fulfilled();
    void ask(SessionLoop::Request request);
    void settle();
    void collectStrokes();
    void makeRoom(const TickNews& news);
    void noteCut(const WorkpieceView& view);
    Result<void> placeTrace(Result<StagedFile> trace);
    Result<void> changeWorkpiece(const WorkpieceChange& change);
    Result<void> applyToWorkpiece(const WorkpieceChange& change);

    Project& project_;
    MillingContext& milling_;
    const StylusHandle stylus_;
    StrokeHistory& strokes_;
    double allowance_;
    const AxisMode axis_;
    const std::size_t layerCount_; ///< without that of the stock, which is the next one
    const StockLayer stock_;
    const std::optional<std::size_t> stockLayer_;
    std::optional<StagedFile>* const traceOutput_;
    const bool traceRequired_;
    const ServoSettings servo_;
    std::atomic<bool> stop_{false}, ended_{false};
    HapticStep step_;
    SessionLoop loop_;
    SessionFaults faults_;
    std::deque<StepChange> untold_; ///< requests that found the ring full; none is lost
    std::optional<ReplayedChanges> replayed_;
    std::unique_ptr<TraceRecorder> trace_;
    std::optional<Error> traceFault_; ///< of the beginning of a trace, not yet taken
    bool traceEnded_ = false;         ///< its fault was reported
    std::unique_ptr<Recorder> recorder_;
    std::int64_t take_ = 0;
    LiveFigures figures_;
    std::optional<std::chrono::steady_clock::time_point> unseenCut_;
    std::uint64_t roomMade_ = 0; ///< tick count when memory was last freed
    std::optional<Error> diskFault_;
    Result<LoopStatistics> outcome_ = LoopStatistics{}; ///< owned by the loop until it has ended
    bool over_ = false;                                 ///< `end` was called
    std::thread thread_;                                // last: it uses the above
};

} // namespace burin
