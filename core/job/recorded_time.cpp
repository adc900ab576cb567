// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/recorded_time.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace burin {

namespace {

/// Adds samples of one take to its track, in bins of ten.
class TrackBuilder {
public:
    explicit TrackBuilder(TakeTrack& track) noexcept : track_(track) {}

    void add(std::span<const Sample> samples) {
        for (const Sample& sample : samples) add(sample);
    }
    void finish() {
        if (inBin_ > 0) endBin();
        endStroke();
    }

private:
    void add(const Sample& sample) {
        if (before_) way_ += glm::distance(*before_, sample.proxy.tip);
        before_ = sample.proxy.tip;
        force_ = std::max(force_, glm::length(sample.cuttingForce));
        removed_ += sample.reportedRemoval;
        const bool held = (sample.flags & (sampleOnBoundary | sampleOnObstacle | sampleOnGuide)) != 0;
        if (held) pushBack_ = std::max(pushBack_, glm::distance(sample.stylusTip, sample.proxy.tip));
        if (sample.tick != tick_) track_.gaps.push_back({index_, sample.tick});
        tick_ = sample.tick + 1;
        height_ = inBin_ == 0 ? sample.proxy.tip.z : std::max(height_, sample.proxy.tip.z);
        followStroke((sample.flags & sampleSpindleOff) == 0);
        ++index_;
        if (++inBin_ == TakeTrack::samplesPerBin) endBin();
    }

    void followStroke(bool turning) {
        if (!turning) return endStroke();
        if (stroke_.count == 0) stroke_.first = index_;
        ++stroke_.count;
    }
    void endStroke() {
        if (stroke_.count > 0) track_.strokes.push_back(std::exchange(stroke_, {}));
    }

    void endBin() {
        constexpr double rest = 1e-4; // mm in ten ticks: tremor, not feed
        const double seconds = static_cast<double>(inBin_) * track_.info.tickPeriod;
        const auto put = [this](TrackCurve curve, double value) {
            track_.curves[static_cast<std::size_t>(curve)].push_back(static_cast<float>(value));
        };
        put(TrackCurve::force, force_);
        put(TrackCurve::removal, removed_ / seconds);
        put(TrackCurve::feed, way_ / seconds);
        put(TrackCurve::engagement, way_ > rest ? removed_ / way_ : 0.0);
        put(TrackCurve::pushBack, pushBack_);
        put(TrackCurve::height, height_);
        force_ = removed_ = way_ = pushBack_ = 0.0;
        inBin_ = 0;
    }

    TakeTrack& track_;
    std::optional<glm::dvec3> before_;
    SampleRange stroke_;
    std::uint64_t index_ = 0, inBin_ = 0, tick_ = 0; ///< `tick_`: expected next
    double force_ = 0.0, removed_ = 0.0, way_ = 0.0, pushBack_ = 0.0, height_ = 0.0;
};

/// Returns the index of a take that is unchanged, with the same tool and the same valid samples.
std::optional<std::size_t> knownTake(const RecordedTime& before, const TakeOutline& take) {
    for (std::size_t i = 0; i < before.tracks.size(); ++i) {
        const TakeTrack& track = before.tracks[i];
        if (track.info.id == take.info.id && track.info.sampleCount == take.info.sampleCount &&
            track.info.toolId == take.info.toolId && track.undone == take.undone)
            return i;
    }
    return std::nullopt;
}

Result<void> readTake(const Project& project, const TakeInfo& info, RecordedTime& time) {
    TakeTrack track;
    track.info = info;
    TrackBuilder builder(track);
    Result<RecordedCuts> cuts = cutsOfTake(project, info, [&](std::span<const Sample> samples) -> Result<void> {
        builder.add(samples);
        return {};
    });
    if (!cuts) return std::move(cuts).error();
    builder.finish();
    time.cuts.push_back(std::make_shared<const RecordedCuts>(std::move(*cuts)));
    time.tracks.push_back(std::move(track));
    return {};
}

} // namespace

