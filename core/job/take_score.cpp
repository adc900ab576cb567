// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/take_score.h"

#include "core/geometry/upright.h"
#include "core/recording/tip_smoothness.h"
#include "core/verify/excess.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

struct ScoreRow {
    ScoreValue value;
    std::string_view key, unit;
    bool moreIsBetter;
    TextId title, toolTip;
};
constexpr std::array scoreRows{
    ScoreRow{ScoreValue::duration, "duration_s", "s", false, BURIN_TEXT("ScoreValue", "Duration"),
             BURIN_TEXT("ScoreValue", "Time of the whole recording")},
    ScoreRow{ScoreValue::milling, "milling_s", "s", false, BURIN_TEXT("ScoreValue", "Milling time"),
             BURIN_TEXT("ScoreValue", "Time with the spindle turning")},
    ScoreRow{ScoreValue::gougeTries, "gouge_tries", "", false, BURIN_TEXT("ScoreValue", "Tries to gouge"),
             BURIN_TEXT("ScoreValue",
                        "How often the hand pushed the tool more than 0.1 mm against the part, which stopped it")},
    ScoreRow{ScoreValue::largestPush, "largest_push_mm", "mm", false, BURIN_TEXT("ScoreValue", "Largest push"),
             BURIN_TEXT("ScoreValue", "How far the hand pushed into the part at most")},
    ScoreRow{ScoreValue::smoothness, "smoothness_sparc", "", true, BURIN_TEXT("ScoreValue", "Smoothness"),
             BURIN_TEXT("ScoreValue",
                        "Spectral arc length (SPARC) of the tip's speed while milling, without pauses: one "
                        "smooth movement has -1.41, a lower value means more tremor and interruptions")},
    ScoreRow{ScoreValue::meanForce, "mean_force_n", "N", false, BURIN_TEXT("ScoreValue", "Mean force"),
             BURIN_TEXT("ScoreValue", "Mean cutting force while material is removed")},
    ScoreRow{ScoreValue::peakForce, "peak_force_n", "N", false, BURIN_TEXT("ScoreValue", "Peak force"),
             BURIN_TEXT("ScoreValue", "Largest cutting force")},
    ScoreRow{ScoreValue::removed, "removed_mm3", "mm³", true, BURIN_TEXT("ScoreValue", "Removed"),
             BURIN_TEXT("ScoreValue", "Volume that the take removed when it was recorded")},
    ScoreRow{ScoreValue::removalRate, "removal_rate_mm3_s", "mm³/s", true, BURIN_TEXT("ScoreValue", "Removal rate"),
             BURIN_TEXT("ScoreValue", "Volume removed, divided by the milling time")},
    ScoreRow{ScoreValue::meanStockLeft, "stock_left_mean_mm", "mm", false, BURIN_TEXT("ScoreValue", "Stock left, mean"),
             BURIN_TEXT("ScoreValue", "Stock on the part after the take, on average where its tool can reach")},
    ScoreRow{ScoreValue::mostStockLeft, "stock_left_most_mm", "mm", false,
             BURIN_TEXT("ScoreValue", "Stock left, largest"),
             BURIN_TEXT("ScoreValue", "The thickest stock there; 20 mm means 20 mm or more")},
};
static_assert(scoreRows.size() == scoreValues);

const ScoreRow& rowOf(ScoreValue value) noexcept {
    return *std::ranges::find(scoreRows, value, &ScoreRow::value);
}

Error scoringCancelled() {
    return {ErrorCode::cancelled, "scoring a take", {}, {}};
}

/// Finds the tries to gouge in the milling ticks.
class PushMeter {
public:
    explicit PushMeter(const PushLimit& limit) noexcept : limit_(limit) {}

    void add(const Sample& sample) noexcept {
        constexpr std::uint32_t otherwise = sampleOnObstacle | sampleOnGuide | sampleStylusInvalid;
        const bool held = (sample.flags & sampleOnBoundary) != 0 && (sample.flags & otherwise) == 0;
        const double push = held ? glm::distance(sample.stylusTip, sample.proxy.tip) : 0.0;
        if (push > limit_.deep && !std::exchange(pushing_, true)) ++tries_;
        if (push < 0.5 * limit_.deep) pushing_ = false;
        if (pushing_) largest_ = std::max(largest_, push);
    }
    void interrupt() noexcept { pushing_ = false; }
    std::size_t tries() const noexcept { return tries_; }
    double largest() const noexcept { return largest_; } ///< mm

private:
    PushLimit limit_;
    bool pushing_ = false;
    std::size_t tries_ = 0;
    double largest_ = 0.0;
};

