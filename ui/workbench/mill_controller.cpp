// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/mill_controller.h"

#include "core/job/job_paths.h"
#include "ui/workbench/done_command.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace burin {

namespace {

bool sameTake(const TakeInfo& one, const TakeInfo& other) {
    return one.id == other.id && one.name == other.name && one.sampleCount == other.sampleCount &&
           one.undoneCount == other.undoneCount && one.complete == other.complete && one.copyOf == other.copyOf;
}

} // namespace

MillController::MillController(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session,
                               StylusController& styluses, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), session_(session), styluses_(styluses) {
    connect(&session_, &SessionRunner::ticked, this, &MillController::noteStrokes);
    connect(&session_, &SessionRunner::ticked, this, &MillController::followButton);
    connect(&session_, &SessionRunner::ended, this, &MillController::noteLeft);
    connect(&session_, &SessionRunner::recordingStarted, this, [this] {
        takeAwaited_ = true;
        refreshTakes([this] {
            if (std::exchange(takeAwaited_, false) && !takes_.empty()) recorded_ = newestTake(takes_).id;
            noteStrokes();
        });
    });
    connect(&session_, &SessionRunner::failed, this, [this](const Error& error) {
        if (error.subject == traces_.now().string()) traces_.drop();
    });
    connect(&session_, &SessionRunner::endedByItself, this, [this] {
        if (active()) leave(); // a fault, which is reported when the session ends
    });
}

void MillController::noteLeft() {
    const bool was = std::exchange(active_, false);
    startingRecording_ = recordingSince_ = false;
    mouse_ = nullptr;
    device_.reset();
    noteStrokes();
    refreshTakes([this] { noteRecording(); });
    if (const std::filesystem::path trace = traces_.end(); !trace.empty())
        emit traceWritten(QString::fromStdString(trace.string()));
    if (was) emit left();
    emit changed();
}

void MillController::enter() {
    if (active() || entering_ || session_.running() || !workpiece_.ready()) {
        recordOnceEntered_ = recordOnceEntered_ && entering_;
        return;
    }
    entering_ = true;
    if (styluses_.mouse())
        enterWithMouse();
    else
        enterWithDevice();
}

void MillController::enterWithMouse() {
    const MillingContext& milling = *workpiece_.milling();
    const glm::dvec3 centre = milling.setup.stock.centre();
    auto stylus = std::make_unique<SimulatedStylus>(glm::dvec3(centre.x, centre.y, milling.safeHeight()));
    SimulatedStylus* mouse = stylus.get();
    SessionRequest request;
    request.cutsOnButton = true;
    begin(std::move(stylus), mouse, request);
}

void MillController::enterWithDevice() {
    // Another device may be chosen until this one is connected.
    styluses_.connectDevice(
        [this, assignment = styluses_.axisMap(styluses_.choice().id)](std::unique_ptr<AnyStylus> stylus) {
            if (!stylus || session_.running() || !workpiece_.ready()) { // the reason for the request may be gone
                begun(false, nullptr);
                return;
            }
            device_ = handDevice(StylusHandle(*stylus).device(), *workpiece_.milling(), assignment);
            SessionRequest request;
            request.mapping = device_->mapping;
            request.cutsOnButton = device_->description.buttons > 0;
            request.forceButtons = forceButtons_;
            request.felt = felt_;
            request.gains = gains_;
            begin(std::move(*stylus), nullptr, request);
        });
    emit changed();
}

void MillController::begin(AnyStylus stylus, SimulatedStylus* mouse, const SessionRequest& request) {
    requested_ = request;
    requested_.allowance = allowance_;
    requested_.stock = stock_;
    requested_.trace = traces_.begin();
    requested_.traceRequired = false;
    session_.begin({workpiece_.milling(), workpiece_.bounds(), &workpiece_.strokes()}, std::move(stylus), requested_,
                   [this, mouse](bool well) { begun(well, mouse); });
}

void MillController::begun(bool well, SimulatedStylus* mouse) {
    entering_ = false;
    if (!well) device_.reset();
    if (!well) traces_.drop();
    if (well) {
        active_ = true;
        mouse_ = mouse;
        session_.setStockLayer(stock_.on); // it may have been switched since the request
        emit entered();
        if (outdated()) {
            interrupt([] {});
            return;
        }
    }
    // A stroke of a device without buttons ends only when milling ends: all its movements are recorded.
    const bool always = device_ && device_->description.buttons == 0;
    if ((std::exchange(recordOnceEntered_, false) || always) && well) startRecording();
    emit changed();
}