std::uint64_t TakeTrack::tickOf(std::uint64_t sample) const noexcept {
    const auto next = std::ranges::upper_bound(gaps, sample, {}, &AfterGap::sample);
    return next == gaps.begin() ? sample : std::prev(next)->tick + (sample - std::prev(next)->sample);
}

std::uint64_t TakeTrack::sampleOf(std::uint64_t tick) const noexcept {
    const auto next = std::ranges::upper_bound(gaps, tick, {}, &AfterGap::tick);
    const std::uint64_t sample = next == gaps.begin() ? tick : std::prev(next)->sample + (tick - std::prev(next)->tick);
    return next == gaps.end() ? sample : std::min(sample, next->sample);
}

double RecordedTime::seconds() const noexcept {
    double all = 0.0;
    for (const TakeTrack& track : tracks) all += track.seconds();
    return all;
}

TakeMoment RecordedTime::momentAt(double seconds) const noexcept {
    double rest = std::max(0.0, seconds);
    for (const TakeTrack& track : tracks) {
        if (rest <= track.seconds() || &track == &tracks.back()) {
            const auto samples = static_cast<std::uint64_t>(rest / track.info.tickPeriod + 0.5);
            return {track.info.id, std::min(samples, track.info.sampleCount)};
        }
        rest -= track.seconds();
    }
    return {};
}

double RecordedTime::secondsAt(const TakeMoment& moment) const noexcept {
    const bool there = trackOf(moment.take) != nullptr; // a removed take keeps its position in the order
    double before = 0.0;
    for (const TakeTrack& track : tracks) {
        if (track.info.id == moment.take)
            return before +
                   static_cast<double>(std::min(moment.samples, track.info.sampleCount)) * track.info.tickPeriod;
        if (!there && order.placeOf(track.info.id) > order.placeOf(moment.take)) break;
        before += track.seconds();
    }
    return before;
}

const TakeTrack* RecordedTime::trackOf(std::int64_t take) const noexcept {
    const auto found = std::ranges::find(tracks, take, [](const TakeTrack& track) { return track.info.id; });
    return found == tracks.end() ? nullptr : &*found;
}

Result<RecordedTime> readRecordedTime(const Project& project, const RecordedTime* before) {
    const Result<std::vector<TakeInfo>> infos = project.takes();
    if (!infos) return infos.error();
    RecordedTime time;
    for (const TakeInfo& info : *infos) {
        Result<TakeOutline> outline = project.takeOutline(info.id);
        if (!outline) return std::move(outline).error();
        Result<std::vector<SampleRange>> off = project.switchedOff(info.id);
        if (!off) return std::move(off).error();
        const std::optional<std::size_t> known = before != nullptr ? knownTake(*before, *outline) : std::nullopt;
        if (known) {
            time.tracks.push_back(before->tracks[*known]);
            time.cuts.push_back(before->cuts[*known]);
        } else if (Result<void> read = readTake(project, info, time); !read) {
            return std::move(read).error();
        }
        TakeTrack& track = time.tracks.back();
        track.info = info;
        track.undone = std::move(outline->undone);
        track.switchedOff = std::move(*off);
    }
    Result<std::vector<TimeMarker>> markers = project.markers();
    if (!markers) return std::move(markers).error();
    time.markers = std::move(*markers);
    Result<TakeOrder> order = project.takeOrder();
    if (!order) return std::move(order).error();
    time.order = std::move(*order);
    const Result<RecordedState> state = project.recordedState();
    if (!state) return state.error();
    time.state = *state;
    const Result<std::vector<TakeMoment>> moments = project.keptMoments();
    if (!moments) return moments.error();
    for (const TakeMoment& moment : *moments) {
        Result<KeptWorkpiece> kept = project.keptWorkpiece(moment);
        if (!kept) return std::move(kept).error();
        time.kept.push_back(std::move(*kept));
    }
    return time;
}

} // namespace burin
