// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"
#include "core/path/path.h"

#include <vector>

namespace burin {

/// Returns, for each point, whether the move that ends there lies in a part of the path, with both of its ends. Plunges
/// and other moves made by links count as the next cut that follows without a rapid, otherwise as the cut before.
/// For rapids the value has no meaning.
std::vector<bool> movesWithin(const std::vector<PathPoint>& points, const SourceInterval& interval);

} // namespace burin
