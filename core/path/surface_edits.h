// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits that know the part, and those that thin what they leave, in any order.

/// Pushes every place of the path out of the part, grown by the take's allowance plus `clearance`: closest point on the
/// fine mesh at the points and every `sampling` between them, closer where a corner may be cut. Points that carry no
/// shape (0.002 mm) are dropped first. Afterwards every place of every move within a stroke keeps at least the
/// allowance. What is not pushed out within a few steps is lifted along the tool axis.
struct HoldOut {
    double clearance = 0.005; ///< mm
    double sampling = 0.1;    ///< mm
};

/// Fewest points such that no dropped one is farther than `tolerance` from the result (Douglas & Peucker, distance to
/// segments). Never lets a segment enter the part: a shortcut that would is not taken.
struct Simplify {
    double tolerance = 0.01; ///< mm
};

} // namespace burin
