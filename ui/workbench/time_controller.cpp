// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/time_controller.h"

#include "ui/workbench/value_command.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace burin {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds frame = 33ms; // of play
constexpr std::chrono::milliseconds longWay = 400ms;
constexpr std::chrono::milliseconds settling = 100ms; // changes of recordings often come in pairs

/// The first motion of a line, from 1, or of the lines after it; empty: none.
std::optional<std::size_t> motionOf(const ParsedProgram& program, int line) {
    const auto motion =
        std::ranges::lower_bound(program.motions, static_cast<std::uint32_t>(line), {}, &NcMotion::line);
    if (motion == program.motions.end()) return std::nullopt;
    return static_cast<std::size_t>(motion - program.motions.begin());
}

std::vector<std::string_view> programLines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

} // namespace

/// What is needed to go to any moment; made on first use.
struct TimeController::Source {
    std::shared_ptr<MillingContext> milling; ///< of the stock
    std::vector<SharedCuts> cuts;
    std::vector<KeptWorkpiece> kept;
    RecordedState state; ///< of the recordings that `cuts` and `kept` belong to
    std::optional<WorkpieceInTime> workpieces;

    Result<VolumeSnapshot> at(const TakeMoment& moment, Progress& progress) {
        if (!workpieces) {
            Result<WorkpieceInTime> made = make(progress);
            if (!made) return std::move(made).error();
            workpieces = std::move(*made);
        }
        return workpieces->at(moment, progress);
    }

private:
    Result<WorkpieceInTime> make(Progress& progress) {
        Result<RunVolume> stock = milling->stock->makeStock(progress);
        if (!stock) return std::move(stock).error();
        Result<KeptWorkpiece> packed = keptAs(stock->snapshot(), {}, {}, progress);
        if (!packed) return std::move(packed).error();
        return WorkpieceInTime::make(std::move(*packed), cuts, kept, progress);
    }
};

TimeController::TimeController(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session,
                               MillController& mill, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), session_(session), mill_(mill) {
    play_.setInterval(frame);
    play_.setTimerType(Qt::PreciseTimer);
    connect(&play_, &QTimer::timeout, this, &TimeController::tick);
    readSoon_.setSingleShot(true);
    readSoon_.setInterval(settling);
    connect(&readSoon_, &QTimer::timeout, this, &TimeController::read);
    connect(&mill_, &MillController::takesChanged, this, &TimeController::stale);
    connect(&mill_, &MillController::left, this, &TimeController::stale);
    connect(&workpiece_, &WorkpieceController::workpieceChanged, this, &TimeController::stale);
    connect(&workpiece_, &Controller::changed, this, &TimeController::recordFromHere);
    connect(&workpiece_, &Controller::failed, this, [this] { recordWhenReady_ = false; });
    connect(&session_, &SessionRunner::ticked, this, [this] {
        if (away_) backToPresent();
    });
}

void TimeController::setFollowed(bool followed) {
    if (std::exchange(followed_, followed) == followed) return;
    if (!followed) backToPresent();
    if (followed && stale_) readSoon_.start();
    if (followed && program_) spread();
}

bool TimeController::possible() const {
    return recorded() && !recorded()->tracks.empty() && workpiece_.embedded() && !workpiece_.embedding() &&
           !session_.running();
}

/// The recordings that were read are out of date.
void TimeController::stale() {
    stale_ = true;
    backToPresent();
    if (followed_) readSoon_.start();
}

void TimeController::forget() {
    ++generation_;
    pause();
    desk_.tasks.abandon(TaskKind::time);
    desk_.tasks.abandon(TaskKind::punchingIn);
    showProgram(nullptr);
    recorded_.reset();
    markers_.clear();
    breakpoints_.clear();
    source_.reset();
    shown_.reset();
    wanted_.reset();
    away_ = reading_ = recordWhenReady_ = false;
    stale_ = true;
    seconds_ = 0.0;
    emit recordedChanged();
    emit momentChanged();
    emit breakpointsChanged();
    emit changed();
    if (followed_) readSoon_.start();
}

/// A recording under way is read when it ends.
void TimeController::read() {
    if (!followed_ || !stale_ || reading_ || session_.running() || !workpiece_.embedded() || workpiece_.embedding())
        return;
    reading_ = true;
    stale_ = false;
    emit changed();
    desk_.project.ask([before = recorded_](Project& project) { return readRecordedTime(project, before.get()); },
                      [this, generation = generation_](Result<RecordedTime> time) {
                          if (generation != generation_) return;
                          reading_ = false;
                          if (time)
                              adopt(std::move(*time));
                          else
                              emit failed(time.error());
                          if (stale_) readSoon_.start();
                          emit changed();
                      });
}

