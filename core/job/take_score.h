// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"
#include "core/job/recorded_cuts.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// The values that a take is scored by. All except `duration` are computed from the samples that were not undone,
/// whether they are switched off or not, so a reference that is switched off keeps its score. "Milling" is time with
/// the spindle turning, "cutting" a tick in which material was removed.
enum class ScoreValue : std::uint8_t {
    duration,    ///< s: TakeInfo::seconds, so undone and missed ticks count
    milling,     ///< s: from the first to the last tick of each uninterrupted interval of milling; missed ticks count
    gougeTries,  ///< intervals of milling in which the hand pushed into the part, see `PushLimit`
    largestPush, ///< mm: greatest distance in these intervals from the tip commanded by the hand to the tip of the tool
    smoothness,  ///< spectral arc length of the tip's speed while milling, without pauses (tip_smoothness.h); negative
    meanForce,   ///< N: mean of the cutting force while cutting
    peakForce,   ///< N: greatest cutting force
    /// mm³: volume that the take removed when it was recorded. Computed with the voxels of the present stock: they are
    /// those of the recording, as the stock of a setup with takes cannot be changed.
    removed,
    removalRate, ///< mm³/s: `removed` divided by `milling`
    /// mm of stock on the part after the take, along the part's normal (core/verify/excess.h): mean over the area that
    /// the take's tool can reach. The workpiece results from the earlier takes, as far as they are in effect, and from
    /// the cuts of this take. Empty without a part, and for takes in which the tool was tilted.
    meanStockLeft,
    mostStockLeft, ///< mm: greatest value of the same, at most `longestExcess`
};
inline constexpr std::size_t scoreValues = 11;
inline constexpr std::array allScoreValues{
    ScoreValue::duration,    ScoreValue::milling,       ScoreValue::gougeTries,    ScoreValue::largestPush,
    ScoreValue::smoothness,  ScoreValue::meanForce,     ScoreValue::peakForce,     ScoreValue::removed,
    ScoreValue::removalRate, ScoreValue::meanStockLeft, ScoreValue::mostStockLeft,
};
static_assert(allScoreValues.size() == scoreValues);

/// Returns the JSON key, with the unit: "duration_s", "removed_mm3", …
std::string_view keyOf(ScoreValue value) noexcept;
/// Returns the unit, "" for a value without one: "s", "mm³/s".
std::string_view unitOf(ScoreValue value) noexcept;
TextId titleOf(ScoreValue value) noexcept;   ///< "Duration", to be translated
TextId toolTipOf(ScoreValue value) noexcept; ///< its definition, to be translated

/// The limit above which the hand pushes into the part. A try to gouge begins when the part blocks the tool and the tip
/// commanded by the hand is farther than `deep` from the tip of the tool. It ends when that distance falls below half
/// of `deep` or the part no longer blocks the tool, so tremor at the limit is one try. Ticks in which a fixture, the
/// machine's travel or a guide also blocked the tool don't count, nor those without a valid reading: there the distance
/// is not the depth in the part.
struct PushLimit {
    double deep = 0.1; ///< mm
};

/// A take and its values. Empty for a value that does not exist, such as the force of a take that cut nothing.
struct TakeScore {
    std::int64_t take = 0;
    std::string name;
    std::array<std::optional<double>, scoreValues> values;

    std::optional<double>& operator[](ScoreValue value) noexcept { return values[static_cast<std::size_t>(value)]; }
    const std::optional<double>& operator[](ScoreValue value) const noexcept {
        return values[static_cast<std::size_t>(value)];
    }
};

/// The part of a score that follows from the recording alone, and the inputs for the rest. Holds values only, so the
/// thread that computes the score needs no project.
struct ScoreMatter {
    TakeScore score;                ///< without stock left, removed volume and removal rate
    std::uint64_t removedUnits = 0; ///< removed volume in run units
    bool upright = true;            ///< the tool was never tilted while milling
    RecordedWork work;              ///< results in the workpiece after the take
    Tool tool;
};

/// Reads a take of the setup in use. Cost: some µs per sample, and the cost of restoring the workpiece before the take.
/// Errors: nameUnknown (not a take of the setup), cancelled, those of recordedWork.
Result<ScoreMatter> scoreMatter(const Project& project, std::int64_t take, const Progress& progress,
                                const PushLimit& limit = {});
/// The same for a take and then for the reference that it is compared with, if any. Errors: also argumentInvalid (both
/// are the same take).
Result<std::vector<ScoreMatter>> scoreMatters(const Project& project, std::int64_t take,
                                              std::optional<std::int64_t> reference, const Progress& progress);

/// Thread-safe. Takes seconds: cuts and measures the workpiece. @param milling of the take's setup; its tool is ignored
/// Errors: those of workpieceOf and measureExcess, cancelled.
Result<TakeScore> takeScore(ScoreMatter matter, const MillingContext& milling, Progress& progress);
/// Scores one after the other, in the given order.
Result<std::vector<TakeScore>> takeScores(std::vector<ScoreMatter> matters, const MillingContext& milling,
                                          Progress& progress);

/// The comparison of a value with that of the reference.
struct ScoreVerdict {
    enum class Kind : std::uint8_t { none, same, better, worse }; ///< none: either take lacks the value
    Kind kind = Kind::none;
    double difference = 0.0;       ///< >= 0, in the value's unit
    std::optional<double> ratio{}; ///< of the value to that of the reference; empty if the latter is 0 or missing
};
/// Greater is better for smoothness, removed volume and removal rate, less is better for all others. Same: within 0.5 %
/// of the reference.
ScoreVerdict verdictOf(ScoreValue value, const TakeScore& take, const TakeScore& reference) noexcept;

} // namespace burin
