// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkRenderer.h>

namespace burin {

/// Key from the upper left, weak fill from the right: what faces the viewer is never black.
void addBenchLights(vtkRenderer& renderer);

} // namespace burin
