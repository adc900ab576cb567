// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/deviation_actors.h"

#include "ui/scene/actors.h"
#include "ui/scene/shaded_polydata.h"

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

namespace burin {
namespace {

/// Most of a colour is ambient, so that it can be compared with the legend regardless of a face's direction; the
/// remainder is lit, so that the shape can be recognised.
constexpr double ownLight = 0.62, shading = 0.38;

vtkSmartPointer<vtkActor> deviationActor(vtkRenderer& renderer) {
    vtkSmartPointer<vtkActor> actor = surfaceActor(vtkNew<vtkPolyData>());
    actor->GetProperty()->SetAmbient(ownLight);
    actor->GetProperty()->SetDiffuse(shading);
    actor->GetProperty()->SetSpecular(0.0);
    actor->VisibilityOff();
    actor->PickableOff();
    renderer.AddActor(actor);
    return actor;
}

vtkSmartPointer<vtkUnsignedCharArray> scalarsOf(const std::vector<DeviationColour>& colours) {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
    for (std::size_t i = 0; i < colours.size(); ++i) array->SetTypedTuple(static_cast<vtkIdType>(i), colours[i].data());
    return array;
}

void give(vtkActor& actor, vtkPolyData* data) {
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(data);
    actor.SetVisibility(data->GetNumberOfPolys() > 0);
}

} // namespace

DeviationActors::DeviationActors(vtkRenderer& renderer)
    : measured_(deviationActor(renderer)), unmeasured_(deviationActor(renderer)) {
    measured_->GetMapper()->ScalarVisibilityOn();
    measured_->GetMapper()->SetColorModeToDirectScalars();
    setColour(*unmeasured_, QColor(unmeasuredColour[0], unmeasuredColour[1], unmeasuredColour[2]));
    // Stripes in screen space, so that grey is never mistaken for a shaded value.
    unmeasured_->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Color::Impl", true,
        "//VTK::Color::Impl\n"
        "  if (mod(gl_FragCoord.x + gl_FragCoord.y, 9.0) < 3.0) { ambientColor *= 0.55; diffuseColor *= 0.55; }\n",
        false);
}

void DeviationActors::set(const DeviationSurface& surface) {
    triangles_ = (surface.mesh.triangles.size() + surface.unmeasured.size()) / 3;
    const ShadedPolyData measured = polyDataOf(surface.mesh);
    measured.surface->GetPointData()->SetScalars(scalarsOf(surface.colours));
    give(*measured_, measured.surface);
    ShadedMesh others{surface.mesh.points, surface.mesh.normals, surface.unmeasured, {}, {}};
    give(*unmeasured_, polyDataOf(others).surface);
}

} // namespace burin
