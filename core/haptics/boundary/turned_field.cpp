// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/turned_field.h"

#include "core/geometry/frame_along.h"

#include <utility>

namespace burin {

/// Equal vertices remain equal to the last bit.
TriangleMesh turnedPart(const MeshDistance& part, const glm::dmat3& turn) {
    const std::span<const Triangle> triangles = part.triangles();
    TriangleMesh mesh;
    mesh.vertices.reserve(3 * triangles.size());
    mesh.triangles.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const glm::dvec3& corner : triangle) mesh.vertices.push_back(turn * corner);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

Result<TurnedField> TurnedField::build(const MeshDistance& part, const glm::dvec3& axis,
                                       const ToolFieldRequest& request, Progress& progress) {
    if (!(std::abs(glm::length(axis) - 1.0) < 1e-6))
        return Error{ErrorCode::argumentInvalid, "axis", {}, "a vector of unit length"};
    if (request.tips.empty()) return Error{ErrorCode::argumentInvalid, "tips", {}, "a box that is not empty"};
    const glm::dmat3 turn = frameAlong(glm::normalize(axis));
    ToolFieldRequest seen = request;
    seen.tips = boxAround(request.tips, turn);
    Result<ToolField> field = ToolField::build(MeshDistance(turnedPart(part, turn)), seen, progress);
    if (!field) return std::move(field).error();
    return TurnedField(turn, std::move(*field));
}

FieldSample TurnedField::at(const glm::dvec3& tip) const noexcept {
    FieldSample sample = field_.at(turn_ * tip);
    sample.gradient = sample.gradient * turn_; // rotated back by the transposed matrix
    return sample;
}

} // namespace burin
