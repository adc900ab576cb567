// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/path.h"

#include "core/geometry/arc.h"

namespace burin {

double lengthOf(const glm::dvec3& from, const PathPoint& to) noexcept {
    if (!to.arc) return glm::distance(from, to.pose.tip);
    const Arc arc{from, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise};
    return lengthOf(arc, turnOf(arc));
}

} // namespace burin
