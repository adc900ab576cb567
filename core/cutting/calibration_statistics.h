// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace burin {

/// An estimate and where the true value lies with the stated confidence.
struct Confidence {
    double value = 0.0, low = 0.0, high = 0.0;
    bool holds(double truth) const noexcept { return low <= truth && truth <= high; }
};

/// The t that |T| of Student's distribution stays below with a probability of `confidence`.
/// @param confidence 0 < … < 1. @param freedoms >= 1
double studentQuantile(double confidence, int freedoms);

/// An estimate and its standard error, independent of others.
struct Estimate {
    double value = 0.0, error = 0.0;
};
/// Fieller's interval of numerator / denominator, exact for normal errors that are known to `t` standard errors.
/// Nothing where the denominator can't be told from 0: then the interval has no end.
std::optional<Confidence> ratioOf(const Estimate& numerator, const Estimate& denominator, double t) noexcept;

/// Of numbers, which it sorts; 0 of none.
double medianOf(std::vector<double>& numbers) noexcept;
/// The value at which half of the weight lies on either side. @param weights as many as values, >= 0
double weightedMedian(const std::vector<double>& values, const std::vector<double>& weights);

} // namespace burin
