// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

using RgbColour = std::array<std::uint8_t, 3>; ///< sRGB

/// The colour of bare part, regardless of its material: nothing else on the workpiece is blue.
inline constexpr RgbColour barePartColour{74, 144, 217};

/// The colours of a surface's points by their material; bare part has its own colour.
std::vector<RgbColour> colourByMaterial(const SurfaceMesh& mesh, const PropertyList& properties,
                                        const RgbColour& partColour);

/// A surface as VTK data: points and normals in single precision, one sRGB colour per point. Any thread.
/// @param colours one per point
/// @param rim   edges (two points each) that get a skirt; at each point it extends by the depth in `skirt`, mm, down
/// into the material and a third as far beyond the rim, under the next piece, so that no gap is visible between this
/// piece and a coarser or finer one next to it
vtkSmartPointer<vtkPolyData> surfacePolyData(const SurfaceMesh& mesh, std::span<const RgbColour> colours,
                                             std::span<const std::uint32_t> rim = {},
                                             std::span<const float> skirt = {});

} // namespace burin
