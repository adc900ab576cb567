// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/document/project.h"
#include "core/geometry/mesh_distance.h"
#include "core/tool/tool.h"

#include <cstdint>
#include <vector>

namespace burin {

/// The motion of a take and its tool. Holds values only, so the thread that computes the deviation needs no project.
struct DeviationMatter {
    TakeInfo info;
    Tool tool;
    std::vector<ToolPose> poses; ///< of each sample, setup frame
};

/// Reads a take of the setup in use. Cost: about 1 µs per sample. Errors: nameUnknown (not a take of the setup),
/// cancelled, those of toolFor and Project.
Result<DeviationMatter> deviationMatter(const Project& project, std::int64_t take, const Progress& progress);

/// Returns, for every ten samples as in TakeTrack, the least distance of the tool from the part, mm, too great by
/// 0.0001 mm at most; negative: flutes, shank or holder are in the part this deep, as gouges are in the colours of
/// deviation. The allowance is not considered. NaN without a part, and where no pose is finite. Thread-safe, uses all
/// cores. Cost: some µs per sample. Errors: cancelled.
Result<std::vector<float>> takeDeviation(const DeviationMatter& matter, const MeshDistance& part, Progress& progress);

} // namespace burin