/// Whether something was set since the request that only a new session adopts.
bool MillController::outdated() const {
    const bool ofDevice = requested_.forceButtons != forceButtons_ || requested_.gains != gains_;
    return requested_.stock.distance != stock_.distance || (device_ && ofDevice) ||
           requested_.trace.empty() != trace().empty();
}

void MillController::setTrace(const std::filesystem::path& file) {
    const bool changes = !file.empty() || !trace().empty();
    traces_.choose(file);
    if (changes && active()) interrupt([] {});
    emit changed();
}

/// A stroke of a device begins when its button is pressed, like that of the mouse.
void MillController::followButton() {
    const bool wasDown = std::exchange(buttonDown_, (session_.state().sample.buttons & 1U) != 0);
    if (active() && mouse_ == nullptr && buttonDown_ && !wasDown) startRecording();
}

void MillController::leave(Then then) {
    session_.end([then = std::move(then)](bool) {
        if (then) then();
    });
}

void MillController::interrupt(std::function<void()> meanwhile) {
    const bool goesOn = active();
    if (!session_.running()) {
        meanwhile();
        return;
    }
    session_.end([this, goesOn, meanwhile = std::move(meanwhile)](bool) {
        meanwhile();
        if (goesOn) enter();
    });
}

bool MillController::startRecording() {
    if (!active()) {
        recordOnceEntered_ = true;
        enter();
        return true;
    }
    if (startingRecording_) return true;
    if (recording() || recordingSince_) return false;
    startingRecording_ = true;
    // In English, as for the virtual operator; panels show it in the language of the reader.
    const QString name = QStringLiteral("take %1").arg(takes_.empty() ? 1 : newestTake(takes_).id + 1);
    session_.startRecording(name, [this](bool well) {
        startingRecording_ = false;
        recordingSince_ = well;
        emit recordingBegan(well);
        refreshTakes();
        emit changed();
    });
    return true;
}

void MillController::stopRecording(Then then) {
    session_.stopRecording([this, then = std::move(then)](bool) {
        recordingSince_ = false;
        noteStrokes();
        refreshTakes([this] { noteRecording(); });
        if (then) then();
        emit changed();
    });
}

void MillController::setAllowance(double millimetres) {
    const double wanted = std::clamp(millimetres, 0.0, WorkpieceController::maximumAllowance);
    if (wanted == allowance_) return;
    desk_.undo.push(new ValueCommand<double>(tr("allowance"), allowanceValue, allowance_, wanted,
                                             [this](const double& value) { applyAllowance(value); }));
}

void MillController::setForceButtons(std::uint32_t buttons) {
    if (std::exchange(forceButtons_, buttons) == buttons || !active() || !device_) return;
    interrupt([] {});
}

void MillController::setStockLayer(const StockLayer& layer) {
    const StockLayer before = std::exchange(stock_, layer);
    if (active() && before.distance != layer.distance)
        interrupt([] {});
    else if (active())
        session_.setStockLayer(layer.on);
    emit changed();
}

void MillController::applyAllowance(double millimetres) {
    allowance_ = millimetres;
    if (active()) session_.setAllowance(millimetres);
    emit changed();
}

void MillController::takeBack(const StrokePlace& stroke, bool undo) {
    const StrokeHistory& history = workpiece_.strokes();
    const bool can = undo ? history.canUndo() : history.canRedo();
    const auto is = [&](const Stroke& other) {
        return other.take == stroke.take && SampleRange{other.first, other.count} == stroke.samples;
    };
    // A stroke that the history has dropped, or that was milled before the workpiece was recomputed, is removed by
    // recomputing without it.
    if (!can || !is(undo ? history.newest() : history.nextRedo())) return takeBackInProject(stroke, undo);
    const auto done = [this, undo, take = stroke.take](bool changedIt) {
        if (changedIt) tookBack(take, undo);
    };
    if (session_.running()) {
        if (undo)
            session_.undoStroke(done);
        else
            session_.redoStroke(done);
        return;
    }
    desk_.project.lend([this, undo, done](Project* project) {
        if (!project || !workpiece_.milling()) return;
        RunVolume& workpiece = workpiece_.milling()->embedded.workpiece;
        const Result<void> outcome =
            undo ? workpiece_.strokes().undo(*project, workpiece) : workpiece_.strokes().redo(*project, workpiece);
        if (!outcome) emit failed(outcome.error());
        emit workpiece_.workpieceChanged();
        done(outcome.hasValue());
    });
}

