// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin {

/// By how much interpolated values in a fine brick of a tool's field (BrickField) may exceed a clearance that has a
/// kink in each line of samples, wherever in its cell the kink lies. Assumes that the clearance equals the samples at
/// their points and changes no faster than the tip moves. In units of the samples.
/// @param samples  of one brick, x running fastest  @param cell  edge of a cell, units
/// @param floor  lines that lie below it do not count
float kinkExcess(const std::int16_t* samples, float cell, float floor) noexcept;

} // namespace burin
