// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/guide_marks.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace burin {

/// The shapes with which a guide is drawn. None of them is null.
struct GuideShapes {
    vtkSmartPointer<vtkPolyData> film;  ///< a patch of surface
    vtkSmartPointer<vtkPolyData> lines; ///< lines that are highlighted while the guide constrains the hand
    vtkSmartPointer<vtkPolyData> quiet; ///< lines that are never highlighted: the other levels
    vtkSmartPointer<vtkPolyData> tube;  ///< lines that are drawn as a tube
};

/// For a plane, its patch within the box `room`; for levels, the patch of the current level and the outlines of its
/// neighbours; for a line or a curve, the line itself; for a step-over, the two curves beside the last pass, and that
/// pass subdued. The shapes of a surface take longer (guideSurface); those of lead and tilt follow the tool.
GuideShapes shapesOf(const GuideMark& mark, const GuideMarks& all);
/// The number of outlines drawn on either side of the current level; more would obscure the view.
inline constexpr int levelsBeside = 12;

/// Lead and tilt at the tool, scaled to `length` mm: the reference normal, the requested axis, and the arc between the
/// two.
GuideShapes leaningShapes(const GuideMark& mark, const glm::dvec3& tip, double length);

/// Whether two marks have the same shapes, apart from the tool's position and the highlighting.
bool shapedAlike(const GuideMark& one, const GuideMark& other);

} // namespace burin
