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

/// What a take is scored by. All but `duration` is of the samples that were not taken back, whether they are switched
/// off or not: a reference that is switched off keeps its score. "Milling" is time with the spindle turning, "cutting"
/// a tick in which material was removed.
enum class ScoreValue : std::uint8_t {
    duration,    ///< s: ticks of the take times their period, those that were taken back among them
    milling,     ///< s: the same of milling
    gougeTries,  ///< intervals of milling in which the hand pushed into the part, see `PushLimit`
    largestPush, ///< mm: greatest distance in these from where the hand wanted the tip to where the part let it be
    smoothness,  ///< spectral arc length of the tip's speed while milling, without pauses (tip_smoothness.h); below 0
    meanForce,   ///< N: mean of the cutting force while cutting
    peakForce,   ///< N: greatest cutting force
    removed,     ///< mm³: what the take removed as it was recorded
    removalRate, ///< mm³/s: that, by the time of milling
    /// mm of stock on the part behind the take, along its normal (core/verify/excess.h): mean over what of the part the
    /// take's tool can reach. The workpiece is the one that the takes before it left, as far as they count, and what
    /// this one cut of it. There is none without a part, and of takes with a tool that leans.
    meanStockLeft,
    mostStockLeft, ///< mm: the greatest of it, at most `longestExcess`
};
inline constexpr std::size_t scoreValues = 11;
inline constexpr std::array allScoreValues{
    ScoreValue::duration,    ScoreValue::milling,       ScoreValue::gougeTries,    ScoreValue::largestPush,
    ScoreValue::smoothness,  ScoreValue::meanForce,     ScoreValue::peakForce,     ScoreValue::removed,
    ScoreValue::removalRate, ScoreValue::meanStockLeft, ScoreValue::mostStockLeft,
};
static_assert(allScoreValues.size() == scoreValues);

/// Key of JSON, with the unit: "duration_s", "removed_mm3", …
std::string_view keyOf(ScoreValue value) noexcept;
/// Unit, "" where it has none: "s", "mm³/s".
std::string_view unitOf(ScoreValue value) noexcept;
TextId titleOf(ScoreValue value) noexcept;   ///< "Duration", to be translated
TextId toolTipOf(ScoreValue value) noexcept; ///< its definition, to be translated

/// When a hand pushes into the part. A try begins where the part holds the tool and the hand wants the tip farther than
/// `deep` from where it is, and ends where it wants it nearer than half of that, or where the part lets go: a tremor at
/// the limit is one try. Ticks in which a fixture, the machine's travel or a guide held the tool as well don't count,
/// nor those without a valid reading: the distance is not the depth in the part there.
struct PushLimit {
    double deep = 0.1; ///< mm
};

/// A take and its values; nothing where there is none, such as a force of a take that cut nothing.
struct TakeScore {
    std::int64_t take = 0;
    std::string name;
    std::array<std::optional<double>, scoreValues> values;

    std::optional<double>& operator[](ScoreValue value) noexcept { return values[static_cast<std::size_t>(value)]; }
    const std::optional<double>& operator[](ScoreValue value) const noexcept {
        return values[static_cast<std::size_t>(value)];
    }
};

/// What of a score a recording says, and what the rest is made of. Values; no project is needed on the thread that
/// scores.
struct ScoreMatter {
    TakeScore score;                ///< without stock left, volume and rate
    std::uint64_t removedUnits = 0; ///< run units of the volume
    bool upright = true;            ///< the tool never leaned while it milled
    RecordedWork work;              ///< the workpiece behind the take
    Tool tool;
};

/// Reads a take of the setup in use. Cost: some µs a sample of it, and what making the workpiece before it takes.
/// Errors: nameUnknown (no take of the setup), cancelled, those of recordedWork.
Result<ScoreMatter> scoreMatter(const Project& project, std::int64_t take, const Progress& progress,
                                const PushLimit& limit = {});
/// Of a take, and of the reference that it is compared with; nothing: there is none. Errors: also argumentInvalid (they
/// are the same).
Result<std::vector<ScoreMatter>> scoreMatters(const Project& project, std::int64_t take,
                                              std::optional<std::int64_t> reference, const Progress& progress);

/// Any thread; seconds: the workpiece is cut and measured. @param milling of the take's setup; its tool does not count
/// Errors: those of workpieceOf and measureExcess, cancelled.
Result<TakeScore> takeScore(ScoreMatter matter, const MillingContext& milling, Progress& progress);
/// One after the other, in their order.
Result<std::vector<TakeScore>> takeScores(std::vector<ScoreMatter> matters, const MillingContext& milling,
                                          Progress& progress);

/// How a value compares with that of the reference.
struct ScoreVerdict {
    enum class Kind : std::uint8_t { none, same, better, worse }; ///< none: one of them has no such value
    Kind kind = Kind::none;
    double difference = 0.0; ///< >= 0, in the value's unit
    std::optional<double>
        ratio{}; ///< of the value to that of the reference; nothing: the latter is 0, or there is none
};
/// Better is more of smoothness, volume and rate, and less of all others. Same: within 0.5 % of the reference.
ScoreVerdict verdictOf(ScoreValue value, const TakeScore& take, const TakeScore& reference) noexcept;

} // namespace burin
