// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/geometry/upright_holes.h"

namespace burin {

/// The round upright holes of all bodies of a part, in its frame, mm. Any thread. Cost: all triangles.
std::vector<UprightHole> uprightHoles(const Model& part);

/// Holes of one diameter.
struct HoleSize {
    double diameter = 0.0; ///< mm
    int count = 0;
};
/// How many there are of each diameter, within 0.01 mm, the smallest first.
std::vector<HoleSize> sizesOf(const std::vector<UprightHole>& holes);

} // namespace burin
