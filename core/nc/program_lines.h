// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/parsed_program.h"

#include <span>

namespace burin {

// A program's motions by the lines of its text, in which they stand in order. Lines count from 1. Cost: log n.

/// What one line makes the machine do; none for a line without a move.
std::span<const NcMotion> motionsOf(std::span<const NcMotion> motions, std::uint32_t line);

/// The motion that has brought the machine to where it stands when a line is done; null: none yet.
const NcMotion* lastMotion(std::span<const NcMotion> motions, std::uint32_t line);

} // namespace burin
