// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkRenderer.h>

namespace burin {

/// Three lights that go with the eye, so that a surface keeps its shape from wherever it is looked at.
void addBenchLights(vtkRenderer& renderer);

/// Shades a surface by the bench's lights as an eye far away would see it: no reflection, power or root a light and
/// pixel, which in software takes half of the time of a picture. For opaque surfaces with normals at their points.
void shadeSimply(vtkActor& actor);

} // namespace burin
