// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"
#include "core/haptics/boundary/newest_sample.h"
#include "core/haptics/boundary/pose_boundary.h"

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// Half the diameter of a ball that fits into each piece, mm: after a smaller motion every piece overlaps its previous
/// position.
double overlapOf(std::span<const RevolvedPiece> tool) noexcept;

/// A solid as a boundary for a tool with a free axis: the clearance of the tool from a closed, outward-oriented mesh,
/// exact for the mesh.
class MeshBoundary final : public PoseBoundary {
public:
    /// @param solid never null @param tool pieces(cutter) @param voxel edge of the workpiece's voxels, mm
    /// @param margin distance that the tool keeps from it, mm
    MeshBoundary(std::shared_ptr<const MeshDistance> solid, std::vector<RevolvedPiece> tool, double voxel,
                 double margin = 0.0);

    PoseSample at(const ToolPose& pose, double enough) noexcept override;
    double errorBound() const noexcept override { return 1e-6; }
    double spacing() const noexcept override { return voxel_; }
    double overlap() const noexcept override { return overlap_; }
    double reach() const noexcept override { return reach_; }
    std::uint64_t work() const noexcept override { return asker_.work(); }

private:
    PoseSample ask(const ToolPose& pose, double enough) noexcept;

    std::shared_ptr<const MeshDistance> solid_;
    std::vector<RevolvedPiece> tool_;
    double voxel_, margin_, reach_, overlap_; ///< mm
    ClearanceAsker asker_;
    NewestSample newest_;
};

} // namespace burin
