// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/program_zero.h"

#include <QString>

#include <array>

namespace burin {

/// How a side of a box is called along an axis, in the order of BoxSide: "left", "middle", "right" and so on.
/// @param axis 0, 1, 2 for x, y, z
std::array<QString, 3> sideTexts(std::size_t axis);
/// "on the stock: X left, Y front, Z top", "at stated coordinates".
QString zeroText(const ProgramZero& zero);

} // namespace burin
