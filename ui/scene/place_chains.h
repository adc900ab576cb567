// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// Polylines, mm, setup frame; one of a single point is drawn as a dot.
using PlaceChains = std::vector<std::vector<glm::dvec3>>;

} // namespace burin
