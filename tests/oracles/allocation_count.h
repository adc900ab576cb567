// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>

/// Every allocation of the test program so far, by any thread. What links burin::allocation_count has the global
/// operators replaced, all of their forms, so that the address sanitizer finds no memory of its own freed by ours.
extern std::atomic<std::size_t> allocationCount;
