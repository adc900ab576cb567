// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/workpiece_in_time.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

/// The cost of reading a kept workpiece, in motions to cut: reading pays if it saves more motions.
constexpr std::uint64_t motionsOfReading = 2000;
/// The cost of applying the bricks of a known step: about a twentieth of cutting it.
constexpr std::uint64_t motionsOfKnownStep = WorkpieceInTime::motionsPerStep / 20;

Error goingCancelled() {
    return {ErrorCode::cancelled, "going to a moment", {}, {}};
}

} // namespace

std::map<std::int64_t, std::size_t> strokesBefore(std::span<const SharedCuts> takes, const TakeMoment& moment) {
    std::map<std::int64_t, std::size_t> strokes;
    if (moment.take == 0) return strokes;
    for (const SharedCuts& take : takes) {
        const bool last = take->take == moment.take;
        if (!last || moment.samples >= take->sampleCount) strokes[take->take] = take->strokes;
        if (last) break;
    }
    return strokes;
}

Result<WorkpieceInTime> WorkpieceInTime::make(KeptWorkpiece stock, std::vector<SharedCuts> takes,
                                              std::vector<KeptWorkpiece> kept, Progress& progress) {
    Result<RunVolume> volume = volumeOf(stock, progress);
    if (!volume) return std::move(volume).error();
    stock.at = {};
    kept.push_back(std::move(stock));
    return WorkpieceInTime(std::move(*volume), std::move(takes), std::move(kept));
}

WorkpieceInTime::WorkpieceInTime(RunVolume stock, std::vector<SharedCuts> takes, std::vector<KeptWorkpiece> kept)
    : takes_(std::move(takes)), volume_(std::move(stock)), atMark_(volume_.snapshot()) {
    before_.push_back(0);
    for (const SharedCuts& take : takes_) before_.push_back(before_.back() + take->motions.count());
    placeMarks(std::move(kept));
}

std::uint64_t WorkpieceInTime::motionsBefore(const TakeMoment& moment) const noexcept {
    if (moment.take == 0) return 0;
    const auto take = std::ranges::find(takes_, moment.take, [](const SharedCuts& each) { return each->take; });
    const std::uint64_t before = before_[static_cast<std::size_t>(take - takes_.begin())];
    return take == takes_.end() ? before : before + (*take)->motions.countWithin(moment.samples);
}

/// Places marks at each take's end, at the kept workpieces, and every thousand motions of a take in between.
void WorkpieceInTime::placeMarks(std::vector<KeptWorkpiece> kept) {
    std::map<std::uint64_t, Mark> marks;
    const auto markOf = [&](std::uint64_t motions, const TakeMoment& moment) -> Mark& {
        Mark& mark = marks[motions];
        mark.motions = motions;
        mark.moment = moment;
        return mark;
    };
    const std::uint64_t keptEach = std::max(motionsPerKept, before_.back() / mostKept);
    for (std::size_t i = 0; i < takes_.size(); ++i) {
        const RecordedCuts& take = *takes_[i];
        const std::uint64_t count = take.motions.count();
        if (count == 0) continue;
        for (std::uint64_t at = motionsPerStep; at < count; at += motionsPerStep) {
            Mark& mark = markOf(before_[i] + at, {take.take, take.motions.sampleOf(at - 1) + 1});
            mark.worthKeeping = at % (keptEach / motionsPerStep * motionsPerStep) == 0;
        }
        markOf(before_[i + 1], {take.take, take.sampleCount}).worthKeeping = true;
    }
    for (KeptWorkpiece& each : kept) {
        const std::uint64_t motions = motionsBefore(each.at);
        Mark& mark = markOf(motions, each.at);
        mark.kept = std::move(each);
        mark.told = true;
    }
    for (auto& [motions, mark] : marks) marks_.push_back(std::move(mark));
}

std::size_t WorkpieceInTime::markAt(std::uint64_t motions) const noexcept {
    return static_cast<std::size_t>(std::ranges::upper_bound(marks_, motions, {}, &Mark::motions) - marks_.begin()) - 1;
}

/// Returns the cost of going from the volume's position to a mark, in motions to cut.
std::uint64_t WorkpieceInTime::costOfWalk(std::size_t mark) const noexcept {
    std::uint64_t cost = 0;
    for (std::size_t i = std::min(mark, mark_); i < std::max(mark, mark_); ++i)
        cost += marks_[i].next ? motionsOfKnownStep : marks_[i + 1].motions - marks_[i].motions;
    return cost;
}

