// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace burin {

/// Bytes that new work can take without swapping: the kernel's MemAvailable (proc(5)); where there is none, all of the
/// machine's memory.
std::size_t availableMemory();

/// What helps where memory does not suffice, besides closing other programs.
enum class MemoryRemedy : std::uint8_t { largerVoxels, fewerTakes };
/// Error::detail of MemoryRemedy::fewerTakes; that of the other is empty.
inline constexpr std::string_view fewerTakes = "fewer takes";

/// Whether work finds the memory that it needs, before it takes it: the kernel hands out what it does not have, and
/// ends programs later. A fifth of what is available is left to others.
/// @param subject  what it is for  @param bytes  on top of what is taken already
/// Errors: outOfMemory, with both values as place.
Result<void> needMemory(const char* subject, double bytes, MemoryRemedy remedy = MemoryRemedy::largerVoxels);

} // namespace burin
