// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit.h"

#include <optional>
#include <string_view>

namespace burin {

/// Whether a parameter may be drawn in plan: points, or the position of a mirror plane.
bool isDrawn(const EditParameters& parameters, std::string_view key);

/// Sets a parameter from what was drawn. A mirror plane becomes parallel to the line from the first point to the last,
/// snapped to whichever of X and Y is nearer, and passes through the middle of that line; it is unchanged if the two
/// points are less than a millimetre apart.
void setDrawn(EditParameters& parameters, std::string_view key, const std::vector<glm::dvec3>& places);

/// A parameter of one of some edits.
struct DrawnField {
    std::size_t edit = 0; ///< index among the edits
    std::string key;
    friend bool operator==(const DrawnField&, const DrawnField&) = default;
};
/// The drawable parameter of the last enabled edit that has one.
std::optional<DrawnField> lastDrawn(const std::vector<Edit>& edits);

} // namespace burin
