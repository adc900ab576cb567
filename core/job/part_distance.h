// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/geometry/mesh_distance.h"

namespace burin {

/// The distance from all bodies of a model, in its frame.
MeshDistance distanceFrom(const Model& model);
/// The distance from the part of a project, setup frame: MillingContext::part where nothing else of the context is
/// needed, which would also make the stock. Errors: those of Project.
Result<MeshDistance> partDistance(const Project& project);

} // namespace burin
