// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

#include <vector>

namespace burin {

/// Whether a point lies in an area (even-odd rule).
bool holds(const Area& area, const glm::dvec3& place) noexcept;

/// Where a straight move crosses the border of an area, as fractions of the move, ascending, both ends excluded.
std::vector<double> crossings(const Area& area, const glm::dvec3& from, const glm::dvec3& to);

} // namespace burin
