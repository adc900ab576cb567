// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// A rectangle of one material in a plane square to an axis, mm, setup frame; `low` and `high` along the two axes that
/// follow the plane's by cyclic exchange (of a plane z: x, y).
struct SectionPatch {
    glm::dvec2 low{0.0}, high{0.0};
    PropertyIndex property = airProperty;
};

/// What a plane cuts through: all runs that it meets, air left out. Exact along the runs, to the scanline across them.
/// @param axis 0, 1, 2 for x, y, z: the plane is square to it  @param position mm along it
/// @return nothing where the plane passes beside the grid, or the snapshot is empty
/// Thread   any.
/// Cost     grows with the scanlines that the plane meets. Square to the runs it meets all: beyond 300,000 only every
///          second, third, … is looked at, and stands for its neighbours.
std::vector<SectionPatch> sectionOf(const VolumeSnapshot& workpiece, int axis, double position);

} // namespace burin
