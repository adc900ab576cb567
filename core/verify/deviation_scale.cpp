// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/deviation_scale.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr std::array toleranceMultiples{1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0};
constexpr std::size_t resultBands = 5;
constexpr DeviationColour nominalColour{247, 247, 247};
constexpr std::array<DeviationColour, 5> gougeColours{
    {{253, 219, 199}, {244, 165, 130}, {224, 100, 77}, {192, 42, 53}, {142, 15, 44}}};
constexpr std::array<DeviationColour, 7> excessColours{{{209, 229, 240},
                                                        {146, 197, 222},
                                                        {67, 147, 195},
                                                        {42, 114, 181},
                                                        {23, 74, 140},
                                                        {52, 48, 124},
                                                        {74, 34, 104}}}; // the last two are not from RdBu
constexpr double leastTolerance = 1e-3; // mm: a tolerance of zero would leave no room for its bands

} // namespace

DeviationScale::DeviationScale(const DeviationTolerance& tolerance, Reach reach) {
    const double gouge = std::max(tolerance.gouge, leastTolerance);
    const double excess = std::max(tolerance.excess, leastTolerance);
    for (std::size_t i = gougeColours.size(); i-- > 0;)
        marks_.push_back({-gouge * toleranceMultiples[i], i == 0, gougeColours[i]});
    marks_.push_back({0.0, false, nominalColour});
    if (tolerance.allowance > 0.0) marks_.push_back({tolerance.allowance, false, nominalColour});
    const std::size_t bands = reach == Reach::result ? resultBands : excessColours.size();
    for (std::size_t i = 0; i < bands; ++i)
        marks_.push_back(
            {std::max(tolerance.allowance, 0.0) + excess * toleranceMultiples[i], i == 0, excessColours[i]});
}

double DeviationScale::positionOf(double deviation) const noexcept {
    const auto above = std::upper_bound(marks_.begin(), marks_.end(), deviation,
                                        [](double value, const Mark& mark) { return value < mark.deviation; });
    if (above == marks_.begin()) return 0.0;
    if (above == marks_.end()) return 1.0;
    const Mark& below = *(above - 1);
    const double share = (deviation - below.deviation) / (above->deviation - below.deviation);
    return (static_cast<double>(above - marks_.begin() - 1) + share) / static_cast<double>(marks_.size() - 1);
}

DeviationColour DeviationScale::colourAt(double position) const noexcept {
    const double along = std::clamp(position, 0.0, 1.0) * static_cast<double>(marks_.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(along), marks_.size() - 2);
    const double share = along - static_cast<double>(below);
    DeviationColour colour{};
    for (std::size_t i = 0; i < colour.size(); ++i)
        colour[i] = static_cast<std::uint8_t>(
            std::lround(std::lerp(marks_[below].colour[i], marks_[below + 1].colour[i], share)));
    return colour;
}

DeviationColour colourOf(const DeviationSample& sample, const DeviationScale& scale,
                         const DeviationTolerance& tolerance) noexcept {
    return bandOf(sample, tolerance) == DeviationBand::unreachable ? unmeasuredColour
                                                                   : scale.colourOf(deviationOf(sample));
}

} // namespace burin
