// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/deviation_points.h"

#include "ui/scene/actors.h"
#include "ui/theme/deviation_colours.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <array>

namespace burin {

DeviationPoints::DeviationPoints(vtkRenderer& renderer) : points_(raisedLineActor(vtkNew<vtkPolyData>())) {
    points_->GetMapper()->ScalarVisibilityOn();
    points_->GetMapper()->SetColorModeToDirectScalars();
    points_->VisibilityOff();
    points_->PickableOff();
    renderer.AddActor(points_);
}

void DeviationPoints::setPalette(const Palette& palette) {
    palette_ = palette;
    colour();
}

void DeviationPoints::setSize(double screenPixels) {
    points_->GetProperty()->SetPointSize(static_cast<float>(screenPixels));
}

void DeviationPoints::set(std::span<const DeviationSample> samples, const DeviationTolerance& tolerance) {
    vtkNew<vtkPoints> places;
    vtkNew<vtkCellArray> vertices;
    bands_.clear();
    for (const DeviationSample& sample : samples) {
        const vtkIdType id = places->InsertNextPoint(sample.place.x, sample.place.y, sample.place.z);
        vertices->InsertNextCell(1, &id);
        bands_.push_back(bandOf(sample, tolerance));
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(places);
    data->SetVerts(vertices);
    vtkPolyDataMapper::SafeDownCast(points_->GetMapper())->SetInputData(data);
    points_->SetVisibility(!bands_.empty());
    colour();
}

void DeviationPoints::colour() {
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    for (const DeviationBand band : bands_) {
        const QColor colour = palette_.*roleOf(band);
        const std::array<unsigned char, 3> rgb{static_cast<unsigned char>(colour.red()),
                                               static_cast<unsigned char>(colour.green()),
                                               static_cast<unsigned char>(colour.blue())};
        colours->InsertNextTypedTuple(rgb.data());
    }
    vtkPolyDataMapper::SafeDownCast(points_->GetMapper())->GetInput()->GetPointData()->SetScalars(colours);
}

} // namespace burin
