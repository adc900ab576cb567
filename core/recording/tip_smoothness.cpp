// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/recording/tip_smoothness.h"

#include "core/base/units.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <utility>

namespace burin {

namespace {

constexpr double highestFrequency = 20.0, leastMagnitude = 0.05;
constexpr int padding = 4; // power of two by which zero padding refines the spectrum
constexpr double speedTime = 0.01, pauseTime = 0.15, shortestMovement = 0.2, longestMovement = 60.0; // s
constexpr double restingSpeed = 1.0;                                                                 // mm/s

std::size_t countIn(double seconds, double period) noexcept {
    return static_cast<std::size_t>(std::max(1.0, std::round(seconds / period)));
}

/// Discrete Fourier transform in place (Cooley and Tukey). @param values their number is a power of two
void transform(std::vector<std::complex<double>>& values) {
    const std::size_t count = values.size();
    for (std::size_t i = 1, j = 0; i < count; ++i) {
        std::size_t bit = count / 2;
        for (; (j & bit) != 0; bit /= 2) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(values[i], values[j]);
    }
    for (std::size_t half = 1; half < count; half *= 2)
        for (std::size_t k = 0; k < half; ++k) {
            const auto turn = std::polar(1.0, -pi * static_cast<double>(k) / static_cast<double>(half));
            for (std::size_t i = k; i < count; i += 2 * half) {
                const std::complex<double> odd = turn * values[i + half];
                values[i + half] = values[i] - odd;
                values[i] += odd;
            }
        }
}

} // namespace

std::optional<double> spectralArcLength(std::span<const double> speeds, double period) {
    if (speeds.size() < 2) return std::nullopt;
    std::vector<std::complex<double>> spectrum(std::bit_ceil(speeds.size()) << padding);
    std::ranges::copy(speeds, spectrum.begin());
    transform(spectrum);
    double greatest = 0.0;
    for (std::size_t i = 0; i <= spectrum.size() / 2; ++i) greatest = std::max(greatest, std::abs(spectrum[i]));
    if (!(greatest > 0.0)) return std::nullopt;
    const double step = 1.0 / (period * static_cast<double>(spectrum.size())); // Hz
    auto last = std::min(spectrum.size() / 2, static_cast<std::size_t>(highestFrequency / step));
    while (last > 1 && std::abs(spectrum[last]) < leastMagnitude * greatest) --last;
    double length = 0.0;
    for (std::size_t i = 1; i <= last; ++i)
        length +=
            std::hypot(1.0 / static_cast<double>(last), (std::abs(spectrum[i]) - std::abs(spectrum[i - 1])) / greatest);
    return -length;
}

TipSmoothness::TipSmoothness(double tickPeriod)
    : tickPeriod_(tickPeriod)
    , period_(static_cast<double>(countIn(speedTime, tickPeriod)) * tickPeriod)
    , ticks_(countIn(speedTime, tickPeriod)) {}

/// A few missed ticks make the interval of a speed longer; the speed is then counted accordingly often.
void TipSmoothness::add(const Sample& sample) {
    if (from_ && static_cast<double>(sample.tick - from_->tick) * tickPeriod_ >= pauseTime) interrupt();
    if (!from_) {
        from_ = sample;
        return;
    }
    const std::uint64_t ticks = sample.tick - from_->tick;
    if (ticks < ticks_) return;
    const double speed = glm::distance(from_->proxy.tip, sample.proxy.tip) / (static_cast<double>(ticks) * tickPeriod_);
    for (std::uint64_t i = 0; i < ticks / ticks_; ++i) addSpeed(speed);
    from_ = sample;
}

void TipSmoothness::addSpeed(double speed) {
    const bool slow = speed < restingSpeed;
    if (resting_ && slow) return;
    resting_ = false;
    speeds_.push_back(speed);
    slow_ = slow ? slow_ + 1 : 0;
    if (slow_ >= countIn(pauseTime, period_)) {
        endMovement(speeds_.size() - slow_);
        resting_ = true;
    } else if (speeds_.size() >= countIn(longestMovement, period_)) {
        endMovement(speeds_.size());
    }
}

/// @param speeds number of values from the start that belong to the movement
void TipSmoothness::endMovement(std::size_t speeds) {
    const double seconds = static_cast<double>(speeds) * period_;
    if (seconds >= shortestMovement - 0.5 * period_)
        if (const auto smoothness = spectralArcLength(std::span(speeds_).first(speeds), period_)) {
            sum_ += *smoothness * seconds;
            seconds_ += seconds;
        }
    speeds_.clear();
    slow_ = 0;
}

void TipSmoothness::interrupt() {
    endMovement(speeds_.size());
    from_.reset();
    resting_ = false;
}

std::optional<double> TipSmoothness::mean() const noexcept {
    return seconds_ > 0.0 ? std::optional(sum_ / seconds_) : std::nullopt;
}

} // namespace burin
