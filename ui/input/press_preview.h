// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"
#include "ui/scene/press_mark.h"

#include <optional>

namespace burin {

/// The result of a press: the tool moves down along its axis to the target, or as far as the part allows.
/// @param aimed mm, setup frame: tip position at the requested depth; @param axis unit, of the tool
/// @param allowance mm left on the part, measured along the axis
/// @return empty if there is nothing to cut under the tip
std::optional<PressMark> pressPreview(const VolumeSnapshot& workpiece, const Cutter& cutter, const glm::dvec3& aimed,
                                      const glm::dvec3& axis, double allowance);

} // namespace burin
