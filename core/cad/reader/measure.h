// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <TopoDS_Shape.hxx>

namespace burin {

/// Returns the volume of a solid, mm³, by adaptive integration to 1e-6 relative: OpenCASCADE's default may be 3 % off.
double exactVolume(const TopoDS_Shape& solid);

/// Returns the area of a shape's faces, mm², to 1e-6 relative.
double exactArea(const TopoDS_Shape& shape);

std::size_t countFaces(const TopoDS_Shape& shape);

/// Returns the tight box of the geometry itself, mm, without tolerances, control points or triangulation.
Box exactBox(const TopoDS_Shape& shape);

} // namespace burin