/// Returns a kept workpiece, or the stock, from which a mark costs less than from the volume's position.
std::optional<std::size_t> WorkpieceInTime::betterStart(std::size_t target) const noexcept {
    bool backwards = true; // the steps in between are known
    for (std::size_t i = target; i < mark_; ++i) backwards = backwards && marks_[i].next.has_value();
    std::optional<std::size_t> best;
    std::uint64_t least = backwards ? costOfWalk(target) : ~std::uint64_t{0};
    std::uint64_t behind = motionsOfReading;
    for (std::size_t i = target + 1; i-- > 0 && behind < least;) {
        if (i < target) behind += marks_[i].next ? motionsOfKnownStep : marks_[i + 1].motions - marks_[i].motions;
        if ((marks_[i].kept || i == 0) && behind < least) {
            best = i;
            least = behind;
        }
    }
    return best;
}

Result<void> WorkpieceInTime::jump(std::size_t mark, Progress& progress) {
    Result<RunVolume> volume = volumeOf(*marks_[mark].kept, progress);
    if (!volume) return std::move(volume).error();
    volume_ = std::move(*volume);
    mark_ = mark;
    atMark_ = volume_.snapshot();
    place_ = marks_[mark].motions;
    return {};
}

/// Cuts the motions `from` to `to`, counted over all takes.
Result<void> WorkpieceInTime::cut(std::uint64_t from, std::uint64_t to, const Progress& progress) {
    for (std::size_t i = 0; i < takes_.size(); ++i) {
        if (to <= before_[i] || from >= before_[i + 1]) continue;
        CutReplay replay(takes_[i]->tool, volume_);
        const std::uint64_t first = std::max(from, before_[i]) - before_[i];
        const std::uint64_t end = std::min(to, before_[i + 1]) - before_[i];
        Result<void> done = takes_[i]->motions.visit(
            first, end, [&](const ToolPose& begin, const ToolPose& pose, std::uint64_t) -> Result<void> {
                if (progress.cancelled()) return goingCancelled();
                return replay.cut(begin, pose);
            });
        if (done) done = replay.finish();
        if (!done) return done;
        cut_ += end - first;
    }
    place_ = to;
    return {};
}

Result<void> WorkpieceInTime::keep(std::size_t mark, Progress& progress) {
    Mark& at = marks_[mark];
    if (!at.worthKeeping || at.kept) return {};
    Result<KeptWorkpiece> kept = keptAs(atMark_, at.moment, strokesBefore(takes_, at.moment), progress);
    if (!kept) return std::move(kept).error();
    at.kept = std::move(*kept);
    return {};
}

Result<void> WorkpieceInTime::stepForward(Progress& progress) {
    const Mark& next = marks_[mark_ + 1];
    if (marks_[mark_].next) {
        if (Result<void> put = marks_[mark_].next->applyForward(volume_); !put) return put;
        place_ = next.motions;
    } else {
        if (Result<void> done = cut(place_, next.motions, progress); !done) return done;
        marks_[mark_].next = deltaBetween(atMark_, volume_.snapshot());
    }
    ++mark_;
    atMark_ = volume_.snapshot();
    return keep(mark_, progress);
}

Result<void> WorkpieceInTime::stepBackward() {
    if (Result<void> put = marks_[mark_ - 1].next->applyBackward(volume_); !put) return put;
    --mark_;
    place_ = marks_[mark_].motions;
    atMark_ = volume_.snapshot();
    return {};
}

/// Goes to a mark, from a volume that is at a mark.
Result<void> WorkpieceInTime::walkTo(std::size_t mark, Progress& progress) {
    const std::size_t begin = mark_;
    while (mark_ != mark) {
        if (progress.cancelled()) return goingCancelled();
        if (Result<void> step = mark_ < mark ? stepForward(progress) : stepBackward(); !step) return step;
        const auto done = static_cast<double>(mark_ > begin ? mark_ - begin : begin - mark_);
        const auto all = static_cast<double>(mark > begin ? mark - begin : begin - mark);
        progress.report(done / all);
    }
    return {};
}

Result<VolumeSnapshot> WorkpieceInTime::at(const TakeMoment& moment, Progress& progress) {
    const std::uint64_t motions = motionsBefore(moment);
    const std::size_t target = markAt(motions);
    const auto go = [&]() -> Result<void> {
        if (target == mark_ && motions >= place_) return cut(place_, motions, progress);
        // Cuts behind the mark are undone, so that an incomplete step is begun again.
        volume_.restore(atMark_);
        place_ = marks_[mark_].motions;
        if (const std::optional<std::size_t> start = betterStart(target))
            if (Result<void> jumped = jump(*start, progress); !jumped) return jumped;
        if (Result<void> walked = walkTo(target, progress); !walked) return walked;
        return cut(place_, motions, progress);
    };
    if (Result<void> gone = go(); !gone) {
        volume_.restore(atMark_);
        place_ = marks_[mark_].motions;
        return std::move(gone).error();
    }
    return volume_.snapshot();
}

std::vector<KeptWorkpiece> WorkpieceInTime::takeWorthKeeping() {
    std::vector<KeptWorkpiece> made;
    for (Mark& mark : marks_)
        if (mark.kept && mark.worthKeeping && !std::exchange(mark.told, true)) made.push_back(*mark.kept);
    return made;
}

} // namespace burin
