// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace burin {

/// Bytes that new work can take without swapping: the kernel's MemAvailable (proc(5)); where there is none, all of the
/// machine's memory.
std::size_t availableMemory();

} // namespace burin
