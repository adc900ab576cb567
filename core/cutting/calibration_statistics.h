// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace burin {

/// An estimate and its confidence interval.
struct Confidence {
    double value = 0.0, low = 0.0, high = 0.0;
    bool holds(double truth) const noexcept { return low <= truth && truth <= high; }
};

/// Returns the t such that |T| of Student's distribution is below t with a probability of `confidence`.
/// @param confidence 0 < … < 1. @param freedoms >= 1
double studentQuantile(double confidence, int freedoms);

/// An estimate and its standard error, independent of others.
struct Estimate {
    double value = 0.0, error = 0.0;
};
/// Returns Fieller's interval of numerator / denominator, exact for normal errors that are known to `t` standard
/// errors. Empty if the denominator does not differ significantly from 0: the interval is then unbounded.
std::optional<Confidence> ratioOf(const Estimate& numerator, const Estimate& denominator, double t) noexcept;

/// Returns the median of the numbers, which it sorts; 0 if there are none.
double medianOf(std::vector<double>& numbers) noexcept;
/// Returns the value with half of the weight on either side. @param weights as many as values, >= 0
double weightedMedian(const std::vector<double>& values, const std::vector<double>& weights);

} // namespace burin
