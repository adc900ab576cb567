// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/parsed_program.h"

#include <span>

namespace burin {

// Access to a program's motions by the lines of its text; the motions are in the order of the lines. Lines count from
// 1. Cost: log n.

/// The motions that a line makes; empty for a line without a move.
std::span<const NcMotion> motionsOf(std::span<const NcMotion> motions, std::uint32_t line);

/// The last motion up to and including a line, which determines where the machine is after it; null: none yet.
const NcMotion* lastMotion(std::span<const NcMotion> motions, std::uint32_t line);

} // namespace burin
