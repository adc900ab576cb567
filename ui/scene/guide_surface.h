// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace burin {

/// All places of a tool's tip at a distance of the tool from the part, as it is drawn.
struct GuideSurface {
    vtkSmartPointer<vtkPolyData> shell;    ///< triangles
    vtkSmartPointer<vtkPolyData> contours; ///< lines at round heights
};

/// Where the field is fine, which is where a guide can hold. Corners of the triangles lie on the surface within the
/// field's own bound and a hundredth of its cell; the triangles are as large as a `guideSurfaceCells`th of the longest
/// side of `tips`, and cut off what is finer. Takes some tenths of a second: for a worker thread.
/// @param tips mm, setup frame: where to look
GuideSurface guideSurface(const ClearanceField& field, const Box& tips, double distance);
inline constexpr int guideSurfaceCells = 120;

} // namespace burin
