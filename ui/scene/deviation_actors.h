// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/deviation_surface.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace burin {

/// The surface of the deviation map, hatched where it has no value. Hidden until it has triangles.
class DeviationActors {
public:
    explicit DeviationActors(vtkRenderer& renderer);
    /// Sets the surface; if it has no triangles, nothing is drawn.
    void set(const DeviationSurface& surface);
    bool empty() const noexcept { return triangles_ == 0; }
    std::size_t triangles() const noexcept { return triangles_; }

private:
    vtkSmartPointer<vtkActor> measured_, unmeasured_;
    std::size_t triangles_ = 0;
};

} // namespace burin
