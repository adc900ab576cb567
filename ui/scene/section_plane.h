// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/sight.h"

#include <algorithm>

namespace burin {

/// The plane at which part and workpiece are cut open for display; the milled workpiece itself is unchanged.
struct SectionPlane {
    int axis = 1;          ///< 0, 1, 2 for x, y, z: normal of the plane
    double position = 0.0; ///< mm along it, setup frame
    bool keepsLow = false; ///< whether the lower side along the axis remains visible, instead of the upper one
    friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

/// The distance along a sight line at which the kept side of the plane begins, mm; very large if the sight line stays
/// in the removed side.
inline double seenFrom(const SectionPlane& plane, const Sight& sight) noexcept {
    constexpr double never = 1e9; // finite, because positions are computed from it
    const double before = (plane.keepsLow ? 1.0 : -1.0) * (sight.origin[plane.axis] - plane.position);
    if (before <= 0.0) return 0.0; // the eye is on the kept side
    const double nearer = (plane.keepsLow ? -1.0 : 1.0) * sight.direction[plane.axis];
    return nearer > 0.0 ? std::min(before / nearer, never) : never;
}

} // namespace burin
