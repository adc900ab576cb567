// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace burin {

/// A block of 40 × 36 × 60 mm with a corner at the origin, all its edges rounded with 6 mm.
inline TopoDS_Shape roundedBlock() {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(40.0, 36.0, 60.0).Shape();
    BRepFilletAPI_MakeFillet fillet(block);
    for (TopExp_Explorer edges(block, TopAbs_EDGE); edges.More(); edges.Next())
        fillet.Add(6.0, TopoDS::Edge(edges.Current()));
    return fillet.Shape();
}

// By Steiner's formula, from the block of 28 × 24 × 48 mm that is offset 6 mm inwards: faces, quarters of cylinders,
// eighths of balls.
inline constexpr double innerFaces = 28.0 * 24.0 + 24.0 * 48.0 + 48.0 * 28.0, innerEdges = 28.0 + 24.0 + 48.0;
inline constexpr double roundedVolume =
    28.0 * 24.0 * 48.0 + 2.0 * 6.0 * innerFaces + pi * 36.0 * innerEdges + 4.0 / 3.0 * pi * 216.0;      // mm³
inline constexpr double roundedArea = 2.0 * innerFaces + 2.0 * pi * 6.0 * innerEdges + 4.0 * pi * 36.0; // mm²

} // namespace burin
