// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/block.h"
#include "core/nc/control.h"
#include "core/nc/parameters.h"

#include <string_view>

namespace burin {

/// Splits one line into words. Comments are skipped, also (MSG, …), as they move nothing. Letters may be upper or lower
/// case. Blanks may occur between words and between a letter and its number, but not inside a number. A block after /
/// is read as if block delete were off. Assignments of the line to parameters take effect after it.
/// @return true, or false with `fault` filled
bool readLine(std::string_view line, const Control& control, Parameters& parameters, Block& block, BlockFault& fault);

} // namespace burin
