// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/touch_mark.h"

#include "core/base/units.h"
#include "ui/scene/across.h"
#include "ui/scene/actors.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {
namespace {

constexpr int outlineSides = 48;       // of the cutter's outline
constexpr double contactWidth = 4.0;   // in widths of a line
constexpr double labelDistance = 22.0; // device-independent pixels from the outline

std::vector<LineEnds> outlineOf(const PressMark& mark) {
    const Across across = acrossOf(mark.axis);
    std::vector<LineEnds> lines{{mark.tip, mark.tip + mark.axis * std::max(0.0, mark.depth)}};
    const auto at = [&](int side) {
        const double angle = 2.0 * pi * side / outlineSides;
        return mark.tip + mark.radius * (std::cos(angle) * across.x + std::sin(angle) * across.y);
    };
    for (int side = 0; side < outlineSides; ++side) lines.emplace_back(at(side), at(side + 1));
    return lines;
}

vtkSmartPointer<vtkPolyData> dotData(const glm::dvec3& place) {
    vtkNew<vtkPoints> points;
    const vtkIdType point = points->InsertNextPoint(place.x, place.y, place.z);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(1, &point);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetVerts(cells);
    return data;
}

void giveData(vtkActor& actor, vtkPolyData* data) {
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(data);
}

} // namespace

TouchMark::TouchMark(vtkRenderer& renderer)
    : lines_(lineActor(vtkNew<vtkPolyData>())), contact_(lineActor(vtkNew<vtkPolyData>())), depth_(renderer) {
    contact_->GetProperty()->RenderPointsAsSpheresOn();
    renderer.AddActor(lines_);
    renderer.AddActor(contact_);
    set({});
}

void TouchMark::setPalette(const Palette& palette) {
    colour_ = palette.text;
    plate_ = palette.panel;
    plate_.setAlphaF(0.85F);
    setColour(*lines_, palette.text);
    setColour(*contact_, palette.accent);
}

void TouchMark::setLineWidth(double screenPixels) {
    burin::setLineWidth(*lines_, screenPixels);
    contact_->GetProperty()->SetPointSize(static_cast<float>(contactWidth * screenPixels));
}

void TouchMark::set(const std::optional<PressMark>& mark) {
    mark_ = mark;
    lines_->SetVisibility(mark.has_value());
    contact_->SetVisibility(mark && mark->contact);
    depth_.setVisible(mark.has_value());
    if (!mark) return;
    giveData(*lines_, lineData(outlineOf(*mark)));
    if (mark->contact) giveData(*contact_, dotData(*mark->contact));
}

void TouchMark::place(const CameraView& view, const QSizeF& size, double ratio) {
    if (!mark_) return;
    const QString depth = lengthText(mark_->depth, unit_);
    depth_.set(mark_->contact ? QCoreApplication::translate("burin::Viewport", "Part at %1").arg(depth)
                              : QCoreApplication::translate("burin::Viewport", "%1 deep").arg(depth),
               colour_, plate_, ratio);
    const QPointF beside(mark_->radius / pixelAt(view, size, mark_->tip) + labelDistance, labelDistance);
    depth_.setUpperLeft((appearanceOf(view, size, mark_->tip) + beside) * ratio,
                        static_cast<int>(std::lround(size.height() * ratio)));
}

} // namespace burin
