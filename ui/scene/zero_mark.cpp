// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/zero_mark.h"

#include "ui/scene/actors.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <cmath>
#include <vector>

namespace burin {

namespace {

constexpr double axisLength = 44.0, headLength = 9.0;   // device-independent pixels
constexpr double labelBeside = 24.0, labelBelow = 13.0; // likewise, of its centre from zero

/// An arrow along an axis, with a head that is visible from every side.
std::vector<LineEnds> arrow(const glm::dvec3& from, int axis, double pixel) {
    glm::dvec3 along(0.0);
    along[axis] = 1.0;
    const glm::dvec3 tip = from + axisLength * pixel * along;
    std::vector<LineEnds> lines{{from, tip}};
    for (const int other : {(axis + 1) % 3, (axis + 2) % 3})
        for (const double side : {-0.4, 0.4}) {
            glm::dvec3 across(0.0);
            across[other] = side;
            lines.emplace_back(tip, tip + headLength * pixel * (across - along));
        }
    return lines;
}

} // namespace

ZeroMark::ZeroMark(vtkRenderer& renderer) : name_(renderer) {
    for (vtkSmartPointer<vtkActor>& axis : axes_) {
        axis = lineActor(vtkNew<vtkPolyData>());
        renderer.AddActor(axis);
    }
    set({});
}

void ZeroMark::setPalette(const Palette& palette) {
    colour_ = palette.text;
    plate_ = palette.panel;
    plate_.setAlphaF(0.85F);
    const std::array colours{palette.force, palette.inOrder, palette.part}; // as for the axes of the view cube
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) setColour(*axes_[axis], colours[axis]);
}

void ZeroMark::setLineWidth(double screenPixels) {
    for (const vtkSmartPointer<vtkActor>& axis : axes_) burin::setLineWidth(*axis, screenPixels);
}

void ZeroMark::set(const std::optional<ZeroPlace>& zero) {
    zero_ = zero;
    pixel_ = 0.0;
    for (const vtkSmartPointer<vtkActor>& axis : axes_) axis->SetVisibility(zero.has_value());
    name_.setVisible(zero.has_value());
}

void ZeroMark::place(const CameraView& view, const QSizeF& size, double ratio) {
    if (!zero_) return;
    const double pixel = pixelAt(view, size, zero_->place);
    if (pixel != pixel_) {
        pixel_ = pixel;
        for (std::size_t axis = 0; axis < axes_.size(); ++axis)
            vtkPolyDataMapper::SafeDownCast(axes_[axis]->GetMapper())
                ->SetInputData(lineData(arrow(zero_->place, static_cast<int>(axis), pixel)));
    }
    name_.set(zero_->name, colour_, plate_, ratio);
    name_.setMiddle((appearanceOf(view, size, zero_->place) + QPointF(-labelBeside, labelBelow)) * ratio,
                    static_cast<int>(std::lround(size.height() * ratio)));
}

} // namespace burin
