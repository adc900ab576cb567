// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

namespace burin {

/// Whether diameter, corner, taper and profile fit the type; the flute length is > 0 and not below the corner radius.
/// Errors: argumentInvalid with the key and what is allowed.
Result<void> validateFlutes(const Cutter& cutter);

/// Returns the centre of a profile's arc that begins at `from`. @return (radius, height), mm
glm::dvec2 arcCentre(const ProfileElement& arc, const glm::dvec2& from) noexcept;

/// Profile of a tip with a cone, from below: rounded, straight, and straight again along the axis.
struct TaperForm {
    double ringRadius = 0.0;                 ///< mm, distance of the rounding's centre from the axis
    double arcEndRadius = 0.0, arcEnd = 0.0; ///< mm, where the cone begins
    double coneEnd = 0.0;                    ///< mm, height at which it has the full diameter; may be above the flutes
};
/// @param cutter valid, of type taper, taper ball, drill or chamfer
TaperForm taperForm(const Cutter& cutter) noexcept;

} // namespace burin
