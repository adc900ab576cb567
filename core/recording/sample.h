// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/setup_id.h"
#include "core/geometry/pose.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace burin {

enum SampleFlag : std::uint32_t {
    sampleShankContact = 1u << 0,   ///< shank or holder touched something: brake and alarm
    sampleOnBoundary = 1u << 1,     ///< the part (with its allowance) or another boundary constrained the proxy
    sampleForceSaturated = 1u << 2, ///< the rendered force was limited to the device's maximum
    sampleStylusInvalid = 1u << 3,  ///< the device gave no valid reading: zero force
    sampleForcesOff = 1u << 4,      ///< force ramp-in or start inside the part: no force yet
    sampleMemoryFull = 1u << 5,     ///< the reserved memory of the volume is used up: cutting stopped
    sampleSpindleOff = 1u << 6, ///< the tool only moved: nothing was cut, stock did not stop it; never part of a path
    sampleOnGuide = 1u << 7,    ///< a guide constrained the hand or rotated the tool's axis
    sampleAxisHeld = 1u << 8,   ///< the axis does not follow the stylus for lack of room; no torque renders this
    /// a fixture, a keep-out volume, the machine's travel or the distance from the stock constrained the proxy: alarm
    sampleOnObstacle = 1u << 9,
    sampleForceLate = 1u << 10, ///< the force came too late for its reading: zero was sent instead
    sampleMotorsHot = 1u << 11, ///< the device's motors are hot: less force is requested than its limits allow
};

/// Removed volume of one material in one tick.
struct RemovedMaterial {
    std::uint64_t units = 0;   ///< run units of the volume (Grid::unitVolume), exact
    std::uint8_t property = 0; ///< index of TakeInfo::materials; 0: entry not used
};

/// One tick of a recording: the motion of the hand and its result. Frames: device pose in the device frame, everything
/// else in the setup frame.
struct Sample {
    std::uint64_t tick = 0;
    double time = 0.0;         ///< s since the take began
    Pose device;               ///< mm, device frame
    glm::dvec3 stylusTip{0.0}; ///< tip position commanded by the mapped hand, mm
    ToolPose proxy;            ///< actual pose of the tool; never inside the part grown by the allowance
    glm::dvec3 force{0.0};     ///< N, rendered by the device, setup frame; without weight compensation of its handle
    glm::dvec3 torque{0.0};    ///< N·mm, rendered by the device, setup frame; about the handle's own reference point
    glm::dvec3 cuttingForce{0.0};             ///< N, unscaled, setup frame
    double reportedRemoval = 0.0;             ///< mm³, the smoothed value from which the force is computed
    std::array<RemovedMaterial, 8> removed{}; ///< exact, by material
    std::uint32_t buttons = 0;
    std::uint32_t flags = 0; ///< SampleFlag
};
static_assert(std::is_trivially_copyable_v<Sample>);

/// An interval of a take, in samples from its first.
struct SampleRange {
    std::uint64_t first = 0, count = 0;
    bool contains(std::uint64_t sample) const noexcept { return sample >= first && sample - first < count; }
    friend bool operator==(const SampleRange&, const SampleRange&) = default;
};

/// Properties that are constant over one recording.
struct TakeInfo {
    std::int64_t id = 0;        ///< in its project
    SetupId setup = setupInUse; ///< the setup that it was recorded in
    std::string name;
    std::string toolId;
    double allowance = 0.0;       ///< mm of stock that the boundary kept on the part
    double tickPeriod = 0.001;    ///< s
    double startedUnixTime = 0.0; ///< s since 1970, UTC
    std::string stylus;           ///< description of the input
    /// Ids of the materials, indexed by RemovedMaterial::property; 0 is air. Empty: recorded before format 4.
    std::vector<std::string> materials;
    std::uint64_t sampleCount = 0;
    std::uint64_t undoneCount = 0; ///< number of these that were undone
    std::optional<double> seconds; ///< from start to last sample, including missed ticks; null: the take is damaged
    bool complete = false;         ///< false: the program ended during the recording
    std::int64_t copyOf = 0;       ///< for a copy, the take recorded by hand, even if that was removed; 0: no copy
};

/// A recording. Its samples are immutable once it is complete; undone strokes stay among them.
struct Take {
    TakeInfo info;
    std::vector<Sample> samples;
    std::vector<SampleRange> undone; ///< rising, not touching, within the samples
};

/// A recording without its samples, for code that reads them in order, a part at a time: an hour takes 1.2 GB.
struct TakeOutline {
    TakeInfo info;
    std::vector<SampleRange> undone; ///< as in Take
};

/// Determines, in order from the first sample of a take, which samples were undone: they do not belong to paths, the
/// workpiece or statistics.
class UndoneSamples {
public:
    explicit UndoneSamples(const Take& take) noexcept : UndoneSamples(take.undone) {}
    explicit UndoneSamples(const TakeOutline& take) noexcept : UndoneSamples(take.undone) {}
    explicit UndoneSamples(std::span<const SampleRange> rising) noexcept : ranges_(rising) {}
    /// @param sample no smaller than in the call before
    bool holds(std::uint64_t sample) noexcept {
        while (!ranges_.empty() && sample >= ranges_.front().first + ranges_.front().count)
            ranges_ = ranges_.subspan(1);
        return !ranges_.empty() && ranges_.front().contains(sample);
    }

private:
    std::span<const SampleRange> ranges_;
};

} // namespace burin
