// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"

#include <span>
#include <vector>

namespace burin {

// Sets of samples of a take as ranges that rise and stand apart from each other.

/// What is in one of them at least; they may be in any order and overlap. Empty ones are left out.
std::vector<SampleRange> joined(std::vector<SampleRange> ranges);
/// @param ranges rising, apart
std::vector<SampleRange> without(std::span<const SampleRange> ranges, const SampleRange& gone);

} // namespace burin
