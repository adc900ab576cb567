// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/program_zero.h"

#include <QString>

#include <array>

namespace burin {

/// The names of the sides of a box along an axis, in the order of BoxSide: "left", "middle", "right", …
/// @param axis 0, 1, 2 for x, y, z
std::array<QString, 3> sideTexts(std::size_t axis);
/// "on the stock: X left, Y front, Z top", "at stated coordinates".
QString zeroText(const ProgramZero& zero);

} // namespace burin
