// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/program_time.h"

#include "core/verify/tool_moves.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double shortestTick = 0.01;   // s
constexpr double mostTicks = 540'000.0; // an hour and a half of the shortest

/// A straight move with its start and end time.
struct TimedMove {
    ToolMove move;
    double start = 0.0, end = 0.0; ///< s
};

/// Divides each motion's time among its chords in proportion to their length.
std::vector<TimedMove> timed(const std::vector<ToolMove>& moves, const std::vector<MotionTime>& times) {
    std::vector<TimedMove> all;
    const auto lengthOf = [](const ToolMove& move) {
        return move.endKnown ? glm::distance(move.begin().tip, move.to.tip) : 0.0;
    };
    for (std::size_t i = 0; i < moves.size();) {
        std::size_t end = i;
        double length = 0.0;
        while (end < moves.size() && moves[end].motion == moves[i].motion) length += lengthOf(moves[end++]);
        const MotionTime time = moves[i].motion < times.size() ? times[moves[i].motion] : MotionTime{};
        double at = time.start;
        for (; i < end; ++i) {
            const double share = length > 0.0 ? lengthOf(moves[i]) / length : 1.0 / static_cast<double>(end - i);
            const double until = i + 1 == end ? time.start + time.duration : at + share * time.duration;
            all.push_back({moves[i], at, until});
            at = until;
        }
    }
    return all;
}

/// Makes the takes of a program, each with one tool, tick by tick.
class Spreader {
public:
    Spreader(const CheckedProgram& program, double tick) : program_(program) { made_.tick = tick; }

    Result<void> add(const TimedMove& timed, const Progress& progress) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "program", {}, {}};
        if (!timed.move.endKnown) return {};
        beginTake(timed);
        const ToolPose from = timed.move.begin(), to = timed.move.to;
        const double length = timed.end - timed.start;
        ToolPose before = from;
        // To each tick within the move, then to its end: the path is that of the program, independent of the ticks.
        for (double at = nextTick(); at < timed.end; at = nextTick()) {
            const double share = length > 0.0 ? std::clamp((at - timed.start) / length, 0.0, 1.0) : 1.0;
            const ToolPose now{glm::mix(from.tip, to.tip, share), to.axis};
            move(before, now);
            tickAt(now, timed.move.motion);
            before = now;
        }
        move(before, to);
        last_ = to;
        lastMotion_ = timed.move.motion;
        return {};
    }

    ProgramTime finish(double seconds) {
        if (!made_.time.tracks.empty()) {
            for (double at = nextTick(); at <= seconds; at = nextTick()) tickAt(last_, lastMotion_);
            tickAt(last_, lastMotion_); // the remainder of the last tick
            endTake();
        }
        return std::move(made_);
    }

private:
    /// Returns the time of the next tick, s of the program.
    double nextTick() const noexcept { return made_.tick * static_cast<double>(made_.poses.size() + 1); }

    void beginTake(const TimedMove& timed) {
        const int number = program_.parsed.motions[timed.move.motion].tool;
        if (!made_.time.tracks.empty() && number == number_) return;
        const Tool* tool = program_.toolNumbered(number);
        if (!made_.time.tracks.empty()) endTake();
        number_ = number;
        TakeTrack track;
        track.info.id = static_cast<std::int64_t>(made_.time.tracks.size()) + 1;
        track.info.tickPeriod = made_.tick;
        track.info.toolId = tool != nullptr ? tool->id : std::string();
        track.info.name = tool != nullptr ? tool->name : std::string();
        made_.time.tracks.push_back(std::move(track));
        cuts_ = {made_.time.tracks.back().info.id, tool != nullptr ? *tool : Tool{}, {}, 0, 0};
        made_.first.push_back(made_.poses.size());
        if (made_.poses.empty()) last_ = timed.move.begin();
        // During the time before, such as a tool change, the tool stays where it was.
        for (double at = nextTick(); at <= timed.start; at = nextTick()) tickAt(last_, timed.move.motion);
    }
    void endTake() {
        const std::uint64_t count = made_.poses.size() - made_.first.back();
        made_.time.tracks.back().info.sampleCount = count;
        cuts_.sampleCount = count;
        made_.time.cuts.push_back(std::make_shared<const RecordedCuts>(std::move(cuts_)));
        cuts_ = {};
    }
    /// Adds a motion, which ends with the next tick.
    void move(const ToolPose& from, const ToolPose& to) {
        if (from.tip == to.tip && from.axis == to.axis) return;
        cuts_.motions.add(from, to, made_.poses.size() - made_.first.back());
    }
    void tickAt(const ToolPose& pose, std::uint32_t motion) {
        made_.poses.push_back(pose);
        made_.motions.push_back(motion);
    }

    const CheckedProgram& program_;
    ProgramTime made_;
    RecordedCuts cuts_; ///< of the newest take
    ToolPose last_;
    std::uint32_t lastMotion_ = 0;
    int number_ = 0;
};

