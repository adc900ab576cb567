// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// How smooth a movement is, by its speeds: the spectral arc length (SPARC) of Balasubramanian, Melendez-Calderon,
/// Roby-Brami and Burdet, On the analysis of movement smoothness, Journal of NeuroEngineering and Rehabilitation 12:112
/// (2015). It is the negative length of the curve of the speed's magnitude spectrum: frequency as a share of the
/// highest one that counts, magnitude as a share of the greatest. That is the last frequency up to 20 Hz with a
/// magnitude of 0.05. No dimension; a minimum-jerk movement has -1.41 whatever its length and duration, less is
/// rougher. The paper ends at 10 Hz; here it is the 20 Hz of the same measure of 2012 (IEEE Transactions on Biomedical
/// Engineering 59), as tremor of 8 to 12 Hz across the movement has twice its frequency in the speed.
/// @param speeds at even intervals, mm/s @param period s between them
/// Nothing: fewer than two speeds, or all are 0.
std::optional<double> spectralArcLength(std::span<const double> speeds, double period);

/// The smoothness of a tool's tip along a recording: the mean of its movements, each counting with its duration.
/// A movement lies between pauses. A pause is a tip slower than 1 mm/s for at least 0.15 s, as the edit *Drop dwells*
/// has it. Speeds are those over 10 ms. Movements of less than 0.2 s are left out, those of more than 60 s are taken in
/// pieces of 60 s.
class TipSmoothness {
public:
    /// @param tickPeriod s, > 0
    explicit TipSmoothness(double tickPeriod);

    /// @param sample behind that of the call before
    void add(const Sample& sample);
    /// The movement is over: what follows does not continue it.
    void interrupt();
    /// Of all movements that are over, as `spectralArcLength`; nothing: there is none.
    std::optional<double> mean() const noexcept;

private:
    void addSpeed(double speed);
    void endMovement(std::size_t speeds);

    double tickPeriod_, period_; ///< s: of a tick, and of a speed
    std::uint64_t ticks_;        ///< of a speed
    std::optional<Sample> from_; ///< where the speed that is under way begins
    std::vector<double> speeds_; ///< mm/s, of the movement that is under way
    std::size_t slow_ = 0;       ///< how many of the last ones are slow
    bool resting_ = false;
    double sum_ = 0.0, seconds_ = 0.0;
};

} // namespace burin