void TimeController::adopt(RecordedTime time) {
    if (!program_) backToPresent();
    auto source = std::make_shared<Source>();
    source->milling = workpiece_.milling();
    source->cuts = time.cuts;
    source->kept = std::exchange(time.kept, {});
    source->state = time.state;
    source_ = std::move(source);
    markers_ = std::move(time.markers);
    time.markers.clear();
    recorded_ = std::make_shared<const RecordedTime>(std::move(time));
    if (!program_) seconds_ = recorded_->seconds();
    emit recordedChanged();
}

void TimeController::goTo(double seconds) {
    if (!possible()) return;
    seconds_ = std::clamp(seconds, 0.0, recorded()->seconds());
    wanted_ = recorded()->momentAt(seconds_);
    away_ = true;
    // A long computation of a different moment is cancelled; its cuts so far are kept.
    if (arriving() && onItsWay_.hasExpired(longWay.count())) desk_.tasks.cancel(TaskKind::time);
    arrive();
    emit changed();
}

void TimeController::goTo(const TakeMoment& moment) {
    if (possible()) goTo(recorded()->secondsAt(moment));
}

std::optional<Moment> TimeController::handMoment() const {
    if (!away_ || program_ || !recorded_ || recorded_->tracks.empty()) return std::nullopt;
    const TakeMoment at = recorded_->momentAt(seconds_);
    const std::uint64_t tick = recorded_->trackOf(at.take)->tickOf(at.samples > 0 ? at.samples - 1 : 0);
    return Moment{at.take, static_cast<std::int64_t>(tick)};
}

std::optional<glm::dvec3> TimeController::handTip() const {
    const std::optional<Moment> moment = handMoment();
    const bool read = moment && shown_ && shown_->sample && shown_->moment.take == moment->source &&
                      static_cast<std::int64_t>(shown_->sample->tick) == moment->tick;
    return read ? std::optional(shown_->sample->proxy.tip) : std::nullopt;
}

std::optional<double> TimeController::secondsAt(const Moment& moment) const {
    const TakeTrack* track = recorded_ ? recorded_->trackOf(moment.source) : nullptr;
    if (track == nullptr || moment.tick < 0) return std::nullopt;
    return recorded_->secondsAt({moment.source, track->sampleOf(static_cast<std::uint64_t>(moment.tick)) + 1});
}

void TimeController::goTo(const Moment& moment) {
    if (program_) return;
    if (const std::optional<double> seconds = secondsAt(moment)) {
        pause();
        goTo(*seconds);
    }
}

void TimeController::followPath(const Moment& moment) {
    if (away_) goTo(moment);
}

void TimeController::addDeviation(std::int64_t take, std::uint64_t samples, std::vector<float> values) {
    if (!recorded_) return;
    RecordedTime time = *recorded_;
    const auto track = std::ranges::find(time.tracks, take, [](const TakeTrack& each) { return each.info.id; });
    if (track == time.tracks.end() || track->info.sampleCount != samples) return;
    track->curves[static_cast<std::size_t>(TrackCurve::deviation)] = std::move(values);
    recorded_ = std::make_shared<const RecordedTime>(std::move(time));
    emit recordedChanged();
}

void TimeController::arrive() {
    if (!wanted_ || arriving()) return;
    const TakeMoment moment = *std::exchange(wanted_, std::nullopt);
    onItsWay_.start();
    desk_.tasks.start(
        TaskKind::time, tr("Computing the workpiece at that time"),
        [source = source(), moment](Progress& progress) { return source->at(moment, progress); },
        [this, moment, generation = generation_](const Result<VolumeSnapshot>& workpiece) {
            if (generation != generation_ || !away_) return;
            if (workpiece) {
                show(moment, *workpiece);
                keepWorthKeeping();
            } else if (!wanted_ || workpiece.error().code != ErrorCode::cancelled) {
                pause();
                wanted_.reset();
                if (workpiece.error().code != ErrorCode::cancelled) emit failed(workpiece.error());
                if (!shown_) backToPresent();
            }
            arrive();
            emit changed();
        });
}

void TimeController::show(const TakeMoment& moment, const VolumeSnapshot& workpiece) {
    if (!shown_) shown_.emplace();
    if (const std::optional<Tool> tool = toolOf(moment.take)) shown_->tool = *tool;
    shown_->moment = moment;
    shown_->workpiece = workpiece;
    readSample(moment);
    emit momentChanged();
}

