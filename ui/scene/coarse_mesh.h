// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/shaded_mesh.h"

namespace burin {

/// A mesh with fewer triangles, for while things move: some of its points, with their normals. Creases and borders stay
/// as they are; the rest lies within the tolerance. Any thread; some tenths of a second for a hundred thousand
/// triangles.
/// @param tolerance mm
ShadedMesh coarsened(const ShadedMesh& mesh, double tolerance);

} // namespace burin
