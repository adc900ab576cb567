// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/run_volume.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace burin {

/// Surface of everything in a workpiece but air, mm, setup frame, with normals and an sRGB colour a point: that of the
/// material under it. Drawn from how full each voxel is, so that sub-voxel run ends show as smooth floors.
vtkSmartPointer<vtkPolyData> workpieceSurface(const VolumeSnapshot& workpiece);

} // namespace burin
