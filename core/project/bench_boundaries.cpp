// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/bench_boundaries.h"

#include "core/haptics/fixed_axis_boundary.h"
#include "core/haptics/mesh_boundary.h"
#include "core/haptics/tool_boundaries.h"
#include "core/haptics/turned_field.h"

namespace burin {

namespace {

Result<std::unique_ptr<PoseBoundary>> partBoundary(const Bench& bench, const AxisMode& axis, double maximumAllowance,
                                                   Progress& progress) {
    using Boundary = std::unique_ptr<PoseBoundary>;
    if (axis.free) {
        const std::shared_ptr<const MeshDistance> part(std::shared_ptr<void>(), &bench.part); // the bench's own
        return Boundary(std::make_unique<MeshBoundary>(part, pieces(bench.tool.cutter), bench.setup.voxel));
    }
    if (axis.direction == glm::dvec3(0.0, 0.0, 1.0) || bench.model->bodies.empty()) {
        Result<std::unique_ptr<const ClearanceField>> field = clearanceField(bench, maximumAllowance, progress);
        if (!field) return std::move(field).error();
        return Boundary(std::make_unique<FixedAxisBoundary>(std::move(*field)));
    }
    const ToolFieldRequest request{pieces(bench.tool.cutter), bench.tipRegion(), bench.setup.voxel, maximumAllowance};
    Result<TurnedField> field = TurnedField::build(bench.part, axis.direction, request, progress);
    if (!field) return std::move(field).error();
    return Boundary(std::make_unique<FixedAxisBoundary>(std::make_unique<const TurnedField>(std::move(*field))));
}

} // namespace

Result<BoundaryLayers> boundaryLayers(const Bench& bench, const AxisMode& axis, const Surroundings& surroundings,
                                      double maximumAllowance, Progress& progress) {
    Result<std::unique_ptr<PoseBoundary>> part = partBoundary(bench, axis, maximumAllowance, progress);
    if (!part) return std::move(part).error();
    BoundaryLayers layers(std::move(*part));
    addLayers(layers, surroundings.obstacles, surroundings.envelope, bench.tool, bench.setup.voxel);
    return layers;
}

} // namespace burin
