// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/block.h"
#include "core/nc/control.h"
#include "core/nc/parameters.h"

#include <string_view>

namespace burin {

/// Takes one line apart. Comments are left out ((MSG, …) too: they ask for nothing that moves), letters may be of
/// either case, blanks may stand between words and between a letter and its number, but not inside a number. A block
/// behind / is read as if block delete were off. Parameters take what the line assigns to them, behind it.
/// @return true, or false and `fault` filled
bool readLine(std::string_view line, const Control& control, Parameters& parameters, Block& block, BlockFault& fault);

} // namespace burin
