// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/glass_prop.h"

#include <vtkBoundingBox.h>
#include <vtkObjectFactory.h>

namespace burin {

vtkStandardNewMacro(GlassProp);

int GlassProp::RenderOpaqueGeometry(vtkViewport* viewport) {
    int rendered = 0;
    for (vtkActor* actor : actors_) rendered |= actor->RenderOpaqueGeometry(viewport);
    return rendered;
}

double* GlassProp::GetBounds() {
    vtkBoundingBox box;
    for (vtkActor* actor : actors_) box.AddBounds(actor->GetBounds());
    if (!box.IsValid()) return nullptr;
    box.GetBounds(bounds_.data());
    return bounds_.data();
}

} // namespace burin
