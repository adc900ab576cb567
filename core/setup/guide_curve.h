// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace burin {

/// A space curve as a polyline with the curve's own tangents; represents an edge of the part. Setup frame. Immutable
/// and thread-safe.
class GuideCurve {
public:
    /// @param points mm; neighbouring points differ; a closed curve repeats its first point at the end.
    /// @param tangents one per point, not zero. Errors: argumentInvalid.
    static Result<GuideCurve> make(std::vector<glm::dvec3> points, std::vector<glm::dvec3> tangents);

    /// mm, setup frame.
    std::span<const glm::dvec3> points() const noexcept { return points_; }
    /// Unit vectors, one per point. A curve made again from these points and tangents is bitwise identical.
    std::span<const glm::dvec3> tangents() const noexcept { return tangents_; }
    bool closed() const noexcept { return closed_; }
    /// Returns the unit tangent, interpolated linearly between the ends of a segment and normalised. @param share 0 … 1
    /// of the segment
    glm::dvec3 tangentAt(std::size_t segment, double share) const noexcept;

private:
    std::vector<glm::dvec3> points_, tangents_;
    bool closed_ = false;
};

} // namespace burin
