// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/haptics/haptic_settings.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"

#include <memory>
#include <vector>

namespace burin::benchmarks {

/// A part in its stock, a tool with its field, and the motion of a hand that mills. Voxels of 1 mm, so that lengths are
/// voxels.
struct TickScene {
    RunVolume workpiece;
    std::unique_ptr<const ClearanceField> field;
    Tool tool;
    HapticSettings settings;
    std::vector<glm::dvec3> hand; ///< mm, the commanded tip at each tick
};

/// The paper's block of 40 × 32 × 40 voxels (4.3.5, figure 13 b) on a plate, and a ball end. Errors end the program
/// with an exception.
/// @param radius  voxels
TickScene paperBlock(double radius, std::size_t ticks);

/// A bumpy part of 100,000 triangles in a block that fills a cube of `side` voxels. The hand moves about the part's
/// top, so that it cuts and is pushed back alternately.
TickScene buriedPart(std::int32_t side, double radius, std::size_t ticks);

} // namespace burin::benchmarks
