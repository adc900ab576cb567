// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"

namespace burin {

/// The nearest tip that the boundary allows (god-object: Zilles & Salisbury 1995; Ruspini 1997), axis fixed.
struct ProxyStep {
    glm::dvec3 tip{0.0};       ///< mm
    bool onBoundary = false;   ///< held back
    glm::dvec3 normal{0.0};    ///< of the boundary at the tip, unit, out of the part; zero when free
    int iterations = 0;
};

/// Moves a proxy from a feasible tip towards a goal without passing the surface clearance = allowance: marches in
/// steps no longer than the clearance, slides along up to three planes solved together, never accepts an infeasible
/// tip. Travels at most `maximumTravel` a tick. No allocation.
class Proxy {
public:
    explicit Proxy(const ClearanceField& field) noexcept : field_(&field) {}

    /// @param from feasible: clearance >= allowance. @param goal mm, anywhere.
    ProxyStep advance(const glm::dvec3& from, const glm::dvec3& goal, double allowance, double maximumTravel) const noexcept;

    bool feasible(const glm::dvec3& tip, double allowance) const noexcept;

private:
    const ClearanceField* field_;
};

} // namespace burin
