// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"
#include "core/recording/sample.h"

#include <QString>

#include <vector>

namespace burin {

/// When a moment of the hand was, from the beginning of its take: "12.34 s". A take that missed ticks is longer than
/// its ticks, and only its recording knows which: "≈ 12.3 s" then. "sample 12340" of a take that is not among `takes`
/// or is damaged.
QString handTimeText(const std::vector<TakeInfo>& takes, const Moment& moment);
/// The same with the take's name.
QString momentText(const std::vector<TakeInfo>& takes, const Moment& moment);
/// What the hand did between two moments.
QString stretchText(const std::vector<TakeInfo>& takes, const SourceStretch& stretch);

} // namespace burin
