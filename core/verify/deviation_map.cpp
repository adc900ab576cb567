// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/deviation_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

constexpr double gapInCells = 2.5;
constexpr double planeInCells = 0.25; // the samples of a face are this close to the tangent plane a cell away

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

/// 21 bits of each number: cells two million cells apart share a key, which costs time but causes no error.
DeviationMap::Cell DeviationMap::cellOf(std::int64_t i, std::int64_t j, std::int64_t k) const noexcept {
    constexpr std::uint64_t mask = (std::uint64_t{1} << 21) - 1;
    return (static_cast<std::uint64_t>(i) & mask) << 42 | (static_cast<std::uint64_t>(j) & mask) << 21 |
           (static_cast<std::uint64_t>(k) & mask);
}

template <class Visit>
void DeviationMap::forEachNear(const glm::dvec3& place, double reach, const Visit& visit) const {
    const auto low = [&](double at) { return cellNumber(at - reach, cell_); };
    const auto high = [&](double at) { return cellNumber(at + reach, cell_); };
    for (std::int64_t k = low(place.z); k <= high(place.z); ++k)
        for (std::int64_t j = low(place.y); j <= high(place.y); ++j)
            for (std::int64_t i = low(place.x); i <= high(place.x); ++i) {
                const auto cell = cells_.find(cellOf(i, j, k));
                if (cell == cells_.end()) continue;
                for (const std::uint32_t sample : cell->second) visit(sample);
            }
}

std::optional<std::size_t> DeviationMap::nearest(const glm::dvec3& place, double reach) const {
    std::optional<std::size_t> found;
    double least = reach;
    forEachNear(place, reach, [&](std::uint32_t sample) {
        const double distance = glm::length(samples_[sample].place - place);
        if (distance > least || (found && distance == least)) return;
        least = distance;
        found = sample;
    });
    return found;
}

std::optional<DeviationSample> DeviationMap::at(const glm::dvec3& place, const glm::dvec3& normal) const {
    if (auto mean = meanAt(place, normal)) return mean;
    // There may be gaps between the samples of small triangles.
    const double reach = gapInCells * cell_;
    std::optional<DeviationSample> found;
    double least = reach * reach;
    forEachNear(place, reach, [&](std::uint32_t number) {
        const glm::dvec3 to = samples_[number].place - place;
        const double square = glm::dot(to, to), off = glm::dot(to, normal);
        if (square > least || off * off > 0.25 * square) return;
        least = square;
        found = samples_[number];
    });
    return found;
}

std::optional<DeviationSample> DeviationMap::meanAt(const glm::dvec3& place, const glm::dvec3& normal) const {
    struct Sum {
        double weight = 0.0, excess = 0.0;
    };
    std::array<Sum, 2> sums; // unreachable, reachable
    double gouge = 0.0;
    const double thickness = planeInCells * cell_;
    forEachNear(place, cell_, [&](std::uint32_t number) {
        const DeviationSample& sample = samples_[number];
        const glm::dvec3 to = sample.place - place;
        const double off = glm::dot(to, normal) / thickness;
        const double beside = (glm::dot(to, to) - off * off * thickness * thickness) / (cell_ * cell_);
        if (beside >= 1.0 || std::abs(off) > 2.0) return;
        gouge = std::max(gouge, sample.gouge);
        const double weight = (1.0 - beside) * (1.0 - beside) * std::exp(-off * off);
        sums[sample.reachable ? 1 : 0].weight += weight;
        sums[sample.reachable ? 1 : 0].excess += weight * sample.excess;
    });
    const bool reachable = sums[1].weight >= sums[0].weight;
    const Sum& most = sums[reachable ? 1 : 0];
    if (!(most.weight > 0.0)) return std::nullopt;
    return DeviationSample{place, most.excess / most.weight, gouge, reachable};
}

double& DeviationMap::Shares::of(DeviationBand band) noexcept {
    switch (band) {
    case DeviationBand::gouge:
        return gouge;
    case DeviationBand::inTolerance:
        return inTolerance;
    case DeviationBand::excess:
        return excess;
    case DeviationBand::unreachable:
        break;
    }
    return unreachable;
}

DeviationMap::Shares DeviationMap::shares(const DeviationTolerance& tolerance) const {
    Shares shares;
    if (samples_.empty()) return shares;
    const double one = 1.0 / static_cast<double>(samples_.size());
    for (const DeviationSample& sample : samples_) shares.of(bandOf(sample, tolerance)) += one;
    return shares;
}

} // namespace burin
