// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"

#include <span>
#include <vector>

namespace burin {

// Sets of samples of a take as rising ranges that do not touch.

/// The union of the ranges, which may be in any order and overlap. Empty ones are dropped.
std::vector<SampleRange> joined(std::vector<SampleRange> ranges);
/// @param ranges  rising, not touching
std::vector<SampleRange> without(std::span<const SampleRange> ranges, const SampleRange& gone);

} // namespace burin
