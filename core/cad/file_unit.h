// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"

#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Returns the short name of a unit of the given length in millimetres ("mm", "inch", …); `otherwise` for an unusual
/// one.
std::string unitName(double millimetres, const std::string& otherwise);
/// Millimetres per unit, from a name ("mm", "in", "inch", …) or from their number, 1e-6 … 1e6; std::nullopt for any
/// other text.
std::optional<double> unitFromText(std::string_view text);

bool isSameUnit(double one, double other) noexcept; ///< mm; to 1e-9
/// Whether the model's file states a unit; BREP and most meshes don't.
bool statesUnit(const Model& model) noexcept;
/// Whether another unit was chosen than the one that the file states, or that is assumed for its format.
bool unitReplaced(const Model& model) noexcept;
/// The size that the model would have if it were read in another unit, mm. @param scale mm per unit
glm::dvec3 sizeInUnit(const Model& model, double scale);
/// Options that read a file of the model again in the unit that was used for the previous one.
ImportOptions importOptionsAsBefore(const Model& before);
/// The `brepPlacement` that places a model as it was placed in another unit.
Placement placementAsBefore(const Model& model, const Model& before);

} // namespace burin
