// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/calibration_fit.h"

#include "core/base/numbers.h"
#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double deviationPerMedian = 1.4826; // of a normal distribution: standard deviation divided by the median of
                                              // |x|
constexpr double farOff = 4.5;                // standard deviations; 1 of 150,000 good records lies beyond
constexpr double smallSampleMargin = 5.0;     // records: the noise of few records is uncertain
constexpr double roundingNoise = 1e-9;        // of the forces
constexpr std::size_t mostForAllPairs = 400;
constexpr int mostIterations = 50;

} // namespace

ForceFit::ForceFit(std::vector<ForceObservation> observations, bool withExponent)
    : observations_(std::move(observations)), counts_(observations_.size(), true), withExponent_(withExponent) {
    double sum = 0.0;
    for (const ForceObservation& o : observations_) sum += std::log(o.chip);
    referenceChip_ = std::exp(sum / static_cast<double>(observations_.size()));
}

double ForceFit::basis(const ForceObservation& o) const noexcept {
    return o.drive * std::pow(o.chip / referenceChip_, -exponent_);
}

double ForceFit::tangentialResidual(const ForceObservation& o) const noexcept {
    return (o.tangential - energy_ * basis(o)) / o.gain;
}

double ForceFit::radialResidual(const ForceObservation& o) const noexcept {
    return (o.radial - radialEnergy_ * basis(o)) / o.gain;
}

std::size_t ForceFit::counted() const noexcept {
    return static_cast<std::size_t>(std::count(counts_.begin(), counts_.end(), true));
}

void ForceFit::run() {
    startRobustly();
    if (pointsAlong_) return;
    tangentialScale_ = medianNoise(false);
    radialScale_ = medianNoise(true);
    select();
    for (int i = 0; i < mostIterations; ++i) {
        if (counted() <= 2) return;
        leastSquares();
        tangentialScale_ = noise(false);
        radialScale_ = noise(true);
        if (!select()) return;
    }
}

/// Starts with medians, which are robust as long as fewer than half of the ratios, and with an exponent not much more
/// than a quarter of the records, are outliers.
void ForceFit::startRobustly() {
    std::vector<double> values, weights;
    const auto add = [&](double value, double weight) {
        values.push_back(value);
        weights.push_back(weight);
    };
    if (withExponent_) {
        std::vector<ForceObservation> byChip;
        std::copy_if(observations_.begin(), observations_.end(), std::back_inserter(byChip),
                     [](const ForceObservation& o) { return o.tangential > 0.0; });
        std::sort(byChip.begin(), byChip.end(),
                  [](const ForceObservation& a, const ForceObservation& b) { return a.chip < b.chip; });
        const std::size_t n = byChip.size(), shift = n > mostForAllPairs ? n / 2 : 1;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + shift; j < n && (shift == 1 || j == i + shift); ++j) {
                const ForceObservation &a = byChip[i], &b = byChip[j];
                const double way = std::log(b.chip / a.chip);
                if (!(way > 0.0)) continue;
                add(-std::log(b.tangential / b.drive / (a.tangential / a.drive)) / way, way);
            }
        exponent_ = weightedMedian(values, weights);
        values.clear();
        weights.clear();
    }
    const auto ratios = [&](double ForceObservation::*force) {
        values.clear();
        weights.clear();
        for (const ForceObservation& o : observations_) add(o.*force / basis(o), basis(o) / o.gain);
        return weightedMedian(values, weights);
    };
    energy_ = ratios(&ForceObservation::tangential);
    radialEnergy_ = ratios(&ForceObservation::radial);
    pointsAlong_ = !(energy_ > 0.0);
}

/// N, from the median of all residuals.
double ForceFit::medianNoise(bool radial) const {
    std::vector<double> sizes;
    for (const ForceObservation& o : observations_)
        sizes.push_back(std::abs(radial ? radialResidual(o) : tangentialResidual(o)));
    const auto n = static_cast<double>(sizes.size());
    return deviationPerMedian * medianOf(sizes) * n / (n - (withExponent_ ? 2.0 : 1.0));
}

/// N, standard deviation of the residuals of the records that count.
double ForceFit::noise(bool radial) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
        const double residual = radial ? radialResidual(observations_[i]) : tangentialResidual(observations_[i]);
        if (counts_[i]) sum += residual * residual;
    }
    // The exponent is fitted only to the tangential forces, so only these have two unknowns.
    const double freedoms = static_cast<double>(counted()) - (withExponent_ && !radial ? 2.0 : 1.0);
    return std::sqrt(sum / freedoms);
}

double ForceFit::limit() const noexcept {
    return farOff * (1.0 + smallSampleMargin / static_cast<double>(observations_.size()));
}

/// Selects anew which records count. Returns true if the selection changed.
bool ForceFit::select() {
    double largest = 0.0;
    for (const ForceObservation& o : observations_)
        largest = std::max({largest, std::abs(o.tangential / o.gain), std::abs(o.radial / o.gain)});
    const double rounding = roundingNoise * largest;
    const double tangential = limit() * std::max(tangentialScale_, rounding);
    const double radial = limit() * std::max(radialScale_, rounding);
    bool changed = false;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
        const ForceObservation& o = observations_[i];
        const bool counts = std::abs(tangentialResidual(o)) <= tangential && std::abs(radialResidual(o)) <= radial;
        changed = changed || counts != counts_[i];
        counts_[i] = counts;
    }
    return changed;
}

