// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"

#include <span>

namespace burin {

/// Details and notes of core about tools, programs, models and drawings of other systems, as in its sources; see
/// `detailText`.
std::span<const TextId> foreignDetails();

} // namespace burin