std::optional<Tool> TimeController::toolOf(std::int64_t take) const {
    for (const SharedCuts& cuts : source()->cuts)
        if (cuts->take == take) return cuts->tool;
    return std::nullopt;
}

/// Reads the poses of hand and tool: a chunk of the recording, some milliseconds at most.
void TimeController::readSample(const TakeMoment& moment) {
    if (program_) {
        shown_->sample.emplace();
        shown_->sample->proxy = programTime_->poseAt(moment);
        shown_->sample->stylusTip = shown_->sample->proxy.tip;
        return;
    }
    desk_.project.ask(
        [moment](Project& project) { return project.sample(moment.take, moment.samples > 0 ? moment.samples - 1 : 0); },
        [this, generation = generation_](const Result<Sample>& sample) {
            if (generation != generation_ || !shown_ || !sample) return;
            shown_->sample = *sample;
            emit momentChanged();
        });
}

void TimeController::keepWorthKeeping() {
    if (program_ || !source_->workpieces) return;
    for (KeptWorkpiece& kept : source_->workpieces->takeWorthKeeping()) keepInProject(std::move(kept), source_->state);
}

/// If it can't be stored, it is cut again.
void TimeController::keepInProject(KeptWorkpiece kept, const RecordedState& state) {
    desk_.project.ask(
        [kept = std::move(kept), state](Project& project) -> Result<void> {
            return project.readOnly() ? Result<void>() : project.keepWorkpiece(kept, state);
        },
        [](const Result<void>&) {});
}

void TimeController::backToPresent() {
    pause();
    wanted_.reset();
    if (!std::exchange(away_, false)) return;
    if (desk_.tasks.running(TaskKind::time)) desk_.tasks.cancel(TaskKind::time);
    shown_.reset();
    if (recorded()) seconds_ = recorded()->seconds();
    emit momentChanged();
    emit changed();
}

void TimeController::switchInterval(std::int64_t take, const SampleRange& interval, bool on) {
    mill_.setSwitchedOff(on ? tr("switch on") : tr("switch off"), [take, interval, on](const Project& project) {
        return withInterval(project, take, interval, !on);
    });
}

/// Stores the workpiece of that moment first, so that it need not be cut again.
void TimeController::punchIn() {
    if (program_ || !shown_ || arriving() || !workpiece_.ready()) return;
    pause();
    desk_.tasks.start(
        TaskKind::punchingIn, tr("Storing the workpiece"),
        [workpiece = shown_->workpiece, moment = shown_->moment,
         strokes = strokesBefore(source_->cuts, shown_->moment)](Progress& progress) {
            return keptAs(workpiece, moment, strokes, progress);
        },
        [this, moment = shown_->moment, state = source_->state,
         generation = generation_](const Result<KeptWorkpiece>& kept) {
            if (generation != generation_) return;
            if (kept) keepInProject(*kept, state);
            mill_.setSwitchedOff(
                tr("punch in"), [moment](const Project& project) { return offAfter(project, moment); },
                [this] {
                    recordWhenReady_ = true;
                    recordFromHere(); // if nothing came after it, the workpiece is ready
                });
        });
}

void TimeController::recordFromHere() {
    if (!recordWhenReady_ || !workpiece_.ready()) return;
    recordWhenReady_ = false;
    backToPresent();
    mill_.startRecording();
}

void TimeController::addMarker(const QString& name) {
    if (program_ || !possible() || name.trimmed().isEmpty()) return;
    const TimeMarker marker{recorded_->momentAt(seconds_), name.trimmed().toStdString()};
    std::vector<TimeMarker> markers = markers_;
    std::erase_if(markers, [&](const TimeMarker& other) { return other.at == marker.at; });
    const auto earlier = [this](const TakeMoment& one, const TakeMoment& other) {
        return recorded_->order.isBefore(one, other);
    };
    markers.insert(std::ranges::upper_bound(markers, marker.at, earlier, &TimeMarker::at), marker);
    setMarkers(tr("marker"), std::move(markers));
}

void TimeController::changeMarker(std::size_t marker, const QString& name) {
    if (program_ || marker >= markers_.size()) return;
    std::vector<TimeMarker> markers = markers_;
    if (name.trimmed().isEmpty())
        markers.erase(markers.begin() + static_cast<std::ptrdiff_t>(marker));
    else
        markers[marker].name = name.trimmed().toStdString();
    setMarkers(name.trimmed().isEmpty() ? tr("delete a marker") : tr("marker"), std::move(markers));
}

