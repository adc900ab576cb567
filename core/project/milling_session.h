// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/staged_file.h"
#include "core/device/stylus_handle.h"
#include "core/haptics/guide.h"
#include "core/haptics/haptic_settings.h"
#include "core/haptics/servo_loop.h"
#include "core/haptics/session_trace.h"
#include "core/haptics/workspace.h"
#include "core/project/bench.h"
#include "core/project/bench_boundaries.h"
#include "core/project/stroke_history.h"
#include "core/recording/sample.h"

#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// What became of a layer that bounds the tool, for whoever shows it.
struct LayerNews {
    BoundaryLayers::State state = BoundaryLayers::State::off;
    bool holds = false;          ///< it holds the tool back just now
    std::uint64_t ticksHeld = 0; ///< ticks of the take in which it held the tool
};

/// What there is to see of a session: its newest tick, and figures over the last second.
struct SessionState {
    Sample sample;
    std::chrono::steady_clock::time_point wallTime{}; ///< when the tick was over
    bool recording = false;
    std::int64_t take = 0;        ///< that is recorded; 0: none
    double recordedSeconds = 0.0; ///< of this take
    bool cutting = false;         ///< the spindle turns (mouse: its button is down)
    double rateHz = 0.0;          ///< that was really reached, over the last second
    double cpuP999 = 0.0;         ///< µs of thread CPU time a tick, over the session
    double workP999 = 0.0;        ///< µs of wall time a tick, over the session
    double intervalP999 = 0.0;    ///< µs from force to force, over the session
    std::uint64_t ticks = 0;
    std::uint64_t missed = 0; ///< edges of the clock that were skipped since the session began
    std::uint64_t late = 0;   ///< ticks whose force was withheld, as it came too late
    SchedulingClass scheduling = SchedulingClass::normal;
    double removalRate = 0.0;     ///< mm³/s, mean of the last 100 ms
    std::uint32_t shankPiece = 0; ///< place in pieces(cutter) of what touches; meaningful with sampleShankContact
    PropertyIndex shankTouches = airProperty; ///< what it touches
    std::array<GuideNews, GuideSettings::capacity> guides{};
    std::vector<LayerNews> layers; ///< by the number that ToolBounds::layers gives
    double workspaceScale = 1.0;   ///< mm of setup per mm of device
    bool clutched = false;         ///< the hand moves, the tool stays
};

/// A workpiece at a moment, for drawing.
struct WorkpieceView {
    VolumeSnapshot workpiece;
    /// When the oldest cut that the view before did not show was made; nothing when nothing was cut.
    std::optional<std::chrono::steady_clock::time_point> oldestCut;
};

struct SessionRequest {
    double allowance = 0.0; ///< mm of stock that the boundary leaves on the part
    WorkspaceMapping mapping;
    Pace pace = Pace::realtime;
    int ticksPerEdge = 1;      ///< time lapse: so many ticks at each edge of the clock; virtual operators only
    bool cutsOnButton = false; ///< the spindle turns only while the stylus' first button is down
    FeltCutting felt;
    std::uint32_t forceButtons = 0; ///< dead man's: forces only while one of these is held, by bit; 0: always
    /// Keeps the workpiece as each stroke found it, so that it can be taken back. That holds back memory of the volume:
    /// when it runs out, the older half of the strokes stays for good.
    bool undoable = true;
    double period = 0.0; ///< s of a tick; 0: the stylus' own rate where it has one that it paces itself, or 1 kHz
    std::filesystem::path trace; ///< of ticks, written while the session lasts; empty: none
    /// Gets the complete trace with `end`, to be put in its place together with the project. Null: it is put there.
    std::optional<StagedFile>* traceOutput = nullptr;
    /// What a trace that is played was told between its ticks is told again; outlives the session. Null: nothing.
    const SessionTrace* replayed = nullptr;
    std::filesystem::path flights; ///< folder for records of faults (FlightRecorder); empty: beside the project
    std::string takeName;          ///< of a take that begins with the very first tick; empty: none does
    double maximumSeconds = std::numeric_limits<double>::infinity(); ///< of the session's time
};

