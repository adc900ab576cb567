// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/gizmo_actors.h"

#include "core/base/units.h"
#include "ui/scene/actors.h"
#include "ui/scene/gizmo_geometry.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {

namespace {

constexpr double headRadius = 5.0, headRim = 1.5; // device-independent pixels
constexpr int headSides = 16;
constexpr double squareOpacity = 0.45, litSquareOpacity = 0.8;
constexpr QPointF valueBeside(18.0, 14.0); // device-independent pixels from the pointer

vtkSmartPointer<vtkPolyData> polygons(const GizmoLine& points, const std::vector<std::vector<vtkIdType>>& loops) {
    vtkNew<vtkPoints> places;
    places->SetDataTypeToDouble();
    for (const glm::dvec3& point : points) places->InsertNextPoint(point.x, point.y, point.z);
    vtkNew<vtkCellArray> polys;
    for (const std::vector<vtkIdType>& loop : loops)
        polys->InsertNextCell(static_cast<vtkIdType>(loop.size()), loop.data());
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(places);
    data->SetPolys(polys);
    return data;
}

/// The head of an arrow: a cone that ends at the tip.
vtkSmartPointer<vtkPolyData> cone(const glm::dvec3& tip, int axis, double pixel) {
    const glm::dvec3 along = axisDirection(axis), u = axisDirection((axis + 1) % 3), v = axisDirection((axis + 2) % 3),
                     base = tip - gizmoHeadLength * pixel * along;
    GizmoLine points{tip};
    std::vector<std::vector<vtkIdType>> loops(1);
    for (int i = 0; i < headSides; ++i) {
        const double angle = 2.0 * pi * i / headSides;
        points.push_back(base + headRadius * pixel * (std::cos(angle) * u + std::sin(angle) * v));
        loops.push_back({0, i + 1, (i + 1) % headSides + 1});
        loops.front().push_back(headSides - i);
    }
    return polygons(points, loops);
}

vtkSmartPointer<vtkPolyData> linesOf(const GizmoLine& line) {
    std::vector<LineEnds> pieces;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) pieces.emplace_back(line[i], line[i + 1]);
    return lineData(pieces);
}

void showGizmoData(vtkActor& actor, vtkPolyData* data) {
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(data);
}

} // namespace

GizmoActors::GizmoActors(vtkRenderer& renderer) : value_(renderer) {
    std::size_t next = 0;
    for (const GizmoPart part : {GizmoPart::square, GizmoPart::ring, GizmoPart::arrow})
        for (int axis = 0; axis < 3; ++axis) {
            Drawn& drawn = handles_[next++];
            drawn.handle = {part, axis};
            if (part != GizmoPart::ring) {
                drawn.face = surfaceActor(vtkNew<vtkPolyData>());
                drawn.face->GetProperty()->LightingOff();
                drawn.face->PickableOff();
                renderer.AddActor(drawn.face);
            }
            if (part == GizmoPart::arrow) {
                drawn.rim = surfaceActor(vtkNew<vtkPolyData>());
                drawn.rim->GetProperty()->LightingOff();
                drawn.rim->GetProperty()->FrontfaceCullingOn(); // only what protrudes around the head is seen
                drawn.rim->PickableOff();
                renderer.AddActor(drawn.rim);
            }
            drawn.line = std::make_unique<HaloedLines>(renderer);
        }
    set({});
}

void GizmoActors::setPalette(const Palette& palette) {
    axes_ = {palette.force, palette.inOrder, palette.part}; // as for the axes of the view cube
    accent_ = palette.chosenPath;
    halo_ = palette.pathHalo;
    text_ = palette.text;
    plate_ = palette.panel;
    plate_.setAlphaF(0.85F);
}

void GizmoActors::setLineWidth(double screenPixels) {
    for (const Drawn& drawn : handles_) drawn.line->setWidth(screenPixels);
}

void GizmoActors::set(const std::optional<GizmoMark>& mark) {
    mark_ = mark;
    for (Drawn& drawn : handles_) hide(drawn);
    value_.setVisible(mark && !mark->value.isEmpty());
}

void GizmoActors::draw(Drawn& drawn, const CameraView& view, double pixel) const {
    const GizmoLine line = handleLine(mark_->gizmo, drawn.handle, view, pixel);
    const QColor colour = lit(drawn.handle) ? accent_ : axes_[static_cast<std::size_t>(drawn.handle.axis)];
    drawn.line->setLines(linesOf(line));
    drawn.line->setColours(colour, halo_);
    drawn.line->setVisible(true);
    if (!drawn.face) return;
    const bool arrow = drawn.handle.part == GizmoPart::arrow;
    showGizmoData(*drawn.face, arrow ? cone(line.back(), drawn.handle.axis, pixel) : polygons(line, {{0, 1, 2, 3}}));
    setColour(*drawn.face, colour);
    if (!arrow) setBlended(*drawn.face, lit(drawn.handle) ? litSquareOpacity : squareOpacity);
    drawn.face->VisibilityOn();
    if (!drawn.rim) return;
    const glm::dvec3 beyond = 2.0 * headRim * pixel * axisDirection(drawn.handle.axis);
    showGizmoData(*drawn.rim, cone(line.back() + beyond, drawn.handle.axis, pixel * (1.0 + headRim / headRadius)));
    setColour(*drawn.rim, halo_);
    drawn.rim->VisibilityOn();
}

void GizmoActors::hide(Drawn& drawn) {
    drawn.line->setVisible(false);
    for (vtkActor* actor : {drawn.face.Get(), drawn.rim.Get()})
        if (actor != nullptr) actor->VisibilityOff();
}

void GizmoActors::place(const CameraView& view, const QSizeF& size, double ratio) {
    if (!mark_) return;
    const std::vector<GizmoHandle> offered = offeredHandles(mark_->gizmo, view);
    const double pixel = pixelAt(view, size, mark_->gizmo.centre);
    for (Drawn& drawn : handles_) {
        // During a drag its handle is drawn alone, so that what is moved can be seen.
        const bool shown =
            mark_->value.isEmpty() ? std::ranges::find(offered, drawn.handle) != offered.end() : lit(drawn.handle);
        shown ? draw(drawn, view, pixel) : hide(drawn);
    }
    if (mark_->value.isEmpty()) return;
    value_.set(mark_->value, text_, plate_, ratio);
    value_.setUpperLeft((mark_->pointer + valueBeside) * ratio, static_cast<int>(std::lround(size.height() * ratio)));
}

} // namespace burin
