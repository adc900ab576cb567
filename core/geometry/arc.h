// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// A helical arc about an axis of the frame, mm.
struct Arc {
    glm::dvec3 from{0.0}, to{0.0};
    glm::dvec3 centre{0.0}; ///< its component along the axis has no meaning
    int axis = 2;           ///< 0 X (G19), 1 Y (G18), 2 Z (G17)
    bool clockwise = false; ///< seen against the axis (G2)
};

/// An arc in polar coordinates of its plane. The radius changes linearly from the one at the start to the one at the
/// end.
struct ArcTurn {
    double startRadius = 0.0, endRadius = 0.0; ///< mm
    double startAngle = 0.0;                   ///< rad, from the plane's first axis to its second
    double sweep = 0.0;                        ///< rad, anticlockwise positive; equal ends are a full turn
};
/// The plane's axes are the two that follow the arc's own, in cyclic order (X Y Z X).
ArcTurn turnOf(const Arc& arc) noexcept;

/// The point at a share of the sweep, 0 … 1; exactly the end points at 0 and 1.
glm::dvec3 placeOn(const Arc& arc, const ArcTurn& turn, double share) noexcept;

/// Length in mm, including the rise. Exact on a circle; if the radii differ by more than 1e-9 mm, approximated by 512
/// chords per turn.
double lengthOf(const Arc& arc, const ArcTurn& turn) noexcept;

/// Points along the arc after `from`, ending exactly in `to`, with chords that deviate from it by no more than
/// `chordTolerance` mm, which must be > 0. Equal end points in the arc's plane mean a full turn.
/// @param places is overwritten
void flatten(const Arc& arc, double chordTolerance, std::vector<glm::dvec3>& places);

} // namespace burin
