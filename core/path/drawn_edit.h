// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit.h"

#include <optional>
#include <string_view>

namespace burin {

/// Whether a parameter may be drawn in plan: places, and where the plane of a mirror stands.
bool isDrawn(const EditParameters& parameters, std::string_view key);

/// Gives a parameter that may be drawn what was drawn. A mirror's plane stands along the way from the first place to
/// the last, in the direction of X or Y that it is nearer to, through their middle; it stays where they are less than a
/// millimetre apart.
void setDrawn(EditParameters& parameters, std::string_view key, const std::vector<glm::dvec3>& places);

/// A parameter of one of some edits.
struct DrawnField {
    std::size_t edit = 0; ///< place among the edits
    std::string key;
    friend bool operator==(const DrawnField&, const DrawnField&) = default;
};
/// The one of the last edit that is on and has one that may be drawn.
std::optional<DrawnField> lastDrawn(const std::vector<Edit>& edits);

} // namespace burin
