// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/cutting/calibration_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double medianOfTwo = 1.1774; // of |error| in two components, relative to the deviation of either
constexpr double farOff = 5.2;         // standard deviations: 1 of 150,000 good records lies beyond in two components
constexpr double smallSampleMargin = 5.0; // records: the noise of few records is uncertain
constexpr double roundingNoise = 1e-9;    // of the forces
constexpr int mostIterations = 50;

} // namespace

EdgeFit::EdgeFit(std::vector<ForceObservation> observations)
    : observations_(std::move(observations)), counts_(observations_.size(), true) {}

std::complex<double> EdgeFit::residual(const ForceObservation& o) const noexcept {
    return o.force - chip_ * o.ofChip - edge_ * o.ofEdge;
}

std::size_t EdgeFit::counted() const noexcept {
    return static_cast<std::size_t>(std::count(counts_.begin(), counts_.end(), true));
}

double EdgeFit::limit() const noexcept {
    return farOff * (1.0 + smallSampleMargin / static_cast<double>(observations_.size()));
}

/// Solves for the two complex unknowns by the normal equations.
void EdgeFit::solve(const std::vector<double>& weights) {
    std::complex<double> chipEdge, towardsChip, towardsEdge;
    chipChip_ = edgeEdge_ = 0.0;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
        const ForceObservation& o = observations_[i];
        chipChip_ += weights[i] * std::norm(o.ofChip);
        edgeEdge_ += weights[i] * std::norm(o.ofEdge);
        chipEdge += weights[i] * std::conj(o.ofChip) * o.ofEdge;
        towardsChip += weights[i] * std::conj(o.ofChip) * o.force;
        towardsEdge += weights[i] * std::conj(o.ofEdge) * o.force;
    }
    determinant_ = chipChip_ * edgeEdge_ - std::norm(chipEdge);
    chip_ = (edgeEdge_ * towardsChip - chipEdge * towardsEdge) / determinant_;
    edge_ = (chipChip_ * towardsEdge - std::conj(chipEdge) * towardsChip) / determinant_;
}

double EdgeFit::noise() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < observations_.size(); ++i)
        if (counts_[i]) sum += std::norm(residual(observations_[i]));
    return std::sqrt(sum / (2.0 * static_cast<double>(counted()) - 4.0));
}

/// Selects anew which records count. Returns true if the selection changed.
bool EdgeFit::select(double scale) {
    double largest = 0.0;
    for (const ForceObservation& o : observations_) largest = std::max(largest, std::abs(o.force));
    const double most = limit() * std::max(scale, roundingNoise * largest);
    bool changed = false;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
        const bool counts = std::abs(residual(observations_[i])) <= most;
        changed = changed || counts != counts_[i];
        counts_[i] = counts;
    }
    return changed;
}

void EdgeFit::run() {
    std::vector<double> weights(observations_.size(), 1.0);
    double largest = 0.0;
    for (const ForceObservation& o : observations_) largest = std::max(largest, std::abs(o.force));
    for (int i = 0; i < mostIterations; ++i) { // least absolute deviations, by weights
        solve(weights);
        for (std::size_t k = 0; k < weights.size(); ++k)
            weights[k] = 1.0 / std::max(std::abs(residual(observations_[k])), 1e-6 * largest);
    }
    std::vector<double> sizes;
    for (const ForceObservation& o : observations_) sizes.push_back(std::abs(residual(o)));
    const auto n = static_cast<double>(sizes.size());
    scale_ = medianOf(sizes) / medianOfTwo * n / (n - 2.0);
    select(scale_);
    for (int i = 0; i < mostIterations; ++i) {
        if (counted() <= 2) return;
        for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = counts_[k] ? 1.0 : 0.0;
        solve(weights);
        scale_ = noise();
        if (!select(scale_)) return;
    }
}

double EdgeFit::chipError() const noexcept {
    return scale_ * std::sqrt(edgeEdge_ / determinant_);
}

double EdgeFit::edgeError() const noexcept {
    return scale_ * std::sqrt(chipChip_ / determinant_);
}

void EdgeFit::report(MaterialCalibration& result) const {
    result.chipLow = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < observations_.size(); ++i) {
        const ForceObservation& o = observations_[i];
        const std::complex<double> left = residual(o);
        if (counts_[i]) {
            // The residual in the coordinates of the tooth: along its motion and perpendicular to it.
            const std::complex<double> turned = left * std::conj(o.ofChip) / std::abs(o.ofChip);
            result.residuals.push_back({o.line, turned.real(), turned.imag()});
            result.chipLow = std::min(result.chipLow, o.chip);
            result.chipHigh = std::max(result.chipHigh, o.chip);
            continue;
        }
        result.leftOut.push_back({o.line, "far off: " + formatFixed(std::abs(left), 3) + " N deviation from the fit; " +
                                              formatFixed(limit() * scale_, 3) + " N would count"});
    }
    result.tangentialNoise = result.radialNoise = scale_;
}

} // namespace burin
