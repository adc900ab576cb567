// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"

#include <map>
#include <span>

namespace burin {

/// A recording in figures.
struct TakeStatistics {
    std::uint64_t samples = 0;
    std::uint64_t missingTicks = 0;    ///< numbers between the first and the last tick that have no sample
    double seconds = 0.0;              ///< from the first to the last sample
    double travelled = 0.0;            ///< mm, length of the tool's way
    double greatestSpeed = 0.0;        ///< mm/s of the tool between two samples
    double greatestForce = 0.0;        ///< N, sent to the device
    double greatestCuttingForce = 0.0; ///< N, unscaled
    double greatestPress = 0.0;        ///< mm, stylus tip behind the tool
    double reportedRemoval = 0.0;      ///< mm³
    std::map<std::uint8_t, std::uint64_t> removedUnits; ///< by property: run units, exact
    std::uint64_t cutting = 0;                          ///< samples that removed something
    std::uint64_t onBoundary = 0;                       ///< samples held back by the part or another bound
    std::uint64_t onObstacle = 0; ///< by a fixture, a keep-out volume or the machine's travel
    std::uint64_t axisHeld = 0;   ///< samples whose axis could not follow the hand
    std::uint64_t shankContact = 0;
    std::uint64_t forceSaturated = 0;
    std::uint64_t stylusInvalid = 0;
    std::uint64_t forcesOff = 0;
    std::uint64_t memoryFull = 0;
    std::uint64_t spindleOff = 0;
    std::uint64_t undone = 0; ///< samples that were taken back; they count in nothing else
};

/// @param samples in the order of their ticks. Samples with numbers that are not finite add nothing to lengths.
TakeStatistics takeStatistics(std::span<const Sample> samples);
/// Of what stands: the way to and from what was taken back counts as little as that itself.
TakeStatistics standingStatistics(const Take& take);

} // namespace burin
