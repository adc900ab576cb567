// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <TopoDS_Shape.hxx>

namespace burin {

/// Volume of a solid, mm³, by adaptive integration to 1e-6 relative: OpenCASCADE's default may be 3 % off.
double exactVolume(const TopoDS_Shape& solid);

/// Area of a shape's faces, mm², to 1e-6 relative.
double exactArea(const TopoDS_Shape& shape);

std::size_t countFaces(const TopoDS_Shape& shape);

/// Tight box of the geometry itself, mm: no tolerances, no control points, no triangulation.
Box exactBox(const TopoDS_Shape& shape);

} // namespace burin
