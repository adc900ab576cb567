// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"

#include <cstdint>

namespace burin {

/// The face of a part at a place. Model's frame.
struct PartFace {
    enum class Kind : std::uint8_t {
        plane,
        round, ///< a cylinder or a cone: it has an axis
        other
    };
    Kind kind = Kind::other;
    glm::dvec3 place{0.0};     ///< mm, on the face, nearest to what was asked
    glm::dvec3 direction{0.0}; ///< unit: of a plane its outward normal, of a round face its axis, else the normal there
    /// mm: what a hand that points there means as a corner: the vertex, the middle of an edge or the centre of a
    /// circular edge of the face that is nearest; a circle counts by its rim.
    glm::dvec3 corner{0.0};
};

/// The face that a place lies on, or next to. Of a B-rep as it is there, asked in the import program; of a mesh file,
/// which has no faces, the triangle, which is a plane.
/// Errors: as importModel, argumentInvalid (a model without a body, a place that is not finite).
Result<PartFace> partFaceAt(const Model& model, const glm::dvec3& place, const ImportOptions& options,
                            Progress& progress);

} // namespace burin
