// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/guide_marks.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace burin {

/// What a guide is drawn with. None of them is null.
struct GuideShapes {
    vtkSmartPointer<vtkPolyData> film;  ///< a patch of surface
    vtkSmartPointer<vtkPolyData> lines; ///< that stand out while it holds
    vtkSmartPointer<vtkPolyData> quiet; ///< lines that never do: the other levels
    vtkSmartPointer<vtkPolyData> tube;  ///< lines that are drawn as a tube
};

/// Of a plane its patch in the room; of levels the patch of the one that holds, and the outlines of those next to it;
/// of a line and a curve the line itself; of a step-over the two curves beside the last pass, and that pass quietly. A
/// surface's shapes take longer (guideSurface); those of lead and tilt follow the tool.
GuideShapes shapesOf(const GuideMark& mark, const GuideMarks& all);
/// Outlines that are drawn on either side of the level that holds; more would be a curtain.
inline constexpr int levelsBeside = 12;

/// Lead and tilt at the tool, in units that `length` mm make: the normal that they start from, the axis that they want,
/// and the arc between the two.
GuideShapes leaningShapes(const GuideMark& mark, const glm::dvec3& tip, double length);

/// Whether the one needs other shapes than the other, the tool's place and the highlight aside.
bool shapedAlike(const GuideMark& one, const GuideMark& other);

} // namespace burin
