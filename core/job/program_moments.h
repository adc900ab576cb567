// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/kinematics.h"
#include "core/nc/parsed_program.h"
#include "core/path/edit_values.h"
#include "core/path/path.h"

#include <optional>
#include <vector>

namespace burin {

/// The point of a path behind each motion of a program that was posted from it, by place in its motions; nothing: the
/// path does not go there. The text alone is looked at: a motion belongs to the next point of the path that it ends in,
/// within `tolerance`; pieces of a move that was split belong to that move. Cost: linear.
/// @param kinematics of the machine with the program's zero @param tolerance mm, at least what rounding moves a place
/// by
std::vector<std::optional<std::size_t>> pointsBehind(const ParsedProgram& program, const Path& path,
                                                     const Kinematics& kinematics, double tolerance = 0.002);
/// The moment of the hand behind each motion, by its point. No moment (take 0): an edit made the move, or the path does
/// not go there.
std::vector<Moment> momentsOf(const ParsedProgram& program, const Path& path, const Kinematics& kinematics,
                              double tolerance = 0.002);

} // namespace burin
