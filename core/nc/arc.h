// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// Chord error that arcs are flattened to, mm.
inline constexpr double arcChordTolerance = 0.001;

/// A helical arc about an axis of the frame, mm.
struct Arc {
    glm::dvec3 from{0.0}, to{0.0};
    glm::dvec3 centre{0.0}; ///< its component along the axis has no meaning
    int axis = 2;           ///< 0 X (G19), 1 Y (G18), 2 Z (G17)
    bool clockwise = false; ///< seen against the axis (G2)
};

/// Why the end points and the centre give no arc; nullptr when they do. The rule of LinuxCNC's interp_arc.cc (2.9):
/// radii at both ends may differ by 0.0283 mm, or by 0.1 % where that is more, up to 2.83 mm.
const char* faultOf(const Arc& arc) noexcept;

/// Places along the arc behind `from`, ending exactly in `to`, with chords that leave it by no more than
/// arcChordTolerance. Equal end points in the arc's plane mean a full turn. The radius goes evenly from the one at the
/// start to the one at the end. @param places is overwritten
void flatten(const Arc& arc, std::vector<glm::dvec3>& places);

} // namespace burin
