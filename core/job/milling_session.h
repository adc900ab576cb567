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

/// Mills with a stylus on a thread of its own while others watch: what the window and the command line share.
/// The loop owns the milling context's workpiece until `end`. All functions belong to the owner's thread (the user
/// interface), none takes longer than some ticks and one flush of the disk; the loop waits for undo and redo alone,
/// without force. The spindle turns only while a take is recorded: what is not recorded is not cut, so that the
/// workpiece always is what replaying the takes gives.
class MillingSession final {
public:
    /// Opens the stylus and starts the loop. Project, milling context, stylus and strokes outlive the session, and so
    /// does what the bounds were made from.
    /// @param bounds of the milling context's tool; the tool's axis is theirs.
    /// Errors: those of StylusDevice::open and TraceRecorder::begin; with `takeName` also those of startRecording.
    static Result<std::unique_ptr<MillingSession>> begin(Project& project, MillingContext& milling,
                                                         const ToolBounds& bounds, const StylusHandle& stylus,
                                                         StrokeHistory& strokes, const SessionRequest& request);
    MillingSession(const MillingSession&) = delete;
    MillingSession& operator=(const MillingSession&) = delete;
    ~MillingSession(); ///< as `end`, its outcome unheard

    /// Starts a take: from the next tick on every one is recorded; ticks and time of its samples begin with 0.
    /// Errors: those of Project::setTool and beginTake, argumentInvalid (one is recorded, or the loop has ended).
    Result<void> startRecording(const std::string& name);
    /// Ends the take; all of it is on the disk when this returns. Errors: those of Recorder::finish, argumentInvalid
    /// (none is recorded).
    Result<void> stopRecording();
    /// The take that is recorded, or the last one that was; 0: none.
    std::int64_t take() const noexcept { return take_; }
    /// Takes the newest stroke back, or puts it back: the workpiece at a tick's edge, the recording through a mark in
    /// the project (nothing is erased). A stroke under way ends there first. While the disk notes it the loop stands
    /// without force; afterwards forces fade in. Also after the loop ended. Errors: argumentInvalid (there is none),
    /// those of Project.
    Result<void> undoStroke();
    Result<void> redoStroke();
    /// Without a kick. @param allowance mm, >= 0
    void setAllowance(double allowance);

    /// Switches a fixture, a keep-out volume or the machine's travel, from the next tick on and without a kick: one
    /// that the tool is inside of waits until the tool is clear. @param layer its number in ToolBounds::layers Errors:
    /// argumentInvalid (there is no such layer, or it is the part, which always holds).
    Result<void> setLayer(std::size_t layer, bool on);

    /// From the next tick on, without a kick. Their curves outlive the session. Errors: those of checkGuides.
    Result<void> setGuides(const GuideSettings& guides);
    /// The next level of the guides that hold one; a pass ends. @param levels +1: along their normal
    void stepGuides(int levels) { tell(LevelStep{levels}); }
    /// From the next tick on, without a kick: see Workspace.
    void setWorkspace(const WorkspaceSettings& workspace) { tell(workspace); }

    /// The newest tick. False when there is none since the last call.
    bool newest(SessionState& state);
    /// The workpiece as it is after the next tick, which this waits for (a view that was ordered a frame ahead would be
    /// a frame old). False: none came within some ticks; ask again at the next frame. Once the loop has ended it is the
    /// final state.
    bool newestView(WorkpieceView& view);
    /// Places of the proxy since the last call, for drawing the path as it grows: a tip each tick that was recorded
    /// with the spindle turning, in order; a gap between strokes is told by `strokeBegins`. Who does not ask for a
    /// minute misses some; the stroke begins anew there. @param points replaced
    void takeTrace(std::vector<TracePoint>& points);

    /// The oldest fault that nobody took yet, of the stylus or of the loop that moves it; the session goes on by itself
    /// when it is over. Error::place: the file with its last two seconds, empty where there is none. What a simulated
    /// stylus would not feel is no fault. Motors that have become hot are told as well (deviceHot): the session goes on
    /// with less force.
    std::optional<Error> takeFault();
    /// Of the stylus, whether it is there.
    DeviceHealth health() const { return stylus_.device().health(); }

    /// True when the loop has ended by itself: the stylus finished, or a fault, which `end` then gives.
    bool ended() const noexcept { return ended_.load(std::memory_order_acquire); }
    /// Ends the recording and the loop, and closes the stylus. Errors: those of the recorder and of the trace, the
    /// fault that ended the loop. Again: the same answer.
    Result<LoopStatistics> end();

private:
    MillingSession(Project& project, MillingContext& milling, const ToolBounds& bounds, const StylusHandle& stylus,
                   StrokeHistory& strokes, const SessionRequest& request);
    Result<void> start(const SessionRequest& request);
    Result<void> beginTake(const std::string& name);
    void tell(const StepChange& change);
    void tellWhatWaits();
    bool fulfilled();
    void ask(SessionLoop::Wish wish);
    void settle();
    void collectStrokes();
    void makeRoom(const TickNews& news);
    void noteCut(const WorkpieceView& view);
    Result<void> placeTrace(Result<StagedFile> trace);
    template <class Change>
    Result<void> changeWorkpiece(Change change);

    Project& project_;
    MillingContext& milling_;
    const StylusHandle stylus_;
    StrokeHistory& strokes_;
    double allowance_;
    const AxisMode axis_;
    const std::optional<TracedSession::Growth> growth_;
    const std::size_t layerCount_;
    std::optional<StagedFile>* const traceOutput_;
    const ServoSettings servo_;
    std::atomic<bool> stop_{false}, ended_{false};
    HapticStep step_;
    SessionLoop loop_;
    SessionFaults faults_;
    std::deque<StepChange> untold_; ///< the ring was full: nothing that was wished is lost
    std::optional<ReplayedChanges> replayed_;
    std::unique_ptr<TraceRecorder> trace_;
    std::unique_ptr<Recorder> recorder_;
    std::int64_t take_ = 0;
    LiveFigures figures_;
    std::optional<std::chrono::steady_clock::time_point> unseenCut_;
    std::uint64_t roomMade_ = 0; ///< ticks when the memory's last room was made
    std::optional<Error> diskFault_;
    Result<LoopStatistics> outcome_ = LoopStatistics{}; ///< the loop's until it ended
    bool over_ = false;                                 ///< `end` was called
    std::thread thread_;                                // last: it uses the above
};

} // namespace burin
