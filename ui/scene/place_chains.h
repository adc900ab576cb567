// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// Each a chain of places, mm, setup frame; fewer than two draw nothing.
using PlaceChains = std::vector<std::vector<glm::dvec3>>;

} // namespace burin
