// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

namespace burin {

// The order of the takes of a take's own setup, with that take at another place. Nothing is stored yet.

/// @param place among the takes that are there, from 0; the last one is the end
/// Errors: nameUnknown (the take), argumentInvalid (there is no such place).
Result<TakeOrder> orderWithTakeAt(const Project& project, std::int64_t take, std::size_t place);
/// Just before another take. Errors: nameUnknown (either), argumentInvalid (both are one, or of different setups).
Result<TakeOrder> orderWithTakeBefore(const Project& project, std::int64_t take, std::int64_t before);

} // namespace burin
