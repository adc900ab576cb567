// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>

/// Number of allocations of the test program so far, by any thread. A program that links burin::allocation_count has
/// the global operators new and delete replaced in all their forms, so that the address sanitizer does not see memory
/// allocated by its own operators freed by ours.
extern std::atomic<std::size_t> allocationCount;
