// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/mesh_boundary.h"

#include "core/cutting/pose_steps.h"
#include "core/geometry/clearance_gradient.h"

#include <algorithm>
#include <utility>

namespace burin {
namespace {

constexpr double ridgeShare = 0.01; // of a voxel: distance from a contact up to which a ridge of the tool may pass

} // namespace

double overlapOf(std::span<const RevolvedPiece> tool) noexcept {
    double least = std::numeric_limits<double>::infinity();
    for (const RevolvedPiece& piece : tool)
        least = std::min({least, piece.widestRadius(), 0.5 * (piece.top - piece.bottom)});
    return least;
}

MeshBoundary::MeshBoundary(std::shared_ptr<const MeshDistance> solid, std::vector<RevolvedPiece> tool, double voxel,
                           double margin)
    : solid_(std::move(solid))
    , tool_(std::move(tool))
    , voxel_(voxel)
    , margin_(margin)
    , reach_(reachOf(tool_))
    , overlap_(overlapOf(tool_))
    , asker_(*solid_, tool_) {}

PoseSample MeshBoundary::at(const ToolPose& pose, double enough) noexcept {
    return newest_.at(pose, enough, [this](const ToolPose& at, double within) { return ask(at, within); });
}

PoseSample MeshBoundary::ask(const ToolPose& pose, double enough) noexcept {
    const double within = enough + margin_;
    const ToolClearance found = asker_.ask(pose, within, {});
    PoseSample sample{enough, glm::dvec3(0.0), glm::dvec3(0.0), false};
    if (!(found.clearance < within)) return sample;
    sample.clearance = found.clearance - margin_;
    sample.gradient = clearanceGradient(tool_, pose, found, ridgeShare * voxel_).gradient;
    const glm::dvec3 turning = glm::cross(found.meshPoint - pose.tip, sample.gradient);
    sample.turning = turning - glm::dot(turning, pose.axis) * pose.axis;
    sample.fine = true;
    return sample;
}

} // namespace burin
