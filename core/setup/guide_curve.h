// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace burin {

/// A space curve as a polyline with the curve's own tangents: what an edge of the part becomes. Setup frame.
/// Immutable; any thread.
class GuideCurve {
public:
    /// @param points mm; neighbours differ; a closed curve repeats its first point at the end.
    /// @param tangents one a point, not zero. Errors: argumentInvalid.
    static Result<GuideCurve> make(std::vector<glm::dvec3> points, std::vector<glm::dvec3> tangents);

    /// mm, setup frame.
    std::span<const glm::dvec3> points() const noexcept { return points_; }
    /// Unit, one a point. A curve made of both again is the same to the bit.
    std::span<const glm::dvec3> tangents() const noexcept { return tangents_; }
    bool closed() const noexcept { return closed_; }
    /// Unit, turned evenly between the ends of a segment. @param share 0 … 1 of the segment
    glm::dvec3 tangentAt(std::size_t segment, double share) const noexcept;

private:
    std::vector<glm::dvec3> points_, tangents_;
    bool closed_ = false;
};

} // namespace burin
