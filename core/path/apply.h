// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "core/path/stroke.h"

#include <functional>

namespace burin {

/// The largest distance by which an edit moved the path.
struct Deviation {
    double distance = 0.0; ///< mm
    glm::dvec3 place{0.0}; ///< mm, setup frame

    void include(double other, const glm::dvec3& at) noexcept {
        if (other > distance) *this = {other, at};
    }
    void include(const Deviation& other) noexcept { include(other.distance, other.place); }
};

/// Errors: argumentInvalid (a cut-off too high for the sampling of a stroke). @param cutOff Hz
Result<void> checkCutOff(double cutOff, const PathUnderEdit& state);

/// Applies a change to each stroke by itself, in parallel, and returns the largest distance by which any stroke moved.
/// Once the work is cancelled, no further stroke is changed.
/// @param change changes one stroke and returns how far it moved
Deviation changeEach(PathUnderEdit& state, const Progress& progress,
                     const std::function<Deviation(PathStroke&)>& change);

} // namespace burin
