// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"

#include <cstdint>

namespace burin {

/// The face of a part at a point. Frame of the model.
struct PartFace {
    enum class Kind : std::uint8_t {
        plane,
        round, ///< a cylinder or a cone: a face with an axis
        other
    };
    Kind kind = Kind::other;
    glm::dvec3 place{0.0};     ///< mm, the point on the face that is nearest to the requested one
    glm::dvec3 direction{0.0}; ///< unit: the outward normal of a plane, the axis of a round face, else the normal at
                               ///< `place`
    /// mm: the corner that a user who points there most likely means: the nearest of the face's vertices, midpoints of
    /// its edges and centres of its circular edges. For a circle the distance to its rim counts.
    glm::dvec3 corner{0.0};
};

/// Returns the face that contains a point or is nearest to it. The face of a B-rep is found exactly, in the import
/// program; a mesh file has no faces, so the triangle is returned as a plane.
/// Errors: as importModel, argumentInvalid (a model without a body, a point that is not finite).
Result<PartFace> partFaceAt(const Model& model, const glm::dvec3& place, const ImportOptions& options,
                            Progress& progress);

} // namespace burin
