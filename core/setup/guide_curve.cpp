// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/guide_curve.h"

#include "core/geometry/pose.h"

#include <cmath>

namespace burin {

namespace {
constexpr double unitRounding = 1e-15; // a length this close to 1 is already normalised: it is not divided again
}

Result<GuideCurve> GuideCurve::make(std::vector<glm::dvec3> points, std::vector<glm::dvec3> tangents) {
    const auto invalid = [](std::size_t point, const char* allowed) {
        return Error{ErrorCode::argumentInvalid, "curve", "point " + std::to_string(point + 1), allowed};
    };
    if (points.size() < 2 || tangents.size() != points.size())
        return invalid(points.size(), "two points or more, each with a tangent");
    for (std::size_t i = 0; i < points.size(); ++i) {
        // Vectors whose squares overflow or underflow have no usable length, and so no direction.
        const double chord = i > 0 ? glm::length(points[i] - points[i - 1]) : 1.0, length = glm::length(tangents[i]);
        if (!isFinite(points[i]) || !isFinite(tangents[i]) || !std::isfinite(chord) || !std::isfinite(length))
            return invalid(i, "finite coordinates");
        if (!(chord > 0.0)) return invalid(i, "a point other than the one before");
        if (!(length > 1e-9)) return invalid(i, "a tangent");
        if (std::abs(length - 1.0) > unitRounding) tangents[i] /= length;
    }
    GuideCurve curve;
    curve.closed_ = points.size() > 2 && glm::length(points.front() - points.back()) < 1e-6;
    curve.points_ = std::move(points);
    curve.tangents_ = std::move(tangents);
    return curve;
}

glm::dvec3 GuideCurve::tangentAt(std::size_t segment, double share) const noexcept {
    const glm::dvec3 turned = glm::mix(tangents_[segment], tangents_[segment + 1], share);
    const double length = glm::length(turned);
    if (length > 1e-6) return turned / length;
    return glm::normalize(points_[segment + 1] - points_[segment]);
}

} // namespace burin