void TimeController::setMarkers(const QString& title, std::vector<TimeMarker> markers) {
    if (markers == markers_) return;
    using Markers = std::vector<TimeMarker>;
    desk_.undo.push(new ValueCommand<Markers>(title, -1, markers_, std::move(markers), [this](const Markers& wanted) {
        markers_ = wanted;
        store([wanted](Project& project) { return project.setMarkers(wanted); });
        emit changed();
    }));
}

void TimeController::play() {
    if (!possible() || playing()) return;
    if (seconds_ >= recorded()->seconds()) goTo(0.0);
    clock_.start();
    play_.start();
    emit changed();
}

void TimeController::pause() {
    if (!playing()) return;
    play_.stop();
    emit changed();
}

void TimeController::tick() {
    const double passed = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
    clock_.start();
    const double end = recorded() ? recorded()->seconds() : 0.0;
    double next = std::min(seconds_ + passed * speed_, end);
    if (const std::optional<double> stop = stopWithin(seconds_, next)) {
        next = *stop;
        pause();
    }
    if (next >= end) pause();
    goTo(next);
}

/// The first finding or breakpoint after `from`, no later than `to`.
std::optional<double> TimeController::stopWithin(double from, double to) const {
    if (!programTime_) return std::nullopt;
    std::optional<double> first;
    const auto look = [&](const TakeMoment& moment) {
        const double at = spread_->secondsAt(moment);
        if (at > from + 0.5 * programTime_->tick && at <= to) first = std::min(first.value_or(at), at);
    };
    for (const ProgramTime::FindingMoment& finding : programTime_->findings) look(finding.at);
    for (const int line : breakpoints_)
        if (const std::optional<std::size_t> motion = motionOf(program_->parsed, line))
            look(programTime_->beginOf(*motion));
    return first;
}

void TimeController::toggleBreakpoint(int line) {
    if (!program_ || line < 1) return;
    if (breakpoints_.erase(line) == 0) breakpoints_.insert(line);
    emit breakpointsChanged();
}

/// @param before text of the program in which they were set
void TimeController::keepBreakpoints(const std::string& before) {
    const std::vector<std::string_view> then = programLines(before);
    const std::vector<std::string_view> now = programLines(program_ ? std::string_view(program_->text) : before);
    const auto changed = [&](int line) {
        const auto place = static_cast<std::size_t>(line) - 1;
        return place >= then.size() || place >= now.size() || then[place] != now[place];
    };
    if (std::erase_if(breakpoints_, changed) > 0) emit breakpointsChanged();
}

void TimeController::showProgram(std::shared_ptr<const CheckedProgram> program) {
    if (program == program_) return;
    backToPresent();
    desk_.tasks.abandon(TaskKind::time);
    desk_.tasks.abandon(TaskKind::programTime);
    if (const auto before = std::exchange(program_, std::move(program))) lastText_ = before->text;
    if (!breakpoints_.empty()) keepBreakpoints(lastText_);
    programTime_.reset();
    spread_.reset();
    programSource_.reset();
    shown_.reset();
    if (program_) spread();
    seconds_ = recorded() ? recorded()->seconds() : 0.0;
    emit recordedChanged();
    emit changed();
}

void TimeController::spread() {
    if (!followed_ || programTime_ || !workpiece_.milling()) return;
    const auto milling = workpiece_.milling();
    desk_.tasks.start(
        TaskKind::programTime, tr("Reading the program's time"),
        [program = program_, machine = milling->machine, zero = milling->setup.workOffset](Progress& progress) {
            return burin::programTime(*program, machine, zero, progress);
        },
        [this, milling, program = program_](Result<ProgramTime> made) {
            if (program != program_) return;
            if (!made) {
                if (made.error().code != ErrorCode::cancelled) emit failed(made.error());
                return;
            }
            programSource_ = std::make_shared<Source>();
            programSource_->milling = milling;
            programSource_->cuts = made->time.cuts;
            programTime_ = std::make_shared<const ProgramTime>(std::move(*made));
            spread_ = {programTime_, &programTime_->time}; // shares ownership of the program's time
            seconds_ = spread_->seconds();
            emit recordedChanged();
            emit changed();
        });
}

void TimeController::followLine(int line) {
    if (!program_ || !programTime_ || !away_ || line < 1) return;
    const std::optional<std::size_t> motion = motionOf(program_->parsed, line);
    if (!motion) return;
    pause();
    goTo(programTime_->beginOf(*motion));
}

int TimeController::line() const {
    if (!program_ || !programTime_ || !away_ || programTime_->motions.empty()) return 0;
    const std::size_t motion = programTime_->motionAt(spread_->momentAt(seconds_));
    return motion < program_->parsed.motions.size() ? static_cast<int>(program_->parsed.motions[motion].line) : 0;
}

} // namespace burin
