// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"
#include "core/recording/sample.h"

#include <QString>

#include <vector>

namespace burin {

/// The time of a recorded moment, from the beginning of its take: "12.34 s". For a take with missed ticks it is
/// approximate, "≈ 12.3 s": the take lasted longer than the sum of its ticks, and only the recording knows which ones
/// were missed. "sample 12340" if the take is not among `takes` or is damaged.
QString handTimeText(const std::vector<TakeInfo>& takes, const Moment& moment);
/// The same as `handTimeText`, with the take's name.
QString momentText(const std::vector<TakeInfo>& takes, const Moment& moment);
/// The interval between two recorded moments.
QString intervalText(const std::vector<TakeInfo>& takes, const SourceInterval& interval);

} // namespace burin
