// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/recorded_cuts.h"

#include <cstdint>
#include <vector>

namespace burin {

/// What a recording can be drawn by over its time.
enum class TrackCurve : std::uint8_t {
    force,      ///< N: greatest cutting force
    removal,    ///< mm³/s: volume removed per time
    feed,       ///< mm/s: way of the tip per time
    engagement, ///< mm²: volume removed per way, the area of the cut that the tool moves on with; 0 where it rests
    pushBack,   ///< mm: greatest distance from where the hand wanted the tip to where it was allowed to be
    height,     ///< mm, setup frame: greatest Z of the tip
};
inline constexpr std::size_t trackCurves = 6;

/// A recording as a timeline draws it.
struct TakeTrack {
    static constexpr std::uint64_t samplesPerBin = 10;

    TakeInfo info;
    std::vector<SampleRange> strokes; ///< with the spindle turning, those that were taken back among them
    std::vector<SampleRange> undone;  ///< that count no more, taken back or switched off
    std::vector<SampleRange> switchedOff;
    std::vector<std::uint64_t> steps; ///< samples that one steps to; empty: where strokes begin
    /// By curve, a value for each ten samples; the last one of fewer.
    std::array<std::vector<float>, trackCurves> curves;

    /// s; a tick that was missed takes no time.
    double seconds() const noexcept { return static_cast<double>(info.sampleCount) * info.tickPeriod; }
};

/// The recordings of a setup, read once for all that goes along their time.
struct RecordedTime {
    std::vector<TakeTrack> tracks;   ///< in order
    std::vector<SharedCuts> cuts;    ///< of the same takes
    std::vector<KeptWorkpiece> kept; ///< that hold
    std::vector<TimeMarker> markers; ///< in order
    RecordedState state;             ///< that all of it is of

    double seconds() const noexcept; ///< of all takes, one behind the other
    /// The moment at a time from the first take's start on; within what there is. There must be a take.
    TakeMoment momentAt(double seconds) const noexcept;
    double secondsAt(const TakeMoment& moment) const noexcept;  ///< the inverse, to a sample
    const TakeTrack* trackOf(std::int64_t take) const noexcept; ///< null: there is none
};

/// Reads all recordings of the setup in use. Errors: those of Project, toolFor.
/// @param before what was read earlier: of takes that are as they were then nothing is read again; null: nothing was
/// Cost: about a µs a sample; memory: about 3 bytes a sample, and 28 a motion that cut.
Result<RecordedTime> readRecordedTime(const Project& project, const RecordedTime* before = nullptr);

} // namespace burin
