// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/pose_steps.h"
#include "core/cutting/removed_units.h"
#include "core/volume/runs/run_volume.h"

#include <vector>

namespace burin {

/// Removes the volume that any flutes sweep between two poses, with any axis of the tool and of the runs, from the
/// machinable runs of a workpiece, scanline by scanline and written at once. Exact for a fixed axis (SweptPiece); a
/// rotating axis is split into steps that keep each point of the flutes within an eighth of a voxel of its position
/// (PoseSteps). No allocation, lock or exception in `cut`. Only on the workpiece's writer thread.
class SweepCutter {
public:
    static constexpr double turnTolerance = 0.125; ///< voxels
    /// @param pieces flutePieces(cutter) @param edge of a voxel, mm
    SweepCutter(std::vector<RevolvedPiece> pieces, double edge);

    /// Poses in the setup frame, finite, axes of unit length. Adds to `removed`.
    void cut(RunVolume& workpiece, const ToolPose& from, const ToolPose& to, RemovedUnits& removed) const noexcept;

private:
    bool cutStep(RunVolume& workpiece, const PoseStep& step, RunAmounts& taken, RemovedUnits& removed) const noexcept;

    std::vector<RevolvedPiece> pieces_;
    double reach_ = 0.0, tolerance_ = 0.0; ///< mm
};

} // namespace burin
