// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/path/axis_course.h"

#include <map>

namespace burin {

/// Checks that no move of a tilted tool comes nearer to the part or to a fixture than it was upright, or than it may.
/// The tool is followed as the machine moves it: its rotary axes turn evenly between the points.
/// @param points all of a path; only moves from or to a changed point are judged @param allowances mm, by source
/// @param linksOnly whether only moves without a moment of their own are judged
/// Errors: programLimit, checkFailed (place: where and by how much it is too near), cancelled.
Result<void> guardAxes(const std::vector<TiltedPoint>& points, const PartGuard& part, const PathContext& context,
                       const std::map<std::int64_t, double>& allowances, bool linksOnly, const Progress& progress);

} // namespace burin
