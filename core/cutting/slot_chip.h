// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"

namespace burin {

/// Mean chip thickness divided by the feed per tooth, in a slot: the mean of a half sine.
inline constexpr double slotChipRatio = 2.0 / pi;

} // namespace burin
