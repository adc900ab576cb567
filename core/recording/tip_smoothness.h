// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Returns the smoothness of a movement from its speeds: the spectral arc length (SPARC) of Balasubramanian,
/// Melendez-Calderon, Roby-Brami and Burdet, On the analysis of movement smoothness, Journal of NeuroEngineering and
/// Rehabilitation 12:112 (2015). It is the negative length of the curve of the speed's magnitude spectrum, with the
/// frequency as a fraction of the cut-off frequency and the magnitude as a fraction of the greatest. The cut-off is the
/// last frequency up to 20 Hz with a magnitude of at least 0.05. Dimensionless; a minimum-jerk movement has -1.41
/// whatever its length and duration, a lower value is rougher. The paper ends at 10 Hz; the limit of 20 Hz is that of
/// the same measure of 2012 (IEEE Transactions on Biomedical Engineering 59), as tremor of 8 to 12 Hz across the
/// movement has twice its frequency in the speed.
/// @param speeds at equal intervals, mm/s @param period s between them
/// @return empty for fewer than two speeds, or if all are 0
std::optional<double> spectralArcLength(std::span<const double> speeds, double period);

/// Computes the smoothness of a tool's tip along a recording: the mean over its movements, weighted by duration.
/// Movements are separated by pauses, in which the tip is slower than 1 mm/s for at least 0.15 s, as in the edit *Drop
/// dwells*. Speeds are computed over 10 ms. Movements of less than 0.2 s are ignored, those of more than 60 s are
/// divided into pieces of 60 s.
class TipSmoothness {
public:
    /// @param tickPeriod s, > 0
    explicit TipSmoothness(double tickPeriod);

    /// @param sample later than that of the previous call
    void add(const Sample& sample);
    /// Ends the movement: later samples do not continue it.
    void interrupt();
    /// The mean over all ended movements, as `spectralArcLength`; empty if there is none.
    std::optional<double> mean() const noexcept;

private:
    void addSpeed(double speed);
    void endMovement(std::size_t speeds);

    double tickPeriod_, period_; ///< s: of a tick, and of a speed value
    std::uint64_t ticks_;        ///< per speed value
    std::optional<Sample> from_; ///< start of the current speed interval
    std::vector<double> speeds_; ///< mm/s, of the current movement
    std::size_t slow_ = 0;       ///< number of the last speeds that are slow
    bool resting_ = false;
    double sum_ = 0.0, seconds_ = 0.0;
};

} // namespace burin
