// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/haloed_lines.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace burin {
namespace {

constexpr double haloWidth = 2.0, dotWidth = 3.0; // in widths of the line

} // namespace

HaloedLines::HaloedLines(vtkRenderer& renderer)
    : renderer_(renderer)
    , halo_(raisedLineActor(vtkNew<vtkPolyData>(), seamHeight))
    , line_(raisedLineActor(vtkNew<vtkPolyData>(), overSeamHeight)) {
    setVisible(false);
    renderer_.AddActor(halo_);
    renderer_.AddActor(line_);
}

HaloedLines::~HaloedLines() {
    renderer_.RemoveActor(halo_);
    renderer_.RemoveActor(line_);
}

void HaloedLines::setLines(vtkPolyData* lines) {
    for (vtkActor* actor : {halo_.Get(), line_.Get()})
        vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(lines);
}

void HaloedLines::setLinesAndDots(vtkPolyData* lines) {
    // A dot is at the same depth as its halo, which is drawn first; so the halo contains no dots.
    vtkNew<vtkPolyData> withoutDots;
    withoutDots->ShallowCopy(lines);
    withoutDots->SetVerts(nullptr);
    vtkPolyDataMapper::SafeDownCast(halo_->GetMapper())->SetInputData(withoutDots);
    vtkPolyDataMapper::SafeDownCast(line_->GetMapper())->SetInputData(lines);
}

void HaloedLines::setColours(const QColor& line, const QColor& halo) {
    setColour(*line_, line);
    setColour(*halo_, halo);
}

void HaloedLines::setWidth(double screenPixels) {
    setLineWidth(*line_, screenPixels);
    setLineWidth(*halo_, haloWidth * screenPixels);
    line_->GetProperty()->SetPointSize(static_cast<float>(dotWidth * screenPixels));
}

void HaloedLines::setVisible(bool visible) {
    halo_->SetVisibility(visible);
    line_->SetVisibility(visible);
}

} // namespace burin
