// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// How far down into the material a skirt may reach at each point of a rim: no farther than half through it, so that no
/// skirt comes out of the other side of a wall. mm.
/// @param rim     points of the surface
/// @param deepest mm, where there is material enough
std::vector<float> skirtDepths(const VolumeSnapshot& workpiece, const SurfaceMesh& surface,
                               std::span<const std::uint32_t> rim, float deepest);

} // namespace burin
