// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/sight.h"

#include <algorithm>

namespace burin {

/// Where part and workpiece are cut open to be looked into; what is milled stays as it is.
struct SectionPlane {
    int axis = 1;          ///< 0, 1, 2 for x, y, z: the plane is square to it
    double position = 0.0; ///< mm along it, setup frame
    bool keepsLow = false; ///< what lies lower along the axis stays to be seen, instead of what lies higher
    friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

/// How far along a sight what the plane keeps begins, mm; beyond everything where the sight stays in what is cut away.
inline double seenFrom(const SectionPlane& plane, const Sight& sight) noexcept {
    constexpr double never = 1e9; // finite: places are reckoned with it
    const double before = (plane.keepsLow ? 1.0 : -1.0) * (sight.origin[plane.axis] - plane.position);
    if (before <= 0.0) return 0.0; // the eye is on the side that is kept
    const double nearer = (plane.keepsLow ? -1.0 : 1.0) * sight.direction[plane.axis];
    return nearer > 0.0 ? std::min(before / nearer, never) : never;
}

} // namespace burin
