// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/milling_session.h"

#include "core/base/wall_clock.h"
#include "core/job/session_settings.h"
#include "core/job/traced_bounds.h"
#include "core/setup/material_change.h"

#include <algorithm>
#include <array>
#include <utility>

namespace burin {

namespace {

using Clock = std::chrono::steady_clock;
using Request = SessionLoop::Request;

/// How long the owner waits for a view; a view takes one tick, unless the loop is paused.
constexpr std::chrono::milliseconds viewPatience{3};
/// Interval for polling the loop: a fraction of a tick.
constexpr std::chrono::microseconds sessionGlance{200};

Error nothingToDo(const char* what, const char* needed) {
    return {ErrorCode::argumentInvalid, what, {}, needed};
}

std::optional<std::size_t> stockLayerOf(const ToolBounds& bounds) {
    const auto stock = std::ranges::find(bounds.layers(), BoundLayer::Kind::stock, &BoundLayer::kind);
    if (stock == bounds.layers().end()) return std::nullopt;
    return static_cast<std::size_t>(stock - bounds.layers().begin());
}

} // namespace

MillingSession::MillingSession(Project& project, MillingContext& milling, const ToolBounds& bounds,
                               const StylusHandle& stylus, StrokeHistory& strokes, const SessionRequest& request)
    : project_(project)
    , milling_(milling)
    , stylus_(stylus)
    , strokes_(strokes)
    , allowance_(request.allowance)
    , axis_(bounds.axis())
    , layerCount_(bounds.layers().size())
    , stock_(request.stock)
    , stockLayer_(stockLayerOf(bounds))
    , traceOutput_(request.traceOutput)
    , traceRequired_(request.traceRequired)
    , servo_(servoSettings(stylus, request))
    , step_(milling.embedded.workpiece, bounds.boundaryLayers(), milling.tool,
            hapticSettings(milling, bounds.axis(), stylus, request))
    , loop_(step_, milling.embedded.workpiece, request.undoable, stop_,
            request.undoable && request.pace == Pace::fast && request.replayed != nullptr)
    , faults_(stylus.device(), servo_.period, flightFolder(project, request),
              idsOf(milling.embedded.workpiece.properties()), loop_) {}

MillingSession::~MillingSession() {
    static_cast<void>(end());
}

/// Errors: those of TraceRecorder::begin, if the trace is required.
Result<void> MillingSession::beginTrace(const ToolBounds& bounds, const SessionRequest& request, TickSink& next) {
    using IfFull = TraceRecorder::IfFull;
    TracedSession began;
    began.stylus = stylus_.device().description();
    began.mapping = request.mapping;
    began.allowance = request.allowance;
    began.period = servo_.period;
    began.cutsOnButton = request.cutsOnButton;
    began.forceButtons = request.forceButtons;
    began.felt = request.felt;
    began.axis = axis_;
    began.growth = bounds.growth();
    began.stock = request.stock;
    began.gains = request.gains;
    began.tool = milling_.tool.id;
    began.layers = tracedLayers(bounds);
    Result<std::unique_ptr<TraceRecorder>> trace =
        TraceRecorder::begin(request.trace, next, began, request.traceRequired ? IfFull::endsLoop : IfFull::endsTrace);
    if (!trace && request.traceRequired) return std::move(trace).error();
    if (trace)
        trace_ = std::move(*trace);
    else
        traceFault_ = traceEnded(trace.error());
    return {};
}

/// Errors: those of startRecording, checkGuides and TraceRecorder::begin.
Result<void> MillingSession::start(const ToolBounds& bounds, const SessionRequest& request) {
    TickSink* sink = &faults_.sink();
    if (request.replayed != nullptr) {
        replayed_.emplace(*request.replayed, step_, *sink);
        sink = &*replayed_;
    }
    if (!request.trace.empty()) {
        if (Result<void> begun = beginTrace(bounds, request, *sink); !begun) return begun;
    }
    if (trace_) {
        step_.listen(trace_.get());
        sink = trace_.get();
    }
    if (!request.takeName.empty())
        if (Result<void> begun = beginTake(request.takeName); !begun) {
            step_.listen(nullptr);
            trace_.reset(); // it recorded nothing
            return begun;
        }
    if (request.guides)
        if (Result<void> held = setGuides(*request.guides); !held) return held;
    thread_ = std::thread([this, sink] {
        ServoSettings servo = servo_;
        servo.alarm = faults_.alarm();
        outcome_ = runServoLoop(stylus_, step_, *sink, servo, stop_);
        ended_.store(true, std::memory_order_release);
    });
    return {};
}

/// Waits until the loop has fulfilled the request. Returns false if the loop ended before.
bool MillingSession::fulfilled() {
    while (!loop_.fulfilled()) {
        if (ended()) {
            settle();
            return false;
        }
        collectStrokes();
        std::this_thread::sleep_for(sessionGlance);
    }
    return true;
}

/// Makes a request after any previous one is fulfilled; when this returns, the request is fulfilled.
void MillingSession::ask(Request request) {
    fulfilled();
    loop_.request(request);
    fulfilled();
}

/// After the loop has ended, all of its data belongs to the owner.
void MillingSession::settle() {
    if (!ended() && thread_.joinable()) return;
    if (thread_.joinable()) thread_.join();
    collectStrokes();
    loop_.fulfil();
    collectStrokes();
}

void MillingSession::collectStrokes() {
    for (Stroke stroke; loop_.takeStroke(stroke);) strokes_.add(std::move(stroke));
}

Result<void> MillingSession::startRecording(const std::string& name) {
    if (recorder_) return nothingToDo("recording", "one that ended");
    if (ended()) return nothingToDo("session", "one that has not ended");
    if (Result<void> begun = beginTake(name); !begun) return begun;
    if (fulfilled()) return {};
    static_cast<void>(stopRecording());
    return nothingToDo("session", "one that has not ended");
}

Result<void> MillingSession::beginTake(const std::string& name) {
    if (stockLayer_) tell(LayerSwitch{*stockLayer_, false});
    if (Result<void> kept = project_.setTool(milling_.tool); !kept) return kept;
    TakeInfo info;
    info.name = name;
    info.toolId = milling_.tool.id;
    info.allowance = allowance_;
    info.tickPeriod = servo_.period;
    info.startedUnixTime = unixTime();
    info.stylus = stylus_.device().description().name;
    info.materials = idsOf(milling_.embedded.workpiece.properties());
    Result<Project::TakeWriter> writer = project_.beginTake(info);
    if (!writer) return std::move(writer).error();
    recorder_ = std::make_unique<Recorder>(loop_.samples(), std::move(*writer));
    take_ = recorder_->take();
    loop_.requestTake({take_, recorder_.get()});
    return {};
}

Result<void> MillingSession::stopRecording() {
    if (!recorder_) return nothingToDo("recording", "one under way");
    ask(Request::finish);
    collectStrokes();
    const std::unique_ptr<Recorder> recorder = std::exchange(recorder_, nullptr);
    const Result<std::uint64_t> kept = recorder->finish();
    if (kept && !loop_.gaveUp()) return {};
    // By now everything may be on the disk, but the session ended because of this error.
    diskFault_ = kept ? recorder->refusal() : kept.error();
    return *diskFault_;
}

/// Called while nobody else uses the workpiece.
Result<void> MillingSession::applyToWorkpiece(const WorkpieceChange& change) {
    RunVolume& workpiece = milling_.embedded.workpiece;
    return change.undone ? strokes_.undo(project_, workpiece) : strokes_.redo(project_, workpiece);
}

Result<void> MillingSession::changeWorkpiece(const WorkpieceChange& change) {
    ask(Request::stand);
    collectStrokes();
    loop_.endStroke();
    collectStrokes();
    Result<void> changed = applyToWorkpiece(change);
    if (changed) loop_.workpieceChanged(change);
    ask(Request::goOn);
    return changed;
}

Result<void> MillingSession::undoStroke() {
    collectStrokes();
    if (!strokes_.canUndo() && !loop_.strokeUnderWay()) return applyToWorkpiece({.undone = true});
    return changeWorkpiece({.undone = true});
}

Result<void> MillingSession::redoStroke() {
    collectStrokes();
    if (!strokes_.canRedo()) return applyToWorkpiece({.undone = false});
    return changeWorkpiece({.undone = false});
}

Result<void> MillingSession::followTrace() {
    if (!replayed_) return {};
    collectStrokes();
    // `ended` first: a change that is found afterwards is made by whoever owns the changes then.
    for (bool over = ended(); const std::optional<WorkpieceChange> change = replayed_->awaited(over); over = ended()) {
        collectStrokes();
        const bool known = change->undone ? strokes_.canUndo() || loop_.strokeUnderWay() : strokes_.canRedo();
        if (!known)
            return Error{ErrorCode::traceInvalid, "trace", "reading " + std::to_string(replayed_->ticks()),
                         "a stroke is undone or redone there that the trace does not contain"};
        if (Result<void> made = change->undone ? undoStroke() : redoStroke(); !made) return made;
        replayed_->made(over);
    }
    return {};
}

/// Changes that find the ring full, as the loop is paused or late, are sent later, in order.
void MillingSession::tell(const StepChange& change) {
    untold_.push_back(change);
    tellWhatWaits();
}

void MillingSession::tellWhatWaits() {
    while (!untold_.empty() && loop_.tell(untold_.front())) untold_.pop_front();
}

void MillingSession::setAllowance(double allowance) {
    allowance_ = allowance;
    tell(AllowanceChange{allowance});
}

Result<void> MillingSession::setLayer(std::size_t layer, bool on) {
    if (layer == 0 || layer >= layerCount_)
        return Error{ErrorCode::argumentInvalid, "layer", std::to_string(layer),
                     layerCount_ > 1 ? "1 to " + std::to_string(layerCount_ - 1) : "none: the part alone is there"};
    if (on && layer == stockLayer_ && recorder_)
        return Error{ErrorCode::argumentInvalid, "layer", std::to_string(layer), "another one during a recording"};
    tell(LayerSwitch{layer, on});
    return {};
}

Result<void> MillingSession::setStockLayer(bool on) {
    if (!(stock_.distance > 0.0)) return nothingToDo("layer", "one that the session has");
    tell(LayerSwitch{layerCount_, on});
    return {};
}

Result<void> MillingSession::setGuides(const GuideSettings& guides) {
    if (Result<void> good = checkGuides(guides); !good) return good;
    tell(guides);
    return {};
}

/// Once for each trace that can't be written, while milling goes on.
std::optional<Error> MillingSession::takeTraceFault() {
    if (traceFault_) return std::exchange(traceFault_, std::nullopt);
    if (traceEnded_ || !trace_ || !trace_->failing()) return std::nullopt;
    traceEnded_ = true;
    return trace_->fault();
}

std::optional<Error> MillingSession::takeFault() {
    if (std::optional<Error> fault = faults_.take()) return fault;
    if (!traceRequired_)
        if (std::optional<Error> fault = takeTraceFault()) return fault;
    if (!loop_.takeHeat()) return std::nullopt;
    return Error{ErrorCode::deviceHot, stylus_.device().description().name, {}, {}};
}

bool MillingSession::newest(SessionState& state) {
    tellWhatWaits();
    collectStrokes();
    strokes_.tidy();
    loop_.takeFigures(figures_);
    TickNews news;
    if (!loop_.takeNews(news)) return false;
    makeRoom(news);
    state = sessionState(news, figures_, layerCount_, milling_.embedded.workpiece.grid().unitVolume());
    if (stock_.distance > 0.0) state.stock = layerNews(news.layers, layerCount_);
    return true;
}

/// Frees memory if it runs out: milling is more important than undoing old strokes.
void MillingSession::makeRoom(const TickNews& news) {
    constexpr std::uint64_t patience = 10; // ticks until the loop knows of it
    if ((news.sample.flags & sampleMemoryFull) == 0 || news.ticks < roomMade_ + patience) return;
    if (!strokes_.makeRoom()) return;
    tell(CutResumption{});
    roomMade_ = news.ticks;
}

/// Passes the oldest cut of a view that is not shown on to the next view.
void MillingSession::noteCut(const WorkpieceView& view) {
    if (view.oldestCut) unseenCut_ = std::min(unseenCut_.value_or(*view.oldestCut), *view.oldestCut);
}

bool MillingSession::newestView(WorkpieceView& view) {
    settle();
    WorkpieceView newest;
    if (loop_.takeView(newest)) noteCut(newest); // it was too late for the last call
    if (!thread_.joinable()) {
        newest = loop_.finalView();
    } else {
        loop_.requestView();
        const Clock::time_point end = Clock::now() + viewPatience;
        while (!loop_.takeView(newest)) {
            if (ended() || Clock::now() >= end) return false;
            std::this_thread::sleep_for(sessionGlance);
        }
    }
    noteCut(newest);
    view.workpiece = std::move(newest.workpiece);
    view.oldestCut = std::exchange(unseenCut_, std::nullopt);
    return true;
}

void MillingSession::takeTrace(std::vector<TracePoint>& points) {
    points.clear();
    std::array<TracePoint, 256> part;
    while (const std::size_t count = loop_.takeTrace(part))
        points.insert(points.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count));
}

