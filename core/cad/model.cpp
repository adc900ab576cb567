// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/model.h"

#include "core/geometry/mesh_parts.h"

namespace burin {

namespace {

/// Returns the placed box of a body, tight if the axes stay parallel to those of the frame. Otherwise the box of the
/// mesh, grown by the chord by which the mesh may lie inside the surface, intersected with the box around the placed
/// box.
Box placedBox(const Body& placedBody, const Box& before, double chord, const Placement& placement) {
    Box box = boxAround(before, placement);
    if (alongAxes(placement) || placedBody.mesh.empty()) return box;
    const Box mesh = boundingBox(placedBody.mesh).grown(chord);
    box.low = glm::max(box.low, mesh.low);
    box.high = glm::min(box.high, mesh.high);
    return box;
}

void place(Body& body, double chord, const Placement& placement) {
    place(body.mesh, placement);
    body.box = placedBox(body, body.box, chord, placement);
}

} // namespace

Box Model::box() const {
    Box whole;
    for (const Body& body : bodies) whole.include(body.box);
    return whole;
}

double Model::volume() const {
    double sum = 0.0;
    for (const Body& body : bodies) sum += body.volume;
    return sum;
}

std::shared_ptr<const Model> placed(std::shared_ptr<const Model> model, const Placement& placement) {
    if (model == nullptr || isNone(placement)) return model;
    auto other = std::make_shared<Model>(*model);
    for (Body& body : other->bodies) place(body, other->meshChord, placement);
    other->brepPlacement = combined(other->brepPlacement, placement);
    return other;
}

} // namespace burin