/// Adds curves in bins, as for a recording.
void addCurves(ProgramTime& made, const CheckedProgram& program) {
    const auto valuesOf = [&](std::size_t take, TrackCurve curve) -> std::vector<float>& {
        return made.time.tracks[take].curves[static_cast<std::size_t>(curve)];
    };
    constexpr std::uint64_t bin = TakeTrack::samplesPerBin;
    for (std::size_t take = 0; take < made.time.tracks.size(); ++take) {
        const std::uint64_t count = made.time.tracks[take].info.sampleCount;
        for (auto& values : made.time.tracks[take].curves) values.assign((count + bin - 1) / bin, 0.0F);
        valuesOf(take, TrackCurve::deviation).clear();
        std::vector<float>& feed = valuesOf(take, TrackCurve::feed);
        std::vector<float>& height = valuesOf(take, TrackCurve::height);
        for (std::uint64_t i = 0; i < count; ++i) {
            const std::uint64_t place = made.first[take] + i;
            const glm::dvec3 tip = made.poses[place].tip;
            const glm::dvec3 before = made.poses[place > 0 ? place - 1 : 0].tip;
            feed[i / bin] += static_cast<float>(glm::distance(before, tip) / (made.tick * static_cast<double>(bin)));
            height[i / bin] =
                i % bin == 0 ? static_cast<float>(tip.z) : std::max(height[i / bin], static_cast<float>(tip.z));
        }
    }
    const auto atEach = [&](double start, double duration, const auto& use) {
        const auto from = static_cast<std::uint64_t>(std::max(0.0, start / made.tick));
        const auto to = static_cast<std::uint64_t>(std::max(0.0, (start + duration) / made.tick));
        for (std::size_t take = 0; take < made.time.tracks.size(); ++take) {
            const std::uint64_t first = made.first[take], end = first + made.time.tracks[take].info.sampleCount;
            if (to < first || from >= end) continue;
            const std::uint64_t last = std::min(to, end - 1) - first;
            for (std::uint64_t b = (std::max(from, first) - first) / bin; b <= last / bin; ++b) use(take, b);
        }
    };
    for (const LoadStep& load : program.report.loadSteps)
        atEach(load.start, load.duration, [&](std::size_t take, std::uint64_t b) {
            float& force = valuesOf(take, TrackCurve::force)[b];
            force = std::max(force, load.force);
        });
    for (const MotionLoad& load : program.report.loads)
        atEach(load.start, load.duration, [&](std::size_t take, std::uint64_t b) {
            float& removal = valuesOf(take, TrackCurve::removal)[b];
            removal = std::max(removal, static_cast<float>(load.removalRate));
        });
    for (std::size_t take = 0; take < made.time.tracks.size(); ++take)
        for (std::size_t b = 0; b < valuesOf(take, TrackCurve::feed).size(); ++b) {
            const float feed = valuesOf(take, TrackCurve::feed)[b];
            if (feed > 0.0F) valuesOf(take, TrackCurve::engagement)[b] = valuesOf(take, TrackCurve::removal)[b] / feed;
        }
}

