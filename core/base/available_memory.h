// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace burin {

/// Bytes that can be allocated without swapping: the kernel's MemAvailable (proc(5)); if it is not available, all of
/// the machine's memory.
std::size_t availableMemory();

/// The remedy for insufficient memory, besides closing other programs.
enum class MemoryRemedy : std::uint8_t { largerVoxels, fewerTakes };
/// Error::detail of MemoryRemedy::fewerTakes; that of the other is empty.
inline constexpr std::string_view fewerTakes = "fewer takes";

/// Checks whether the memory that some work needs is available, before it is allocated: the kernel overcommits memory,
/// and kills programs later. A fifth of the available memory is left to other programs.
/// @param subject the work @param bytes in addition to what is allocated already
/// Errors: outOfMemory, with both values as place.
Result<void> needMemory(const char* subject, double bytes, MemoryRemedy remedy = MemoryRemedy::largerVoxels);

} // namespace burin
