// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

#include <vector>

namespace burin {

/// Whether a place lies in an area (even-odd rule).
bool holds(const Area& area, const glm::dvec3& place) noexcept;

/// Where a straight move goes through the border of an area, as shares of the move, rising, both ends left out.
std::vector<double> crossings(const Area& area, const glm::dvec3& from, const glm::dvec3& to);

} // namespace burin
