// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "core/path/stroke.h"

#include <functional>

namespace burin {

/// The farthest that an edit moved the path.
struct Deviation {
    double distance = 0.0; ///< mm
    glm::dvec3 place{0.0}; ///< mm, setup frame

    void include(double other, const glm::dvec3& at) noexcept {
        if (other > distance) *this = {other, at};
    }
    void include(const Deviation& other) noexcept { include(other.distance, other.place); }
};

/// Errors: argumentInvalid (a cut-off that a stroke's sampling can't tell). @param cutOff Hz
Result<void> checkCutOff(double cutOff, const PathUnderEdit& state);

/// The farthest that any stroke moved; each stroke is changed by itself, all of them in parallel, none any more once
/// the work is cancelled. @param change what an edit does to a stroke, and how far that moves it
Deviation changeEach(PathUnderEdit& state, const Progress& progress,
                     const std::function<Deviation(PathStroke&)>& change);

} // namespace burin
