// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// A rectangle of one material in a plane perpendicular to an axis, mm, setup frame; `low` and `high` along the two
/// axes that follow the plane's axis by cyclic exchange (for a plane across z: x, y).
struct SectionPatch {
    glm::dvec2 low{0.0}, high{0.0};
    PropertyIndex property = airProperty;
};

/// The section of a workpiece by a plane: all runs that it intersects, air excluded. Exact along the runs, resolved to
/// the scanline across them.
/// @param axis  0, 1, 2 for x, y, z: the plane is perpendicular to it  @param position  mm along it
/// @return empty if the plane does not intersect the grid or the snapshot is empty
/// Thread   any.
/// Cost     grows with the scanlines that the plane intersects. A plane perpendicular to the runs intersects all:
/// beyond 300,000 only every second, third, … is evaluated and represents its neighbours.
std::vector<SectionPatch> sectionOf(const VolumeSnapshot& workpiece, int axis, double position);

} // namespace burin
