// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/film_actor.h"

#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLState.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace burin {
namespace {

constexpr double nearer = -4.0; // depth units, as for lines on a surface

class FilmActor final : public vtkOpenGLActor {
public:
    static FilmActor* New();
    void Render(vtkRenderer* renderer, vtkMapper* mapper) override {
        vtkOpenGLState* state = vtkOpenGLRenderer::SafeDownCast(renderer)->GetState();
        const vtkOpenGLState::ScopedglDepthMask before(state);
        state->vtkglDepthMask(0);
        mapper->Render(renderer, this);
    }

protected:
    FilmActor() = default;
};
vtkStandardNewMacro(FilmActor);

} // namespace

vtkSmartPointer<vtkActor> glassActor(vtkPolyData* surface) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->ScalarVisibilityOff();
    auto actor = vtkSmartPointer<FilmActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->BackfaceCullingOn();
    actor->PickableOff();
    actor->ForceOpaqueOn(); // VTK's translucent pass needs full-screen buffers (actors.h)
    return actor;
}

vtkSmartPointer<vtkActor> filmActor(vtkPolyData* surface) {
    const vtkSmartPointer<vtkActor> actor = glassActor(surface);
    actor->GetProperty()->BackfaceCullingOff();
    actor->GetProperty()->LightingOff();
    // As for lines (actors.cpp): VTK adds its global parameters to those of each mapper.
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
    double everyFactor = 0.0, everyUnits = 0.0;
    vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(everyFactor, everyUnits);
    actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-everyFactor, nearer - everyUnits);
    return actor;
}

} // namespace burin
