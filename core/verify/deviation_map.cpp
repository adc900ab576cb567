// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/deviation_map.h"

#include <cmath>

namespace burin {

namespace {

std::int64_t cellNumber(double place, double cell) noexcept {
    return static_cast<std::int64_t>(std::floor(place / cell));
}

} // namespace

const char* idOf(DeviationBand band) {
    switch (band) {
    case DeviationBand::gouge:
        return "gouge";
    case DeviationBand::inTolerance:
        return "in_tolerance";
    case DeviationBand::excess:
        return "excess";
    case DeviationBand::unreachable:
        return "unreachable";
    }
    return "unknown";
}

double deviationOf(const DeviationSample& sample) noexcept {
    return sample.gouge > 0.0 ? -sample.gouge : sample.excess;
}

DeviationBand bandOf(const DeviationSample& sample, const DeviationTolerance& tolerance) noexcept {
    const double deviation = deviationOf(sample);
    if (deviation < -tolerance.gouge) return DeviationBand::gouge;
    if (deviation <= tolerance.allowance + tolerance.excess) return DeviationBand::inTolerance;
    return sample.reachable ? DeviationBand::excess : DeviationBand::unreachable;
}

DeviationMap::DeviationMap(const std::vector<DeviationSample>& samples, double cell) : samples_(samples), cell_(cell) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const glm::dvec3& place = samples[i].place;
        cells_[cellOf(cellNumber(place.x, cell), cellNumber(place.y, cell), cellNumber(place.z, cell))].push_back(
            static_cast<std::uint32_t>(i));
    }
}

/// 21 bits of each number: cells that lie two million cells apart share a name, which costs a look and no error.
DeviationMap::Cell DeviationMap::cellOf(std::int64_t i, std::int64_t j, std::int64_t k) const noexcept {
    constexpr std::uint64_t mask = (std::uint64_t{1} << 21) - 1;
    return (static_cast<std::uint64_t>(i) & mask) << 42 | (static_cast<std::uint64_t>(j) & mask) << 21 |
           (static_cast<std::uint64_t>(k) & mask);
}

std::optional<std::size_t> DeviationMap::nearest(const glm::dvec3& place, double reach) const {
    std::optional<std::size_t> found;
    double least = reach;
    const auto low = [&](double at) { return cellNumber(at - reach, cell_); };
    const auto high = [&](double at) { return cellNumber(at + reach, cell_); };
    for (std::int64_t k = low(place.z); k <= high(place.z); ++k)
        for (std::int64_t j = low(place.y); j <= high(place.y); ++j)
            for (std::int64_t i = low(place.x); i <= high(place.x); ++i) {
                const auto cell = cells_.find(cellOf(i, j, k));
                if (cell == cells_.end()) continue;
                for (const std::uint32_t sample : cell->second) {
                    const double distance = glm::length(samples_[sample].place - place);
                    if (distance > least || (found && distance == least)) continue;
                    least = distance;
                    found = sample;
                }
            }
    return found;
}

DeviationMap::Shares DeviationMap::shares(const DeviationTolerance& tolerance) const {
    Shares shares;
    if (samples_.empty()) return shares;
    const double one = 1.0 / static_cast<double>(samples_.size());
    for (const DeviationSample& sample : samples_) {
        const DeviationBand band = bandOf(sample, tolerance);
        (band == DeviationBand::gouge         ? shares.gouge
         : band == DeviationBand::inTolerance ? shares.inTolerance
         : band == DeviationBand::excess      ? shares.excess
                                              : shares.unreachable) += one;
    }
    return shares;
}

} // namespace burin
