// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/parsed_program.h"
#include "core/path/edit_values.h"
#include "core/path/path.h"

#include <vector>

namespace burin {

/// The moment of the hand behind each motion of a program that was posted from a path, by place in its motions. No
/// moment (take 0): an edit made the move, or the path does not go there. The text alone is looked at: a motion belongs
/// to the next point of the path that it ends in, within `tolerance`; pieces of a move that was split belong to that
/// move. Cost: linear.
/// @param zero program zero in the setup frame, mm @param tolerance mm, at least what rounding moves a place by
std::vector<Moment> momentsOf(const ParsedProgram& program, const Path& path, const glm::dvec3& zero,
                              double tolerance = 0.002);

} // namespace burin