Result<void> MillingSession::placeTrace(Result<StagedFile> trace) {
    if (!trace) return std::move(trace).error();
    if (traceOutput_ == nullptr) return trace->putInPlace();
    traceOutput_->emplace(std::move(*trace));
    return {};
}

Result<LoopStatistics> MillingSession::end() {
    if (over_) return outcome_;
    over_ = true;
    stop_.store(true, std::memory_order_relaxed);
    if (thread_.joinable()) thread_.join();
    ended_.store(true, std::memory_order_release);
    settle();
    faults_.finish();
    // Report the disk's error, not the full ring that it caused.
    if (recorder_) static_cast<void>(stopRecording());
    if (diskFault_) outcome_ = *diskFault_;
    step_.listen(nullptr);
    if (const std::unique_ptr<TraceRecorder> trace = std::move(trace_)) {
        const Result<void> written = placeTrace(trace->finish());
        if (!written && outcome_ && !traceEnded_) outcome_ = written.error();
    }
    stylus_.device().close();
    return outcome_;
}

Result<std::unique_ptr<MillingSession>> MillingSession::begin(Project& project, MillingContext& milling,
                                                              const ToolBounds& bounds, const StylusHandle& stylus,
                                                              StrokeHistory& strokes, const SessionRequest& request) {
    if (Result<void> opened = stylus.device().open(); !opened) return std::move(opened).error();
    std::unique_ptr<MillingSession> session(
        new MillingSession(project, milling, bounds, stylus, strokes, request)); // its constructor is private
    if (Result<void> started = session->start(bounds, request); !started) return std::move(started).error();
    return session;
}

} // namespace burin
