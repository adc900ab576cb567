// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <cstddef>

namespace burin {

/// Bytes that new work can take without swapping: the kernel's MemAvailable (proc(5)); where there is none, all of the
/// machine's memory.
std::size_t availableMemory();

/// Whether work finds the memory that it needs, before it takes it: the kernel hands out what it does not have, and
/// ends programs later. A fifth of what is available is left to others.
/// @param subject  what it is for  @param bytes  on top of what is taken already
/// Errors: outOfMemory, with both figures.
Result<void> needMemory(const char* subject, double bytes);

} // namespace burin
