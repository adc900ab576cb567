// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/calibration_statistics.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burin {

double studentQuantile(double confidence, int freedoms) {
    const boost::math::students_t distribution(freedoms);
    return boost::math::quantile(boost::math::complement(distribution, 0.5 * (1.0 - confidence)));
}

std::optional<Confidence> ratioOf(const Estimate& numerator, const Estimate& denominator, double t) noexcept {
    const double a = numerator.value, b = denominator.value;
    const double va = numerator.error * numerator.error, vb = denominator.error * denominator.error;
    // Where (a - r b)² = t² (va + r² vb).
    const double leading = b * b - t * t * vb;
    if (!(leading > 0.0)) return std::nullopt;
    const double spread = t * std::sqrt(std::max(0.0, a * a * vb + b * b * va - t * t * va * vb));
    return Confidence{a / b, (a * b - spread) / leading, (a * b + spread) / leading};
}

double medianOf(std::vector<double>& numbers) noexcept {
    if (numbers.empty()) return 0.0;
    std::sort(numbers.begin(), numbers.end());
    const std::size_t half = numbers.size() / 2;
    return numbers.size() % 2 == 1 ? numbers[half] : 0.5 * (numbers[half - 1] + numbers[half]);
}

double weightedMedian(const std::vector<double>& values, const std::vector<double>& weights) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    double left = std::accumulate(weights.begin(), weights.end(), 0.0) / 2.0;
    for (const std::size_t i : order) {
        left -= weights[i];
        if (left <= 0.0) return values[i];
    }
    return values.empty() ? 0.0 : values[order.back()];
}

} // namespace burin
