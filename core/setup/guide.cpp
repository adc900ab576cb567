// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/guide.h"

#include "core/base/numbers.h"
#include "core/geometry/pose.h"

#include <cmath>

namespace burin {
namespace {

constexpr double steepest = 1.4; // rad, limit of lead and tilt: a tool axis parallel to the surface cannot mill

Error invalid(const char* what, double value, const char* allowed) {
    return {ErrorCode::argumentInvalid, what, formatShortest(value), allowed};
}

bool hasDirection(GuideKind kind) {
    return kind != GuideKind::curve && kind != GuideKind::surface;
}

} // namespace

Result<void> checkGuide(const Guide& guide) {
    if (!isFinite(guide.point)) return invalid("guide point", glm::length(guide.point), "finite coordinates");
    const double length = glm::length(guide.direction);
    if (hasDirection(guide.kind) && !(std::abs(length - 1.0) < 1e-6))
        return invalid("guide direction", length, "a length of 1");
    const bool farApart = guide.kind == GuideKind::levels || guide.kind == GuideKind::stepOver;
    if (farApart && !(std::isfinite(guide.distance) && guide.distance >= 0.01))
        return invalid("guide distance", guide.distance, "0.01 mm or more");
    if (guide.kind == GuideKind::surface && !(std::isfinite(guide.distance) && guide.distance >= 0.0))
        return invalid("guide distance", guide.distance, "0 mm or more");
    if (guide.kind == GuideKind::curve && guide.curve == nullptr) return invalid("guide curve", 0.0, "a curve");
    if (guide.kind == GuideKind::axis)
        for (const double angle : {guide.lead, guide.tilt})
            if (!(std::abs(angle) <= steepest)) return invalid("guide angle", angle, "-1.4 to 1.4 rad");
    return {};
}

Result<void> checkGuides(const GuideSettings& settings) {
    for (const Guide& guide : settings.guides)
        if (guide.on)
            if (Result<void> good = checkGuide(guide); !good) return good;
    return {};
}

} // namespace burin
