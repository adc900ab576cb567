// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin {

/// By how much values between the samples of a fine brick of a tool's field (BrickField) may exceed a clearance that
/// has a kink in each line of samples, wherever in its cell that lies: where the clearance is what its samples say, and
/// changes no faster than the tip moves. In units of the samples.
/// @param samples  of one brick, x running fastest  @param cell  edge of a cell, units
/// @param floor  lines do not count where they lie below it
float kinkExcess(const std::int16_t* samples, float cell, float floor) noexcept;

} // namespace burin
