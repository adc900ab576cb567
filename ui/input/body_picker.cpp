// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/body_picker.h"

#include "core/geometry/triangle_ray.h"

#include <limits>
#include <utility>

namespace burin {

bool BodyPicker::press(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton || !model_) return false;
    const std::optional<SeenBody> seen = bodyOn(sightOf(event), *model_, hidden_);
    taken_ = seen.has_value();
    if (seen) emit chosen(seen->body, seen->place);
    return taken_;
}

bool BodyPicker::release(const ViewportEvent& event) {
    return event.button == Qt::LeftButton && std::exchange(taken_, false);
}

std::optional<SeenBody> bodyOn(const Sight& sight, const Model& model, const std::set<std::size_t>& hidden) {
    const Ray ray{sight.seenOrigin(), sight.direction};
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<SeenBody> found;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        if (hidden.contains(i)) continue;
        const TriangleMesh& mesh = model.bodies[i].mesh;
        for (const auto& corners : mesh.triangles) {
            const auto hit =
                hitOf(ray, {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]});
            if (!hit || hit->distance >= nearest) continue;
            nearest = hit->distance;
            found = SeenBody{i, ray.origin + hit->distance * ray.direction};
        }
    }
    return found;
}

} // namespace burin
