// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/calibration.h"

#include <complex>
#include <string>
#include <vector>

namespace burin {

/// The equation that a record gives for the coefficients: Ft = K(chip) · drive, Fr = Kr Ft.
struct ForceObservation {
    std::size_t line = 0;
    double drive = 0.0;                    ///< mm²: 1000 MRR / v, N per J/mm³
    double chip = 0.0;                     ///< mm, > 0
    double tangential = 0.0, radial = 0.0; ///< N
    double gain = 1.0;                     ///< error of either force for an error of 1 N in each measured component
    // For ChipLaw::edge: force = (Ktc + i Krc) ofChip + (Kte + i Kre) ofEdge, N; both parts have the same error.
    std::complex<double> force, ofChip, ofEdge; ///< N, mm², mm
};

/// @return the reason why the record can't be used; empty: `observation` was filled from it
std::string observe(const ForceRecord& record, const CalibrationOptions& options, ForceObservation& observation);

/// Robust least squares of Ft = K0 (h / h0)^-mc · drive, h0 the geometric mean of the chips (mc = 0 for a constant K),
/// and Fr = L (h / h0)^-mc · drive. One thread.
class ForceFit {
public:
    ForceFit(std::vector<ForceObservation> observations, bool withExponent);

    /// Finds outliers by a robust fit, then fits the others by least squares, repeated until nothing changes.
    void run();

    std::size_t counted() const noexcept;
    const std::vector<ForceObservation>& observations() const noexcept { return observations_; }
    /// Whether the robust estimate of K is not above 0.
    bool pointsAlong() const noexcept { return pointsAlong_; }
    double referenceChip() const noexcept { return referenceChip_; } ///< mm, h0

    Estimate specificEnergy() const noexcept;                  ///< K0, J/mm³
    Estimate exponent() const noexcept;                        ///< mc
    Estimate logarithmOfForceAtOneMillimetre() const noexcept; ///< ln kc1.1, kc1.1 in N/mm²
    Estimate radialEnergy() const noexcept;                    ///< L, J/mm³
    /// K0 with its error for a known mc, as the ratio of L and K0 does not depend on mc.
    Estimate energyForRatio() const noexcept;
    /// Writes the residuals, the excluded records with reasons, the chip thicknesses and the noise to the result.
    void report(MaterialCalibration& result) const;

private:
    void startRobustly();
    void leastSquares();
    bool select();
    double basis(const ForceObservation& o) const noexcept;              ///< N per J/mm³: (h / h0)^-mc · drive
    double tangentialResidual(const ForceObservation& o) const noexcept; ///< N, before its gain
    double radialResidual(const ForceObservation& o) const noexcept;
    double medianNoise(bool radial) const;
    double noise(bool radial) const;
    double limit() const noexcept;

    std::vector<ForceObservation> observations_;
    std::vector<bool> counts_;
    bool withExponent_, pointsAlong_ = false;
    double referenceChip_ = 1.0;
    double energy_ = 0.0, exponent_ = 0.0, radialEnergy_ = 0.0;
    double tangentialScale_ = 0.0, radialScale_ = 0.0; ///< N, noise used in the last selection
    /// Of the normal equations of (K0, mc), weighted; inverse: the covariance for noise of 1 N.
    double energyEnergy_ = 0.0, energyExponent_ = 0.0, exponentExponent_ = 0.0;
    double basisBasis_ = 0.0;
};

/// Robust least squares of Ktc + i Krc and Kte + i Kre. One thread.
class EdgeFit {
public:
    explicit EdgeFit(std::vector<ForceObservation> observations);

    /// Finds outliers by least absolute deviations, then fits the others by least squares, repeated until nothing
    /// changes.
    void run();

    std::size_t counted() const noexcept;
    std::size_t size() const noexcept { return observations_.size(); }
    std::complex<double> chip() const noexcept { return chip_; } ///< N/mm²
    std::complex<double> edge() const noexcept { return edge_; } ///< N/mm
    double chipError() const noexcept;                           ///< of either part
    double edgeError() const noexcept;
    /// Writes the residuals, the excluded records with reasons, the chip thicknesses and the noise to the result.
    void report(MaterialCalibration& result) const;

private:
    void solve(const std::vector<double>& weights);
    std::complex<double> residual(const ForceObservation& o) const noexcept;
    double noise() const;
    double limit() const noexcept;
    bool select(double scale);

    std::vector<ForceObservation> observations_;
    std::vector<bool> counts_;
    std::complex<double> chip_, edge_;
    double chipChip_ = 0.0, edgeEdge_ = 0.0, determinant_ = 0.0; ///< of the normal equations
    double scale_ = 0.0;                                         ///< N
};

} // namespace burin
