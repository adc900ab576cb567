// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/boundary_layers.h"
#include "core/haptics/boundary/fixed_axis_boundary.h"
#include "core/haptics/boundary/proxy.h"

namespace burin::test {

/// A proxy with a fixed axis, in a single field.
class TipProxy {
public:
    struct Step {
        glm::dvec3 tip{0.0};
        bool onBoundary = false;
        glm::dvec3 normal{0.0};
        int iterations = 0;
    };

    explicit TipProxy(const ClearanceField& field) : layers_(std::make_unique<FixedAxisBoundary>(field)) {}

    Step advance(const glm::dvec3& from, const glm::dvec3& goal, double allowance, double travel) {
        layers_.setAllowance(allowance);
        ProxyStride stride;
        stride.travel = travel;
        const ProxyStep step = Proxy(layers_).advance({from}, {goal}, stride);
        return {step.pose.tip, step.onBoundary, step.normal, step.iterations};
    }
    glm::dvec3 retreat(const glm::dvec3& from, double allowance, double travel) {
        layers_.setAllowance(allowance);
        return Proxy(layers_).retreat({from}, travel).tip;
    }
    bool feasible(const glm::dvec3& tip, double allowance) {
        layers_.setAllowance(allowance);
        return Proxy(layers_).feasible({tip});
    }
    double chordTolerance() { return Proxy(layers_).chordTolerance(); }

private:
    BoundaryLayers layers_;
};

} // namespace burin::test
