// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/section_actors.h"

#include "core/volume/operations/section.h"
#include "ui/scene/actors.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <vector>

namespace burin {
namespace {

constexpr double faceShade = 0.82;     // fraction of a material's colour: distinguishes the cut face from lit surfaces
constexpr double arrowLength = 34.0;   // device-independent pixels on either side
constexpr double gripReach = 14.0;     // device-independent pixels from the middle of the handle
constexpr double gripWidth = 5.5;      // in widths of a line
constexpr double beyondContent = 0.03; // of the content's diagonal: the outline extends this far beyond the content

void showData(vtkActor& actor, vtkPolyData* data) {
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(data);
}

/// A point of the plane. @param across coordinates along the two axes that follow the plane's axis
glm::dvec3 placeOn(const SectionPlane& plane, const glm::dvec2& across) {
    glm::dvec3 place(0.0);
    place[plane.axis] = plane.position;
    place[(plane.axis + 1) % 3] = across.x;
    place[(plane.axis + 2) % 3] = across.y;
    return place;
}

vtkSmartPointer<vtkPolyData> faceData(const std::vector<SectionPatch>& patches, const SectionPlane& plane,
                                      const PropertyList& properties, const std::array<std::uint8_t, 3>& partColour) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    vtkNew<vtkCellArray> quads;
    for (const SectionPatch& patch : patches) {
        const bool bare = properties.isProtected(patch.property);
        const auto& colour = bare ? partColour : properties[patch.property].colour;
        const vtkIdType first = points->GetNumberOfPoints();
        for (const glm::dvec2& corner :
             {patch.low, glm::dvec2(patch.high.x, patch.low.y), patch.high, glm::dvec2(patch.low.x, patch.high.y)}) {
            const glm::dvec3 place = placeOn(plane, corner);
            points->InsertNextPoint(place.x, place.y, place.z);
            colours->InsertNextTuple3(colour[0] * faceShade, colour[1] * faceShade, colour[2] * faceShade);
        }
        quads->InsertNextCell({first, first + 1, first + 2, first + 3});
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(quads);
    data->GetPointData()->SetScalars(colours);
    return data;
}

} // namespace

SectionActors::SectionActors(vtkRenderer& solids, vtkRenderer& marks)
    : face_(surfaceActor(vtkNew<vtkPolyData>()))
    , outline_(lineActor(vtkNew<vtkPolyData>()))
    , arrow_(lineActor(vtkNew<vtkPolyData>()))
    , grip_(lineActor(vtkNew<vtkPolyData>())) {
    face_->GetMapper()->ScalarVisibilityOn();
    face_->GetMapper()->SetColorModeToDirectScalars();
    face_->GetProperty()->LightingOff();
    grip_->GetProperty()->RenderPointsAsSpheresOn();
    solids.AddActor(face_);
    for (const auto& actor : {outline_, arrow_, grip_}) marks.AddActor(actor);
    set({});
}

void SectionActors::setPalette(const Palette& palette) {
    partColour_ = {static_cast<std::uint8_t>(palette.part.red()), static_cast<std::uint8_t>(palette.part.green()),
                   static_cast<std::uint8_t>(palette.part.blue())};
    for (const auto& actor : {outline_, arrow_, grip_}) setColour(*actor, palette.accent);
    stale_ = true;
}

void SectionActors::set(const std::optional<SectionPlane>& plane) {
    plane_ = plane;
    stale_ = true;
    for (const auto& actor : {face_, outline_}) actor->SetVisibility(plane.has_value());
    setHandle(handle_);
    if (!plane) return showData(*face_, vtkNew<vtkPolyData>());
    glm::dvec3 kept(0.0), place(0.0);
    kept[plane->axis] = plane->keepsLow ? -1.0 : 1.0;
    place[plane->axis] = plane->position;
    clip_->SetNormal(kept.x, kept.y, kept.z);
    clip_->SetOrigin(place.x, place.y, place.z);
}

void SectionActors::setHandle(bool visible) {
    handle_ = visible;
    for (const auto& actor : {arrow_, grip_}) actor->SetVisibility(handle_ && plane_.has_value());
}

void SectionActors::setLineWidth(double screenPixels) {
    for (const auto& actor : {outline_, arrow_}) burin::setLineWidth(*actor, screenPixels);
    grip_->GetProperty()->SetPointSize(static_cast<float>(gripWidth * screenPixels));
}

void SectionActors::drawFace(const VolumeSnapshot& workpiece) {
    stale_ = false;
    if (workpiece.empty()) return showData(*face_, vtkNew<vtkPolyData>());
    showData(*face_, faceData(sectionOf(workpiece, plane_->axis, plane_->position), *plane_, workpiece.properties(),
                              partColour_));
}

void SectionActors::place(const VolumeSnapshot& workpiece, const Box& content, const CameraView& view,
                          const QSizeF& size) {
    if (!plane_) return;
    if (stale_) drawFace(workpiece);
    const Box around = content.grown(beyondContent * glm::length(content.size()));
    const int first = (plane_->axis + 1) % 3, second = (plane_->axis + 2) % 3;
    const glm::dvec2 low(around.low[first], around.low[second]), high(around.high[first], around.high[second]);
    const std::array corners{placeOn(*plane_, low), placeOn(*plane_, {high.x, low.y}), placeOn(*plane_, high),
                             placeOn(*plane_, {low.x, high.y})};
    std::vector<LineEnds> lines;
    for (std::size_t i = 0; i < corners.size(); ++i) lines.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
    showData(*outline_, lineData(lines));
    // At the corner that is nearest to the eye; for a vertical plane, at its upper edge.
    const glm::dvec3 back = axesOf(view).back;
    const auto nearest = [&](int axis) { return axis != 2 && back[axis] < 0.0 ? around.low[axis] : around.high[axis]; };
    gripPlace_ = placeOn(*plane_, {nearest(first), nearest(second)});
    glm::dvec3 along(0.0);
    along[plane_->axis] = arrowLength * pixelAt(view, size, gripPlace_);
    const std::array<LineEnds, 1> arrow{{{gripPlace_ - along, gripPlace_ + along}}};
    showData(*arrow_, lineData(arrow));
    const vtkSmartPointer<vtkPolyData> dot = lineData(arrow);
    vtkNew<vtkCellArray> verts;
    const vtkIdType middle = dot->GetPoints()->InsertNextPoint(gripPlace_.x, gripPlace_.y, gripPlace_.z);
    verts->InsertNextCell(1, &middle);
    dot->SetLines(nullptr);
    dot->SetVerts(verts);
    showData(*grip_, dot);
}

bool SectionActors::gripAt(const CameraView& view, const QSizeF& size, const QPointF& position) const {
    if (!plane_) return false;
    const QPointF way = appearanceOf(view, size, gripPlace_) - position;
    return std::hypot(way.x(), way.y()) <= gripReach;
}

double SectionActors::dragged(const CameraView& view, const QSizeF& size, const QPointF& from,
                              const QPointF& to) const {
    glm::dvec3 axis(0.0);
    axis[plane_->axis] = 1.0;
    const auto began = alongAxis(sightThrough(view, size, from), gripPlace_, axis);
    const auto now = alongAxis(sightThrough(view, size, to), gripPlace_, axis);
    if (began && now) return plane_->position + *now - *began;
    // The axis points at the eye: moving up in the picture is moving nearer.
    const double towards = axesOf(view).back[plane_->axis] > 0.0 ? 1.0 : -1.0;
    return plane_->position + towards * (from.y() - to.y()) * pixelAt(view, size, gripPlace_);
}

} // namespace burin
