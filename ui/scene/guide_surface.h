// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace burin {

/// The surface of all tip positions at which the tool has a given distance from the part, as it is drawn.
struct GuideSurface {
    vtkSmartPointer<vtkPolyData> shell;    ///< triangles
    vtkSmartPointer<vtkPolyData> contours; ///< lines at round heights
};

/// Only where the field is fine, which is where a guide can act. Triangle corners lie on the surface within the field's
/// own error bound and a hundredth of its cell; the triangle size is 1/`guideSurfaceCells` of the longest side of
/// `tips`, and finer detail is lost. Takes some tenths of a second: call on a worker thread.
/// @param tips mm, setup frame: the region to search
GuideSurface guideSurface(const ClearanceField& field, const Box& tips, double distance);
inline constexpr int guideSurfaceCells = 120;

} // namespace burin
