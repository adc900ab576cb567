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

/// Returns the path point that each motion of a program posted from the path stems from, by index of the motion; empty
/// if the path has no such point. Only the text is used: a motion belongs to the next point of the path that it ends
/// in, within `tolerance`; the pieces of a split move belong to that move. Cost: linear.
/// @param kinematics of the machine with the program's zero @param tolerance mm, at least the rounding error of a
/// position
std::vector<std::optional<std::size_t>> pointsBehind(const ParsedProgram& program, const Path& path,
                                                     const Kinematics& kinematics, double tolerance = 0.002);
/// Returns the moment of the hand that each motion stems from, found by its point. No moment (take 0) if an edit made
/// the move, or the path has no such point.
std::vector<Moment> momentsOf(const ParsedProgram& program, const Path& path, const Kinematics& kinematics,
                              double tolerance = 0.002);

} // namespace burin
