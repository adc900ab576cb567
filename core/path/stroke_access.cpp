// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/stroke_access.h"

#include "core/path/link_room.h"

#include <algorithm>

namespace burin {
namespace {

bool isFreeAbove(const PartGuard& guard, const glm::dvec3& tip, double height) {
    constexpr double sampling = 0.25; // mm
    // A path that was not kept out of the part may start inside; its own depth does not prevent leaving it.
    const double required = std::min(0.0, guard.clearance(tip, 1.0).clearance) - touchTolerance;
    return guard.isClear(tip, {tip.x, tip.y, height}, required, sampling);
}

} // namespace

StrokeAccess accessOf(const PathStroke& stroke, const PartGuard& guard, double height) {
    const std::size_t count = stroke.points.size();
    StrokeAccess access;
    while (access.entry < count && !isFreeAbove(guard, stroke.points[access.entry].pose.tip, height)) ++access.entry;
    if (access.entry == count) return access;
    access.found = true;
    access.exit = count - 1;
    while (access.exit > access.entry && !isFreeAbove(guard, stroke.points[access.exit].pose.tip, height))
        --access.exit;
    return access;
}

} // namespace burin
