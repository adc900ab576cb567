// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/part_distance.h"

#include <utility>

namespace burin {

MeshDistance distanceFrom(const Model& model) {
    TriangleMesh mesh;
    for (const Body& body : model.bodies) append(mesh, body.mesh);
    return MeshDistance(mesh);
}

Result<MeshDistance> partDistance(const Project& project) {
    Result<std::shared_ptr<const Model>> model = project.placedModel();
    if (!model) return std::move(model).error();
    const Result<Setup> setup = project.setup();
    if (!setup) return setup.error();
    return distanceFrom(*protectedPart(std::move(*model), *setup));
}

} // namespace burin
