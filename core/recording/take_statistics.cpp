// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/recording/take_statistics.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

void keepGreater(double& greatest, double value) {
    if (std::isfinite(value)) greatest = std::max(greatest, value);
}

void addMotion(TakeStatistics& statistics, const Sample& before, const Sample& sample) {
    const double step = glm::length(sample.proxy.tip - before.proxy.tip);
    const double seconds = sample.time - before.time;
    if (std::isfinite(step)) statistics.travelled += step;
    if (seconds > 0.0) keepGreater(statistics.greatestSpeed, step / seconds);
    if (sample.tick > before.tick) statistics.missingTicks += sample.tick - before.tick - 1;
}

void addRemoval(TakeStatistics& statistics, const Sample& sample) {
    bool cut = false;
    for (const RemovedMaterial& entry : sample.removed) {
        if (entry.units == 0 || entry.property == 0) continue;
        statistics.removedUnits[entry.property] += entry.units;
        cut = true;
    }
    statistics.cutting += cut ? 1 : 0;
    if (std::isfinite(sample.reportedRemoval)) statistics.reportedRemoval += sample.reportedRemoval;
}

void addFlags(TakeStatistics& statistics, std::uint32_t flags) {
    const auto count = [flags](SampleFlag flag) { return (flags & flag) != 0 ? std::uint64_t{1} : std::uint64_t{0}; };
    statistics.onBoundary += count(sampleOnBoundary);
    statistics.onObstacle += count(sampleOnObstacle);
    statistics.axisHeld += count(sampleAxisHeld);
    statistics.shankContact += count(sampleShankContact);
    statistics.forceSaturated += count(sampleForceSaturated);
    statistics.stylusInvalid += count(sampleStylusInvalid);
    statistics.forcesOff += count(sampleForcesOff);
    statistics.memoryFull += count(sampleMemoryFull);
    statistics.spindleOff += count(sampleSpindleOff);
}

/// One stretch without a gap of samples that were taken back.
void addStretch(TakeStatistics& statistics, std::span<const Sample> samples) {
    if (samples.empty()) return;
    statistics.samples += samples.size();
    statistics.seconds += samples.back().time - samples.front().time;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& sample = samples[i];
        if (i > 0) addMotion(statistics, samples[i - 1], sample);
        addRemoval(statistics, sample);
        addFlags(statistics, sample.flags);
        keepGreater(statistics.greatestForce, glm::length(sample.force));
        keepGreater(statistics.greatestCuttingForce, glm::length(sample.cuttingForce));
        keepGreater(statistics.greatestPress, glm::length(sample.stylusTip - sample.proxy.tip));
    }
}

} // namespace

TakeStatistics takeStatistics(std::span<const Sample> samples) {
    TakeStatistics statistics;
    addStretch(statistics, samples);
    return statistics;
}

TakeStatistics standingStatistics(const Take& take) {
    TakeStatistics statistics;
    std::span<const Sample> rest(take.samples);
    std::uint64_t passed = 0;
    for (const SampleRange& range : take.undone) {
        addStretch(statistics, rest.first(range.first - passed));
        rest = rest.subspan(range.first - passed + range.count);
        passed = range.first + range.count;
        statistics.undone += range.count;
    }
    addStretch(statistics, rest);
    return statistics;
}

} // namespace burin