/// Gauss-Newton in K0 and mc; with a constant K its first step is the solution.
void ForceFit::leastSquares() {
    const auto cost = [&] {
        double sum = 0.0;
        for (std::size_t i = 0; i < observations_.size(); ++i)
            if (counts_[i]) sum += std::pow(tangentialResidual(observations_[i]), 2);
        return sum;
    };
    for (int iteration = 0; iteration < mostIterations; ++iteration) {
        energyEnergy_ = energyExponent_ = exponentExponent_ = basisBasis_ = 0.0;
        double towardsEnergy = 0.0, towardsExponent = 0.0, radial = 0.0;
        for (std::size_t i = 0; i < observations_.size(); ++i) {
            if (!counts_[i]) continue;
            const ForceObservation& o = observations_[i];
            const double g = basis(o) / o.gain, slope = -energy_ * g * std::log(o.chip / referenceChip_);
            const double residual = tangentialResidual(o);
            energyEnergy_ += g * g;
            energyExponent_ += g * slope;
            exponentExponent_ += slope * slope;
            towardsEnergy += g * residual;
            towardsExponent += slope * residual;
            radial += g * o.radial / o.gain;
        }
        basisBasis_ = energyEnergy_;
        radialEnergy_ = radial / basisBasis_;
        const double determinant = energyEnergy_ * exponentExponent_ - energyExponent_ * energyExponent_;
        const bool solvable = determinant > 1e-12 * energyEnergy_ * exponentExponent_;
        double stepEnergy = towardsEnergy / energyEnergy_, stepExponent = 0.0;
        if (withExponent_ && solvable) {
            stepEnergy = (exponentExponent_ * towardsEnergy - energyExponent_ * towardsExponent) / determinant;
            stepExponent = (energyEnergy_ * towardsExponent - energyExponent_ * towardsEnergy) / determinant;
        }
        const double before = cost(), energy = energy_, exponent = exponent_;
        double share = 1.0;
        do {
            energy_ = energy + share * stepEnergy;
            exponent_ = exponent + share * stepExponent;
            share *= 0.5;
        } while (!(cost() <= before) && share > 1e-6);
        if (!(cost() <= before)) { // no step helps: this is the minimum up to rounding
            energy_ = energy;
            exponent_ = exponent;
            return;
        }
        if (std::abs(stepEnergy) <= 1e-12 * std::abs(energy_) && std::abs(stepExponent) <= 1e-12) return;
    }
}

Estimate ForceFit::specificEnergy() const noexcept {
    if (!withExponent_) return energyForRatio();
    const double determinant = energyEnergy_ * exponentExponent_ - energyExponent_ * energyExponent_;
    return {energy_, tangentialScale_ * std::sqrt(exponentExponent_ / determinant)};
}

Estimate ForceFit::exponent() const noexcept {
    const double determinant = energyEnergy_ * exponentExponent_ - energyExponent_ * energyExponent_;
    if (!(determinant > 0.0)) return {exponent_, std::numeric_limits<double>::infinity()};
    return {exponent_, tangentialScale_ * std::sqrt(energyEnergy_ / determinant)};
}

Estimate ForceFit::logarithmOfForceAtOneMillimetre() const noexcept {
    const double determinant = energyEnergy_ * exponentExponent_ - energyExponent_ * energyExponent_;
    const double away = std::log(referenceChip_);
    const double variance = (exponentExponent_ / (energy_ * energy_) + away * away * energyEnergy_ -
                             2.0 * away * energyExponent_ / energy_) /
                            determinant;
    return {std::log(newtonMillimetresPerJoule * energy_) + exponent_ * away,
            tangentialScale_ * std::sqrt(std::max(0.0, variance))};
}

Estimate ForceFit::radialEnergy() const noexcept {
    return {radialEnergy_, radialScale_ / std::sqrt(basisBasis_)};
}

Estimate ForceFit::energyForRatio() const noexcept {
    return {energy_, tangentialScale_ / std::sqrt(basisBasis_)};
}

void ForceFit::report(MaterialCalibration& result) const {
    result.chipLow = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < observations_.size(); ++i) {
        const ForceObservation& o = observations_[i];
        const Residual residual{o.line, tangentialResidual(o) * o.gain, radialResidual(o) * o.gain};
        if (counts_[i]) {
            result.residuals.push_back(residual);
            result.chipLow = std::min(result.chipLow, o.chip);
            result.chipHigh = std::max(result.chipHigh, o.chip);
            continue;
        }
        result.leftOut.push_back({o.line, "far off: " + formatFixed(residual.tangential, 3) + " N tangential, " +
                                              formatFixed(residual.radial, 3) + " N radial deviation from the fit; " +
                                              formatFixed(limit() * tangentialScale_ * o.gain, 3) + " N and " +
                                              formatFixed(limit() * radialScale_ * o.gain, 3) + " N would count"});
    }
    result.tangentialNoise = tangentialScale_;
    result.radialNoise = radialScale_;
}

} // namespace burin