/// Computes the part of a score that follows from the samples of a take.
class ScoreMeter {
public:
    /// @param takenBack undone intervals; must outlive the meter
    ScoreMeter(std::span<const SampleRange> takenBack, double tickPeriod, const PushLimit& limit)
        : takenBack_(takenBack), tickPeriod_(tickPeriod), smoothness_(tickPeriod), pushes_(limit) {}

    void add(std::span<const Sample> samples) {
        for (const Sample& sample : samples) {
            const bool milling = !takenBack_.holds(samples_++) && (sample.flags & sampleSpindleOff) == 0;
            if (milling)
                mill(sample);
            else
                interrupt();
        }
    }
    void finishInto(ScoreMatter& matter) {
        interrupt();
        TakeScore& score = matter.score;
        score[ScoreValue::milling] = static_cast<double>(milled_) * tickPeriod_;
        score[ScoreValue::gougeTries] = static_cast<double>(pushes_.tries());
        score[ScoreValue::largestPush] = pushes_.largest();
        score[ScoreValue::smoothness] = smoothness_.mean();
        if (cutting_ > 0) {
            score[ScoreValue::meanForce] = force_ / static_cast<double>(cutting_);
            score[ScoreValue::peakForce] = peakForce_;
        }
        matter.removedUnits = units_;
        matter.upright = upright_;
    }

private:
    void mill(const Sample& sample) {
        if (previous_ && sample.tick > *previous_) milled_ += sample.tick - *previous_;
        previous_ = sample.tick;
        smoothness_.add(sample);
        pushes_.add(sample);
        upright_ = upright_ && isUpright(sample.proxy.axis);
        for (const RemovedMaterial& removed : sample.removed) units_ += removed.units;
        if (!(sample.reportedRemoval > 0.0)) return;
        ++cutting_;
        const double force = glm::length(sample.cuttingForce);
        force_ += force;
        peakForce_ = std::max(peakForce_, force);
    }
    void interrupt() {
        previous_.reset();
        smoothness_.interrupt();
        pushes_.interrupt();
    }

    UndoneSamples takenBack_;
    double tickPeriod_; ///< s
    TipSmoothness smoothness_;
    PushMeter pushes_;
    std::uint64_t samples_ = 0, milled_ = 0, cutting_ = 0, units_ = 0;
    std::optional<std::uint64_t> previous_; ///< tick of the sample before, if that milled
    double force_ = 0.0, peakForce_ = 0.0;  ///< N: sum, and greatest value
    bool upright_ = true;
};

struct ScoredTake {
    TakeInfo info;
    TakeMoment before; ///< end of the take before it
};

Result<ScoredTake> takeOfSetup(const Project& project, std::int64_t take) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    std::string known;
    TakeMoment before;
    for (const TakeInfo& info : *takes) {
        if (info.id == take) return ScoredTake{info, before};
        before = {info.id, info.sampleCount};
        known.append(known.empty() ? "" : ", ").append(std::to_string(info.id));
    }
    if (takes->empty()) return Error{ErrorCode::projectIncomplete, "recording", "burin mill", {}};
    return Error{ErrorCode::nameUnknown, "take", std::to_string(take), known};
}

/// Measures the workpiece after a take: the result of the earlier takes, as far as they are in effect, and of its own
/// cuts.
Result<void> measureStockLeft(const ScoreMatter& matter, const MillingContext& milling, RunVolume stock,
                              TakeScore& score, Progress& progress) {
    const VolumeKind like{stock.grid(), stock.properties()};
    const auto cut = [&] {
        const ProgressPart cutting(progress, 0.0, 0.5);
        return workpieceOf(
            matter.work, [&stock] { return Result<RunVolume>(std::move(stock)); }, progress, like);
    };
    const Result<RunVolume> workpiece = cut();
    if (!workpiece) return workpiece.error();
    const ProgressPart measuring(progress, 0.5, 1.0);
    VerifyRequest request;
    request.partModel = milling.partModel.get();
    request.part = &milling.part;
    const Result<std::vector<DeviationSample>> left = measureExcess(*workpiece, request, {&matter.tool, 1}, progress);
    if (!left) return left.error();
    const ExcessSummary summary = summaryOf(*left);
    if (summary.reachableShare == 0.0) return {};
    score[ScoreValue::meanStockLeft] = summary.mean;
    score[ScoreValue::mostStockLeft] = summary.most;
    return {};
}

} // namespace

std::string_view keyOf(ScoreValue value) noexcept {
    return rowOf(value).key;
}

std::string_view unitOf(ScoreValue value) noexcept {
    return rowOf(value).unit;
}

