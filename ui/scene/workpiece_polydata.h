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

/// The part where it is bare, whatever it is made of: nothing else on the workpiece is blue.
inline constexpr RgbColour barePartColour{74, 144, 217};

/// The colours of a surface's points by what they are made of; bare part has its own.
std::vector<RgbColour> colourByMaterial(const SurfaceMesh& mesh, const PropertyList& properties,
                                        const RgbColour& partColour);

/// A surface for VTK: points and normals in single precision, an sRGB colour a point. Any thread.
/// @param colours a point each
/// @param rim   edges (two points each) that get a skirt, at each point as deep as `skirt` says, mm, down into the
/// material and a third as far beyond
///              the rim, under the next piece: no light shows between this one and a coarser or finer one beside it
vtkSmartPointer<vtkPolyData> surfacePolyData(const SurfaceMesh& mesh, std::span<const RgbColour> colours,
                                             std::span<const std::uint32_t> rim = {},
                                             std::span<const float> skirt = {});

} // namespace burin
