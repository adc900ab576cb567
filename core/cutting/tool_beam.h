// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

#include <array>

namespace burin {

/// A tool as a beam clamped at the holder's face: its deflection under a force perpendicular to its axis, and the
/// resulting stress. Flutes count as a shaft of 0.8 of their diameter, which is usual for end mills (Kops & Vo 1990).
/// Shear and the compliance of chuck and spindle are left out: a real tool deflects more.
class ToolBeam {
public:
    explicit ToolBeam(const Tool& tool);

    /// Returns the deflection at the point where the force acts, mm; 0 if the tool's modulus is not stated.
    /// @param force N, across the axis. @param height mm above the tip
    double bendingUnder(double force, double height) const noexcept;
    /// Returns the greatest bending stress along the tool, N/mm².
    double stressUnder(double force, double height) const noexcept;

private:
    static constexpr int slices = 128;
    struct Slice {
        double height = 0.0;  ///< mm above the tip, of its middle
        double modulus = 0.0; ///< mm³, of its section
        /// Of the slices from here to the holder: sums of x^k dx / I, 1/mm³, 1/mm², 1/mm.
        double sum0 = 0.0, sum1 = 0.0, sum2 = 0.0;
    };
    std::array<Slice, slices> slices_{};
    double modulus_ = 0.0, top_ = 0.0; ///< N/mm²; mm, of the holder's face
    double holderModulus_ = 0.0;       ///< mm³, of the section at the holder's face
};

/// A tool of brittle material withstands cuts up to a third of its breaking stress: forces are reported as the mean
/// over a turn, and a single tooth of a real tool with run-out has about twice that, thousands of times a minute.
inline constexpr double breakingReserve = 3.0;

} // namespace burin
