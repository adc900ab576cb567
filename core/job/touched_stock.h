// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/job/touched_face.h"
#include "core/setup/obstacle.h"
#include "core/setup/setup.h"

#include <optional>

namespace burin {

/// Returns the stock before milling as a solid that holds the tool, for touching off. Empty for a stock of solids or
/// from a file: only the sides of a box and a cylinder are known exactly.
std::optional<Obstacle> touchableStock(const Setup& setup);

/// Returns the coordinate of the stock's side along the axis of a face that was touched on it, mm, setup frame: that of
/// the stock itself, without the errors of contact and mesh. Empty if the face is not that side: a flank of a tilted
/// cylinder, or a fixture. @param face touched without an allowance, which the stock does not have
std::optional<double> sideTouched(const Setup& setup, const TouchedFace& face);

/// Moves an upright tool as a hand does until the stock holds it, and presses on by 1 mm. No session is needed.
/// The contact is found to Proxy::contactGap (0.001 mm).
/// @param tip start of the tip, mm, setup frame, clear of the stock @param towards unit
/// Errors: notSupported (see touchableStock), argumentInvalid (a tip in the stock, a direction that misses it).
Result<TouchedFace> touchStock(const Setup& setup, const Tool& tool, const glm::dvec3& tip, const glm::dvec3& towards);

} // namespace burin
