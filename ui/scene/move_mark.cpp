// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/move_mark.h"

#include "ui/scene/actors.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>

#include <vector>

namespace burin {

MoveMark::MoveMark(vtkRenderer& renderer) : line_(lineActor(vtkNew<vtkPolyData>())) {
    line_->VisibilityOff();
    line_->PickableOff();
    renderer.AddActor(line_);
}

void MoveMark::setPalette(const Palette& palette) {
    setColour(*line_, palette.text);
}

void MoveMark::setLineWidth(double screenPixels) {
    burin::setLineWidth(*line_, screenPixels);
}

void MoveMark::set(std::span<const glm::dvec3> places) {
    std::vector<LineEnds> lines;
    for (std::size_t i = 1; i < places.size(); ++i) lines.emplace_back(places[i - 1], places[i]);
    vtkPolyDataMapper::SafeDownCast(line_->GetMapper())->SetInputData(lineData(lines));
    line_->SetVisibility(!lines.empty());
}

} // namespace burin