TextId titleOf(ScoreValue value) noexcept {
    return rowOf(value).title;
}

TextId toolTipOf(ScoreValue value) noexcept {
    return rowOf(value).toolTip;
}

Result<ScoreMatter> scoreMatter(const Project& project, std::int64_t take, const Progress& progress,
                                const PushLimit& limit) {
    const Result<ScoredTake> scored = takeOfSetup(project, take);
    if (!scored) return scored.error();
    const TakeInfo& info = scored->info;
    Result<std::vector<SampleRange>> takenBack = project.takenBack(take);
    if (!takenBack) return std::move(takenBack).error();
    Result<Tool> tool = toolFor(project, info.toolId);
    if (!tool) return std::move(tool).error();
    const auto goOn = [&progress](std::span<const Sample>) -> Result<void> {
        if (progress.cancelled()) return scoringCancelled();
        return {};
    };
    Result<RecordedWork> before = recordedWork(project, scored->before, true, goOn);
    if (!before) return std::move(before).error();
    ScoreMatter matter{{take, info.name, {}}, 0, true, std::move(*before), *tool};
    matter.score[ScoreValue::duration] = info.seconds;
    RecordedCuts own{take, std::move(*tool), {}, 0, info.sampleCount};
    CutFinder finder(*takenBack);
    ScoreMeter meter(*takenBack, info.tickPeriod, limit);
    const auto keep = [&own](const ToolPose& from, const ToolPose& to, std::uint64_t sample) -> Result<void> {
        own.motions.add(from, to, sample);
        return {};
    };
    Result<void> read = project.visitSamples(take, [&](std::span<const Sample> samples) -> Result<void> {
        if (progress.cancelled()) return scoringCancelled();
        meter.add(samples);
        return finder.find(samples, keep);
    });
    if (!read) return std::move(read).error();
    meter.finishInto(matter);
    matter.work.cuts.push_back(std::move(own));
    return matter;
}

Result<std::vector<ScoreMatter>> scoreMatters(const Project& project, std::int64_t take,
                                              std::optional<std::int64_t> reference, const Progress& progress) {
    if (take == reference)
        return Error{ErrorCode::argumentInvalid, "reference", std::to_string(take),
                     "another take than the one that is scored"};
    std::vector<ScoreMatter> matters;
    for (const std::optional<std::int64_t>& each : {std::optional(take), reference}) {
        if (!each) continue;
        Result<ScoreMatter> matter = scoreMatter(project, *each, progress);
        if (!matter) return std::move(matter).error();
        matters.push_back(std::move(*matter));
    }
    return matters;
}

Result<TakeScore> takeScore(ScoreMatter matter, const MillingContext& milling, Progress& progress) {
    TakeScore score = std::move(matter.score);
    Result<RunVolume> stock = milling.stock->makeStock(progress);
    if (!stock) return std::move(stock).error();
    const double removed = static_cast<double>(matter.removedUnits) * stock->grid().unitVolume();
    score[ScoreValue::removed] = removed;
    if (score[ScoreValue::milling] > 0.0) score[ScoreValue::removalRate] = removed / *score[ScoreValue::milling];
    if (matter.upright && !milling.partModel->bodies.empty())
        if (Result<void> left = measureStockLeft(matter, milling, std::move(*stock), score, progress); !left)
            return std::move(left).error();
    progress.report(1.0);
    return score;
}

Result<std::vector<TakeScore>> takeScores(std::vector<ScoreMatter> matters, const MillingContext& milling,
                                          Progress& progress) {
    std::vector<TakeScore> scores;
    const double all = static_cast<double>(matters.size());
    for (ScoreMatter& matter : matters) {
        const double done = static_cast<double>(scores.size());
        const ProgressPart part(progress, done / all, (done + 1.0) / all);
        Result<TakeScore> score = takeScore(std::move(matter), milling, progress);
        if (!score) return std::move(score).error();
        scores.push_back(std::move(*score));
    }
    return scores;
}

ScoreVerdict verdictOf(ScoreValue value, const TakeScore& take, const TakeScore& reference) noexcept {
    constexpr double alike = 0.005;
    const std::optional<double>&own = take[value], &other = reference[value];
    if (!own || !other) return {};
    ScoreVerdict verdict{ScoreVerdict::Kind::same, std::abs(*own - *other), std::nullopt};
    if (*other != 0.0) verdict.ratio = *own / *other;
    if (verdict.difference > alike * std::abs(*other))
        verdict.kind =
            (*own > *other) == rowOf(value).moreIsBetter ? ScoreVerdict::Kind::better : ScoreVerdict::Kind::worse;
    return verdict;
}

} // namespace burin
