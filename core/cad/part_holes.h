// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/geometry/upright_holes.h"

namespace burin {

/// Returns the round vertical holes of all bodies of a part, in its frame, mm. Thread-safe. Cost: linear in the
/// triangles.
std::vector<UprightHole> uprightHoles(const Model& part);
/// The same for its round vertical studs.
std::vector<UprightHole> uprightStuds(const Model& part);

/// Holes, or studs, of one diameter.
struct HoleSize {
    double diameter = 0.0; ///< mm
    int count = 0;
};
/// Returns the number of holes of each diameter, equal within 0.01 mm, the smallest diameter first.
std::vector<HoleSize> sizesOf(const std::vector<UprightHole>& holes);

} // namespace burin
