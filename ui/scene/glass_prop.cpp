// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/glass_prop.h"

#include <vtkBoundingBox.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLState.h>
#include <vtk_glew.h>

namespace burin {

vtkStandardNewMacro(GlassProp);

int GlassProp::RenderOpaqueGeometry(vtkViewport* viewport) {
    vtkOpenGLState* state = vtkOpenGLRenderer::SafeDownCast(viewport)->GetState();
    {
        const vtkOpenGLState::ScopedglColorMask before(state);
        state->vtkglColorMask(0, 0, 0, 0);
        drawAll(viewport);
    }
    const vtkOpenGLState::ScopedglDepthFunc before(state);
    state->vtkglDepthFunc(GL_LEQUAL);
    return drawAll(viewport);
}

int GlassProp::drawAll(vtkViewport* viewport) const {
    int drawn = 0;
    for (vtkActor* actor : actors_) drawn |= actor->RenderOpaqueGeometry(viewport);
    return drawn;
}

double* GlassProp::GetBounds() {
    vtkBoundingBox box;
    for (vtkActor* actor : actors_) box.AddBounds(actor->GetBounds());
    if (!box.IsValid()) return nullptr;
    box.GetBounds(bounds_.data());
    return bounds_.data();
}

} // namespace burin
