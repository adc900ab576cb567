// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"
#include "ui/scene/press_mark.h"

#include <optional>

namespace burin {

/// What a press would do: the tool goes down along its axis to where it is aimed, or as far as the part lets it.
/// @param aimed mm, setup frame: the tip, as deep as requested; @param axis unit, of the tool
/// @param allowance mm left on the part, reckoned along the axis
/// @return nothing where there is nothing to be cut under the tip
std::optional<PressMark> pressPreview(const VolumeSnapshot& workpiece, const Cutter& cutter, const glm::dvec3& aimed,
                                      const glm::dvec3& axis, double allowance);

} // namespace burin
