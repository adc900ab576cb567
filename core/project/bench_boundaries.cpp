// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/bench_boundaries.h"

#include "core/haptics/fixed_axis_boundary.h"
#include "core/haptics/mesh_boundary.h"
#include "core/haptics/turned_field.h"

#include <utility>

namespace burin {

namespace {

constexpr glm::dvec3 upright(0.0, 0.0, 1.0);

using Field = std::shared_ptr<const ClearanceField>;

Result<Field> fieldFor(const Bench& bench, const Tool& tool, const glm::dvec3& axis, double maximumAllowance,
                       Progress& progress) {
    if (axis == upright || bench.model->bodies.empty()) {
        Result<std::unique_ptr<const ClearanceField>> field = clearanceField(bench, tool, maximumAllowance, progress);
        if (!field) return std::move(field).error();
        return Field(std::move(*field));
    }
    const ToolFieldRequest request{pieces(tool.cutter), bench.tipRegion(tool), bench.setup.voxel, maximumAllowance};
    Result<TurnedField> field = TurnedField::build(bench.part, axis, request, progress);
    if (!field) return std::move(field).error();
    return Field(std::make_shared<const TurnedField>(std::move(*field)));
}

Result<void> checkObstacles(const std::vector<Obstacle>& obstacles) {
    constexpr std::size_t most = ToolBounds::capacity - 2;
    if (obstacles.size() > most)
        return Error{ErrorCode::argumentInvalid, "obstacles", std::to_string(obstacles.size()),
                     "0 to " + std::to_string(most)};
    for (const Obstacle& obstacle : obstacles)
        if (Result<void> usable = checkObstacle(obstacle); !usable) return usable;
    return {};
}

bool limits(const Envelope& envelope) {
    return !envelope.tips.empty() || !envelope.tools.empty();
}

std::vector<BoundLayer> namesOf(const Surroundings& surroundings) {
    using Kind = BoundLayer::Kind;
    std::vector<BoundLayer> layers{{Kind::part, {}, true}};
    for (const Obstacle& obstacle : surroundings.obstacles)
        layers.push_back(
            {obstacle.kind == ObstacleKind::fixture ? Kind::fixture : Kind::keepOut, obstacle.name, obstacle.on});
    if (limits(surroundings.envelope)) layers.push_back({Kind::machineTravel, {}, true});
    return layers;
}

} // namespace

Surroundings surroundingsOf(const Bench& bench, const TravelPlacement& placement, const AxisMode& axis) {
    Surroundings surroundings;
    surroundings.obstacles = bench.obstacles;
    if (!axis.free && axis.direction == upright)
        surroundings.envelope = travelEnvelope(bench.machine, placement, bench.setup.workOffset);
    return surroundings;
}

ToolBounds::ToolBounds(const ClearanceField& part) : ToolBounds(Field(std::shared_ptr<void>(), &part)) {}

ToolBounds::ToolBounds(std::shared_ptr<const ClearanceField> part) : field_(std::move(part)), layers_(namesOf({})) {}

Result<ToolBounds> ToolBounds::build(const Bench& bench, const Tool& tool, const AxisMode& axis,
                                     const Surroundings& surroundings, double maximumAllowance, Progress& progress) {
    if (!axis.free && !(std::abs(glm::length(axis.direction) - 1.0) < 1e-6))
        return Error{ErrorCode::argumentInvalid, "axis", {}, "a vector of unit length"};
    if (Result<void> usable = checkObstacles(surroundings.obstacles); !usable) return std::move(usable).error();
    ToolBounds bounds;
    if (!axis.free) {
        Result<Field> field = fieldFor(bench, tool, axis.direction, maximumAllowance, progress);
        if (!field) return std::move(field).error();
        bounds.field_ = std::move(*field);
    }
    bounds.axis_ = axis;
    bounds.mesh_ = &bench.part;
    bounds.voxel_ = bench.setup.voxel;
    bounds.tool_ = tool;
    bounds.obstacles_ = solidsOf(surroundings.obstacles);
    bounds.envelope_ = surroundings.envelope;
    bounds.layers_ = namesOf(surroundings);
    return bounds;
}

BoundaryLayers ToolBounds::boundaryLayers() const {
    std::unique_ptr<PoseBoundary> part;
    if (field_) {
        part = std::make_unique<FixedAxisBoundary>(field_);
    } else {
        const std::shared_ptr<const MeshDistance> mesh(std::shared_ptr<void>(), mesh_); // the bench's own
        part = std::make_unique<MeshBoundary>(mesh, pieces(tool_.cutter), voxel_);
    }
    BoundaryLayers layers(std::move(part));
    addLayers(layers, std::span<const ObstacleSolid>(obstacles_), envelope_, tool_, voxel_);
    return layers;
}

Result<BoundaryLayers> boundaryLayers(const Bench& bench, const AxisMode& axis, const Surroundings& surroundings,
                                      double maximumAllowance, Progress& progress) {
    const Result<ToolBounds> bounds =
        ToolBounds::build(bench, bench.tool, axis, surroundings, maximumAllowance, progress);
    if (!bounds) return bounds.error();
    return bounds->boundaryLayers();
}

} // namespace burin
