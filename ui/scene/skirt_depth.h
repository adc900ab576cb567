// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The permitted depth of a skirt into the material at each point of a rim, mm: at most half the material's thickness,
/// so that no skirt protrudes from the other side of a wall.
/// @param rim     points of the surface
/// @param deepest mm, where the material is thick enough
std::vector<float> skirtDepths(const VolumeSnapshot& workpiece, const SurfaceMesh& surface,
                               std::span<const std::uint32_t> rim, float deepest);

} // namespace burin
