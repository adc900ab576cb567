// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"

namespace burin {

/// The nearest tip that the boundary allows (god-object: Zilles & Salisbury 1995; Ruspini 1997), axis fixed.
struct ProxyStep {
    glm::dvec3 tip{0.0};     ///< mm
    bool onBoundary = false; ///< held back
    glm::dvec3 normal{0.0};  ///< of the boundary at the tip, unit, out of the part; zero when free
    int iterations = 0;
};

/// Moves a proxy from a feasible tip towards a goal without passing the surface clearance = allowance: marches in
/// steps no longer than the clearance, slides along up to three planes solved together, never accepts an infeasible
/// tip. Feasible means clearance >= allowance.
/// The straight way from `from` to the answer is feasible too, but for `chordTolerance`: what is swept or written to a
/// path between two ticks keeps to the boundary as well as the ticks themselves.
/// Every accepted step comes nearer to the goal, so the proxy rests where the goal rests.
/// A function of its arguments: no state, no allocation, any thread.
class Proxy {
public:
    static constexpr int maximumIterations = 24;
    /// mm of clearance, beyond the allowance, that the proxy rests at when it is pressed against the boundary.
    static constexpr double restingGap = 1e-4;
    /// mm of clearance, beyond the allowance, up to which a proxy counts as touching the boundary.
    static constexpr double contactGap = 1e-3;

    explicit Proxy(const ClearanceField& field) noexcept : field_(&field) {}

    /// @param from feasible; an infeasible one stays where it is. @param goal mm, anywhere.
    /// @param maximumTravel mm; length of the way is no longer.
    ProxyStep advance(const glm::dvec3& from, const glm::dvec3& goal, double allowance,
                      double maximumTravel) const noexcept;

    /// Moves an infeasible tip out along the clearance's gradient, by `maximumTravel` (mm) at most. A tip that gains no
    /// clearance any more (a pocket too narrow for the allowance) stays.
    glm::dvec3 retreat(const glm::dvec3& from, double allowance, double maximumTravel) const noexcept;

    bool feasible(const glm::dvec3& tip, double allowance) const noexcept;
    double clearance(const glm::dvec3& tip) const noexcept { return field_->at(tip).clearance; }

    /// mm below the allowance that the straight way between two ticks may have.
    double chordTolerance() const noexcept;

private:
    const ClearanceField* field_;
};

} // namespace burin