/// Adds the ranges in which the tool cuts at feed, and each motion, for stepping from block to block.
void addStrokes(ProgramTime& made, const CheckedProgram& program) {
    for (std::size_t take = 0; take < made.time.tracks.size(); ++take) {
        TakeTrack& track = made.time.tracks[take];
        for (std::uint64_t i = 0; i < track.info.sampleCount; ++i) {
            const std::uint32_t motion = made.motions[made.first[take] + i];
            if (track.steps.empty() || motion != made.motions[made.first[take] + i - 1]) track.steps.push_back(i);
            const NcMotion& now = program.parsed.motions[motion];
            if (now.rapid() || now.kind == NcMotionKind::dwell || !now.spindleOn()) continue;
            if (!track.strokes.empty() && track.strokes.back().first + track.strokes.back().count == i)
                ++track.strokes.back().count;
            else
                track.strokes.push_back({i, 1});
        }
    }
}

/// Adds findings at the first motion of their lines. A line without a move has no time.
void addFindings(ProgramTime& made, const CheckedProgram& program) {
    const std::vector<Finding>& all = program.report.findings;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Finding& finding = all[i];
        const auto motion = std::ranges::lower_bound(program.parsed.motions, finding.line, {}, &NcMotion::line);
        if (motion == program.parsed.motions.end() || motion->line != finding.line) continue;
        const auto place = static_cast<std::size_t>(motion - program.parsed.motions.begin());
        const TakeMoment at = made.beginOf(place);
        if (at.take != 0) made.findings.push_back({at, i});
    }
    std::ranges::stable_sort(
        made.findings, {}, [&](const ProgramTime::FindingMoment& finding) { return made.time.secondsAt(finding.at); });
}

} // namespace

std::size_t ProgramTime::motionAt(const TakeMoment& moment) const noexcept {
    return motions[static_cast<std::size_t>(std::min<std::uint64_t>(ticksBefore(moment), motions.size() - 1))];
}

ToolPose ProgramTime::poseAt(const TakeMoment& moment) const noexcept {
    const std::uint64_t over = ticksBefore(moment);
    return poses[static_cast<std::size_t>(std::min<std::uint64_t>(over > 0 ? over - 1 : 0, poses.size() - 1))];
}

std::uint64_t ProgramTime::ticksBefore(const TakeMoment& moment) const noexcept {
    const auto take = static_cast<std::size_t>(std::max<std::int64_t>(1, moment.take)) - 1;
    return first[std::min(take, first.size() - 1)] + moment.samples;
}

TakeMoment ProgramTime::beginOf(std::size_t motion) const noexcept {
    // A motion shorter than a tick may have no tick: the next motion with a tick is used.
    const auto found = std::ranges::lower_bound(motions, static_cast<std::uint32_t>(motion));
    if (found == motions.end()) return {};
    const auto place = static_cast<std::uint64_t>(found - motions.begin());
    const auto take = std::ranges::upper_bound(first, place) - first.begin();
    return {take, place - first[static_cast<std::size_t>(take) - 1]};
}

Result<ProgramTime> programTime(const CheckedProgram& program, const MachineProfile& machine,
                                const glm::dvec3& workOffset, const Progress& progress) {
    const double seconds = program.report.machiningSeconds;
    Spreader spreader(program, std::max(shortestTick, seconds / mostTicks));
    for (const TimedMove& move : timed(toolMoves(program.parsed, workOffset, machine), program.report.times))
        if (Result<void> added = spreader.add(move, progress); !added) return std::move(added).error();
    ProgramTime made = spreader.finish(seconds);
    addCurves(made, program);
    addStrokes(made, program);
    addFindings(made, program);
    return made;
}

} // namespace burin
