// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/brick_lines.h"

#include <cstdint>
#include <span>

namespace burin {

/// Adds the amounts of every property on one line.
void addLine(std::span<const Segment> line, RunAmounts& amounts) noexcept;

/// Adds the amounts of every property on the 64 lines of a brick.
/// @param offsets where each line begins in `segments`, and the end of the last
void addLines(std::span<const Segment> segments, std::span<const std::uint32_t, linesPerBrick + 1> offsets,
              RunAmounts& amounts) noexcept;

} // namespace burin
