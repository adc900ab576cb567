// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/placement.h"
#include "core/setup/obstacle.h"

namespace burin {

/// The rotations that the shape of an obstacle can hold.
enum class HeldRotations : std::uint8_t {
    quarterTurns, ///< a box: its edges stay parallel to the axes of the setup frame
    aboutZ,       ///< a fixture of the library: it stands upright
    any
};
HeldRotations heldRotations(const Obstacle& obstacle) noexcept;

/// Returns the obstacle moved and rotated. @param by sound, and no mirror image (isSound, mirrors)
/// Errors: argumentInvalid (subject: its name, detail: what is allowed).
Result<Obstacle> moved(const Obstacle& obstacle, const Placement& by);

} // namespace burin
