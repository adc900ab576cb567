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
    sampleOnBoundary = 1u << 1,     ///< the part (with its allowance) or another bound held the proxy back
    sampleForceSaturated = 1u << 2, ///< the rendered force was limited by the device's figure
    sampleStylusInvalid = 1u << 3,  ///< the device gave no valid reading: zero force
    sampleForcesOff = 1u << 4,      ///< ramp-in or start inside the part: no force yet
    sampleMemoryFull = 1u << 5,     ///< the reserved memory of the volume is used up: cutting stopped
    sampleSpindleOff = 1u << 6, ///< the tool only moved: nothing was cut, stock did not hold it; never part of a path
    sampleOnGuide = 1u << 7,    ///< a guide held the hand, or turned the tool's axis
    sampleAxisHeld = 1u << 8,   ///< the axis does not follow the stylus: there is no room, and no torque to feel it
    sampleOnObstacle = 1u << 9, ///< a fixture, a keep-out volume or the machine's travel held the proxy back: alarm
    sampleForceLate = 1u << 10, ///< the force came too late for its reading: zero was sent instead
    sampleMotorsHot = 1u << 11, ///< the device's motors are hot: it is asked for less than its figures allow
};

/// Removed volume of one material in one tick.
struct RemovedMaterial {
    std::uint64_t units = 0;   ///< run units of the volume (Grid::unitVolume), exact
    std::uint8_t property = 0; ///< index of TakeInfo::materials; 0: entry not used
};

/// One tick of a recording: what the hand did and what came of it. Frames: device pose in the device frame, the rest in
/// the setup frame.
struct Sample {
    std::uint64_t tick = 0;
    double time = 0.0;            ///< s since the take began
    Pose device;                  ///< mm, device frame
    glm::dvec3 stylusTip{0.0};    ///< where the mapped hand wants the tip, mm
    ToolPose proxy;               ///< where the tool is; never inside the part grown by the allowance
    glm::dvec3 force{0.0};        ///< N, rendered by the device, setup frame; without what only carries its handle
    glm::dvec3 cuttingForce{0.0}; ///< N, unscaled, setup frame
    double reportedRemoval = 0.0; ///< mm³, the smooth figure that drives the force
    std::array<RemovedMaterial, 8> removed{}; ///< exact, by material
    std::uint32_t buttons = 0;
    std::uint32_t flags = 0; ///< SampleFlag
};
static_assert(std::is_trivially_copyable_v<Sample>);

/// A stretch of a take, counted in samples from its first.
struct SampleRange {
    std::uint64_t first = 0, count = 0;
    bool contains(std::uint64_t sample) const noexcept { return sample >= first && sample - first < count; }
    friend bool operator==(const SampleRange&, const SampleRange&) = default;
};

/// What is constant over one recording.
struct TakeInfo {
    std::int64_t id = 0;        ///< in its project
    SetupId setup = setupInUse; ///< that it was recorded in
    std::string name;
    std::string toolId;
    double allowance = 0.0;       ///< mm of stock that the boundary left on the part
    double tickPeriod = 0.001;    ///< s
    double startedUnixTime = 0.0; ///< s since 1970, UTC
    std::string stylus;           ///< description of the input
    /// Ids of the materials that RemovedMaterial::property is an index of; 0 is air. Empty: recorded before format 4.
    std::vector<std::string> materials;
    std::uint64_t sampleCount = 0;
    std::uint64_t undoneCount = 0; ///< of these, taken back
    std::optional<double> seconds; ///< from its start to its last sample, missed ticks among them; null: it is damaged
    bool complete = false;         ///< false: the program ended while it was recorded
};

/// A recording. Its samples are immutable once it is complete; strokes that were taken back stay among them.
struct Take {
    TakeInfo info;
    std::vector<Sample> samples;
    std::vector<SampleRange> undone; ///< rising, apart from each other, within the samples
};

/// A recording without its samples, for those who read them in their order, a part at a time: an hour of them takes
/// 1.2 GB.
struct TakeOutline {
    TakeInfo info;
    std::vector<SampleRange> undone; ///< as in Take
};

/// Goes through a take from its first sample on and tells which ones were taken back: they are no part of paths, of the
/// workpiece, or of figures.
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
