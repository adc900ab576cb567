// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

namespace burin {

// Each function returns the order of the takes of a take's setup with that take moved. Nothing is stored.

/// @param place index among the takes that are not removed, from 0; the last one is the end
/// Errors: nameUnknown (the take), argumentInvalid (no such index).
Result<TakeOrder> orderWithTakeAt(const Project& project, std::int64_t take, std::size_t place);
/// Directly before another take. Errors: nameUnknown (either), argumentInvalid (both are the same take, or of different
/// setups).
Result<TakeOrder> orderWithTakeBefore(const Project& project, std::int64_t take, std::int64_t before);

} // namespace burin
