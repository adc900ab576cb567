// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/force_arrow.h"

#include "ui/scene/actors.h"
#include "ui/scene/tool_actors.h"

#include <vtkArrowSource.h>
#include <vtkProperty.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace burin {
namespace {

constexpr double tipLength = 14.0, tipRadius = 5.5, shaftRadius = 1.8; // device-independent pixels
constexpr double labelDistance = 16.0;

/// An arrow of unit length along +Z, with the head size of an arrow of `length` pixels.
vtkSmartPointer<vtkPolyData> arrow(double length) {
    vtkNew<vtkArrowSource> source;
    source->SetTipLength(std::min(0.6, tipLength / length));
    source->SetTipRadius(tipRadius / length);
    source->SetShaftRadius(shaftRadius / length);
    source->SetTipResolution(20);
    source->SetShaftResolution(10);
    vtkNew<vtkTransform> upright; // the source points along +X
    upright->RotateY(-90.0);
    vtkNew<vtkTransformPolyDataFilter> turned;
    turned->SetInputConnection(source->GetOutputPort());
    turned->SetTransform(upright);
    turned->Update();
    return turned->GetOutput();
}

/// The length of the arrow on the screen, device-independent pixels.
double lengthFor(double newtons) {
    return std::min(ForceArrow::longest, 22.0 + newtons * ForceArrow::pixelsPerNewton);
}

} // namespace

ForceArrow::ForceArrow(vtkRenderer& renderer) : arrow_(surfaceActor(arrow(longest))), value_(renderer) {
    arrow_->GetProperty()->LightingOff();
    arrow_->PickableOff();
    arrow_->SetUserMatrix(matrix_);
    renderer.AddActor(arrow_);
    set(glm::dvec3(0.0), glm::dvec3(0.0));
}

void ForceArrow::setPalette(const Palette& palette) {
    colour_ = palette.force;
    plate_ = palette.field;
    plate_.setAlpha(190);
    setColour(*arrow_, colour_);
}

void ForceArrow::set(const glm::dvec3& force, const glm::dvec3& tip) {
    force_ = force;
    tip_ = tip;
    arrow_->SetVisibility(visible());
    value_.setVisible(visible());
}

bool ForceArrow::visible() const noexcept {
    return glm::length(force_) >= smallest;
}

void ForceArrow::place(const CameraView& view, const QSizeF& size, double ratio) {
    if (!visible()) return;
    const double newtons = glm::length(force_), pixel = pixelAt(view, size, tip_), length = lengthFor(newtons);
    const glm::dvec3 direction = force_ / newtons;
    setPose(*matrix_, {tip_, direction});
    // Keeps the size of the head: scaled by the length along the arrow, and by the maximum length across it.
    const double along = length * pixel, across = longest * pixel;
    for (int row = 0; row < 3; ++row) {
        matrix_->SetElement(row, 0, matrix_->GetElement(row, 0) * across);
        matrix_->SetElement(row, 1, matrix_->GetElement(row, 1) * across);
        matrix_->SetElement(row, 2, matrix_->GetElement(row, 2) * along);
    }
    value_.set(QCoreApplication::translate("burin::Viewport", "%1 N").arg(QLocale().toString(newtons, 'f', 1)), colour_,
               plate_, ratio);
    const QPointF head = appearanceOf(view, size, tip_ + direction * along), tail = appearanceOf(view, size, tip_);
    // Next to the head, away from the tail; above it when the arrow points at the eye.
    const QPointF way = head - tail;
    const double seen = std::hypot(way.x(), way.y());
    const QPointF beyond = seen > 4.0 ? way * (labelDistance / seen) : QPointF(0.0, -labelDistance);
    value_.setMiddle((head + beyond) * ratio, static_cast<int>(std::lround(size.height() * ratio)));
}

} // namespace burin