void MillController::takeBackInProject(const StrokePlace& stroke, bool undo) {
    desk_.project.post(
        [stroke, undo](Project& project) {
            return undo ? project.undoInterval(stroke.take, stroke.samples)
                        : project.redoInterval(stroke.take, stroke.samples);
        },
        [this, take = stroke.take, undo](const Result<void>& outcome) {
            if (!outcome) {
                emit failed(outcome.error());
                return;
            }
            workpiece_.remake();
            tookBack(take, undo);
            refreshTakes();
        });
}

void MillController::tookBack(std::int64_t take, bool undo) {
    moveStroke(take, undo);
    sortOut();
    emit strokeTakenBack(undo);
    emit takesChanged();
    emit changed();
}

void MillController::moveStroke(std::int64_t take, bool undo) {
    std::vector<std::uint64_t>& from = undo ? numbers_[take] : undoneNumbers_;
    std::vector<std::uint64_t>& to = undo ? undoneNumbers_ : numbers_[take];
    if (!from.empty()) {
        to.push_back(from.back());
        from.pop_back();
    }
    std::size_t& strokes = strokes_[take]; // 0 as well if the workpiece was not recomputed since the project was read
    strokes = undo ? strokes - std::min<std::size_t>(strokes, 1) : strokes + 1;
}

void MillController::noteStrokes() {
    if (takeAwaited_) return;
    const std::uint64_t now = workpiece_.strokes().added();
    const std::uint64_t fresh = now - std::exchange(strokesSeen_, now);
    const StrokeHistory& history = workpiece_.strokes();
    for (std::size_t i = std::min<std::size_t>(fresh, history.count()); i-- > 0;) {
        const Stroke& stroke = history.newest(i);
        desk_.undo.pushRecorded(
            new DoneCommand(tr("stroke"), [this, place = StrokePlace{stroke.take, {stroke.first, stroke.count}}](
                                              bool undo) { takeBack(place, undo); }),
            stroke.take);
    }
    if (fresh == 0) return;
    recorded_ = 0;
    if (workpiece_.strokes().canUndo()) {
        const std::int64_t take = workpiece_.strokes().newest().take;
        strokes_[take] += fresh;
        for (std::uint64_t number = now - fresh + 1; number <= now; ++number) numbers_[take].push_back(number);
    }
    undoneNumbers_.clear();
    sortOut();
    emit takesChanged();
}

std::size_t MillController::strokesOf(std::int64_t take) const {
    const auto found = strokes_.find(take);
    return found == strokes_.end() ? 0 : found->second;
}

std::map<std::int64_t, std::uint64_t> MillController::newestStrokes() const {
    std::map<std::int64_t, std::uint64_t> newest;
    for (const auto& [take, numbers] : numbers_)
        if (!numbers.empty()) newest[take] = numbers.back();
    return newest;
}

/// A take whose strokes were all undone is left out, unless redo restores one of them.
void MillController::sortOut() {
    standing_.clear();
    std::ranges::copy_if(takes_, std::back_inserter(standing_), [this](const TakeInfo& take) {
        const auto strokes = strokes_.find(take.id);
        return strokes == strokes_.end() || strokes->second > 0;
    });
}

void MillController::setStrokes(std::map<std::int64_t, std::size_t> strokes) {
    strokes_ = std::move(strokes);
    for (const TakeInfo& take : takes_) // a take that never had a stroke is kept, so that it can be removed
        if (take.undoneCount == 0 && strokesOf(take.id) == 0) strokes_.erase(take.id);
    const std::size_t before = standing_.size();
    sortOut();
    if (standing_.size() != before) emit takesChanged();
    emit changed();
}

void MillController::load(std::vector<TakeInfo> takes) {
    takes_ = std::move(takes);
    chosen_ = recorded_ = 0;
    takeAwaited_ = false;
    allowance_ = takes_.empty() ? 0.0 : newestTake(takes_).allowance;
    strokesSeen_ = workpiece_.strokes().added();
    strokes_.clear();
    numbers_.clear();
    undoneNumbers_.clear();
    sortOut();
    emit takesChanged();
    emit changed();
}

void MillController::refreshTakes(Then then) {
    desk_.project.ask([](Project& project) { return project.takes(); },
                      [this, then = std::move(then)](Result<std::vector<TakeInfo>> takes) {
                          if (takes && !std::ranges::equal(*takes, takes_, sameTake)) {
                              takes_ = std::move(*takes);
                              sortOut();
                              emit takesChanged();
                              emit changed();
                          }
                          if (then) then();
                      });
}

} // namespace burin
