// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"
#include "core/haptics/boundary/pose_boundary.h"
#include "core/machine/envelope.h"

#include <vector>

namespace burin {

/// A machine's envelope as a boundary: the clearance is the smallest distance of the tip, or of the tool's farthest
/// point, from a face of the corresponding box. Exact.
class EnvelopeBoundary final : public PoseBoundary {
public:
    /// @param tool pieces(cutter) @param voxel edge of the workpiece's voxels, mm
    EnvelopeBoundary(const Envelope& envelope, std::vector<RevolvedPiece> tool, double voxel);

    PoseSample at(const ToolPose& pose, double enough) noexcept override;
    double errorBound() const noexcept override { return 0.0; }
    double spacing() const noexcept override { return voxel_; }
    double overlap() const noexcept override;
    double reach() const noexcept override { return reach_; }

private:
    Envelope envelope_;
    std::vector<RevolvedPiece> tool_;
    double voxel_, reach_; ///< mm
};

} // namespace burin
