// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/recorded_cuts.h"

#include <cstdint>
#include <vector>

namespace burin {

/// A quantity of a recording that can be drawn over time.
enum class TrackCurve : std::uint8_t {
    force,      ///< N: largest cutting force
    removal,    ///< mm³/s: volume removed per time
    feed,       ///< mm/s: distance moved by the tip per time
    engagement, ///< mm²: volume removed per distance moved, the cross-section of the cut; 0 while the tool rests
    pushBack,   ///< mm: largest distance from the commanded to the allowed position of the tip
    height,     ///< mm, setup frame: largest Z of the tip
    deviation,  ///< mm: least distance of the tool from the part, < 0: it cuts into the part (take_deviation.h)
};
inline constexpr std::size_t trackCurves = 7;

/// A recording as drawn in a timeline.
struct TakeTrack {
    static constexpr std::uint64_t samplesPerBin = 10;

    TakeInfo info;
    std::vector<SampleRange> strokes; ///< with the spindle turning, including undone ones
    std::vector<SampleRange> undone;  ///< ignored, as undone or switched off
    std::vector<SampleRange> switchedOff;
    std::vector<std::uint64_t> steps; ///< samples at which stepping stops; empty: where strokes begin
    /// Per curve, one value for every ten samples; the last value can cover fewer. The deviation is empty until it is
    /// computed, and for programs; NaN where there is no part.
    std::array<std::vector<float>, trackCurves> curves;
    /// A sample before which ticks were missed, and its tick; in order.
    struct AfterGap {
        std::uint64_t sample = 0, tick = 0;
    };
    std::vector<AfterGap> gaps;

    /// Returns the duration, s; missed ticks take no time.
    double seconds() const noexcept { return static_cast<double>(info.sampleCount) * info.tickPeriod; }
    std::uint64_t tickOf(std::uint64_t sample) const noexcept;
    /// Returns the sample of a tick; for a missed tick, the next sample. May be sampleCount or more.
    std::uint64_t sampleOf(std::uint64_t tick) const noexcept;
};

/// The recordings of a setup, read once for everything that is shown over time.
struct RecordedTime {
    std::vector<TakeTrack> tracks;   ///< in order
    std::vector<SharedCuts> cuts;    ///< of the same takes
    std::vector<KeptWorkpiece> kept; ///< the valid ones
    std::vector<TimeMarker> markers; ///< in order
    TakeOrder order;                 ///< of all takes, including removed ones; empty for a program
    RecordedState state;             ///< from which all of it was read

    double seconds() const noexcept; ///< of all takes in sequence
    /// Returns the moment at a time from the start of the first take, limited to the recorded range. There must be a
    /// take.
    TakeMoment momentAt(double seconds) const noexcept;
    double secondsAt(const TakeMoment& moment) const noexcept;  ///< the inverse, exact to a sample
    const TakeTrack* trackOf(std::int64_t take) const noexcept; ///< null: there is none
};

/// Reads all recordings of the setup in use. Errors: those of Project, toolFor.
/// @param before an earlier result: unchanged takes are not read again; null: none
/// Cost: about 1 µs per sample; memory: about 3 bytes per sample, and 28 per cutting motion.
Result<RecordedTime> readRecordedTime(const Project& project, const RecordedTime* before = nullptr);

} // namespace burin
