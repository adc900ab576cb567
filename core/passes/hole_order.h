// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// A short order of visiting points in plan, as indices: begins with the first one, goes on to the nearest neighbour,
/// and reverses parts of the sequence as long as that makes it shorter. Not always the shortest of all.
std::vector<std::size_t> shortestOrder(std::span<const glm::dvec2> places);

} // namespace burin