/// Mills with a stylus on a thread of its own while others watch: what the window and the command line share.
/// The loop owns the bench's workpiece until `end`. All functions belong to the owner's thread (the user interface),
/// none takes longer than some ticks and one flush of the disk; the loop waits for undo and redo alone, without force.
/// The spindle turns only while a take is recorded: what is not recorded is not cut, so that the workpiece always is
/// what replaying the takes gives.
class MillingSession {
public:
    /// Opens the stylus and starts the loop. Project, bench, stylus and strokes outlive the session, and so does what
    /// the bounds were made from.
    /// @param bounds of the bench's tool; the tool's axis is theirs. A ClearanceField will do: the part alone, +Z.
    /// Errors: those of StylusDevice::open and TraceRecorder::begin; with `takeName` also those of startRecording.
    static Result<std::unique_ptr<MillingSession>> begin(Project& project, Bench& bench, const ToolBounds& bounds,
                                                         const StylusHandle& stylus, StrokeHistory& strokes,
                                                         const SessionRequest& request);
    virtual ~MillingSession(); ///< as `end`, its outcome unheard

    /// Starts a take: from the next tick on every one is recorded; ticks and time of its samples begin with 0.
    /// Errors: those of Project::setTool and beginTake, argumentInvalid (one is recorded, or the loop has ended).
    virtual Result<void> startRecording(const std::string& name) = 0;
    /// Ends the take; all of it is on the disk when this returns. Errors: those of Recorder::finish, argumentInvalid
    /// (none is recorded).
    virtual Result<void> stopRecording() = 0;
    /// The take that is recorded, or the last one that was; 0: none.
    virtual std::int64_t take() const = 0;
    /// Takes the newest stroke back, or puts it back: the workpiece at a tick's edge, the recording through a mark in
    /// the project (nothing is erased). A stroke under way ends there first. While the disk notes it the loop stands
    /// without force; afterwards forces fade in. Also after the loop ended. Errors: argumentInvalid (there is none),
    /// those of Project.
    virtual Result<void> undoStroke() = 0;
    virtual Result<void> redoStroke() = 0;
    /// Without a kick. @param allowance mm, >= 0
    virtual void setAllowance(double allowance) = 0;

    /// Switches a fixture, a keep-out volume or the machine's travel, from the next tick on and without a kick: one
    /// that the tool is inside of waits until the tool is clear. @param layer its number in ToolBounds::layers Errors:
    /// argumentInvalid (there is no such layer, or it is the part, which always holds).
    virtual Result<void> setLayer(std::size_t layer, bool on) = 0;

    /// From the next tick on, without a kick. Their curves outlive the session. Errors: those of checkGuides.
    virtual Result<void> setGuides(const GuideSettings& guides) = 0;
    /// The next level of the guides that hold one; a pass ends. @param levels +1: along their normal
    virtual void stepGuides(int levels) = 0;
    /// From the next tick on, without a kick: see Workspace.
    virtual void setWorkspace(const WorkspaceSettings& workspace) = 0;

    /// The newest tick. False when there is none since the last call.
    virtual bool newest(SessionState& state) = 0;
    /// The workpiece as it is after the next tick, which this waits for (a view that was ordered a frame ahead would be
    /// a frame old). False: none came within some ticks; ask again at the next frame. Once the loop has ended it is the
    /// final state.
    virtual bool newestView(WorkpieceView& view) = 0;
    /// Places of the proxy since the last call, for drawing the path as it grows: a tip each tick that was recorded
    /// with the spindle turning, in order; a gap between strokes is told by `strokeBegins`. Who does not ask for a
    /// minute misses some; the stroke begins anew there. @param points replaced
    struct TracePoint {
        glm::vec3 tip{0.0F};
        bool strokeBegins = false;
    };
    virtual void takeTrace(std::vector<TracePoint>& points) = 0;

    /// The oldest fault that nobody took yet, of the stylus or of the loop that moves it; the session goes on by itself
    /// when it is over. Error::place: the file with its last two seconds, empty where there is none. What a simulated
    /// stylus would not feel is no fault. Motors that have become hot are told as well (deviceHot): the session goes on
    /// with less force.
    virtual std::optional<Error> takeFault() = 0;
    /// Of the stylus, whether it is there.
    virtual DeviceHealth health() const = 0;

    /// True when the loop has ended by itself: the stylus finished, or a fault, which `end` then gives.
    virtual bool ended() const = 0;
    /// Ends the recording and the loop, and closes the stylus. Errors: those of the recorder and of the trace, the
    /// fault that ended the loop. Again: the same answer.
    virtual Result<LoopStatistics> end() = 0;
};

} // namespace burin
