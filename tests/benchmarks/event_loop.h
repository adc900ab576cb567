// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>

namespace burin::testing {

/// The time since `begin`, s.
double secondsSince(std::chrono::steady_clock::time_point begin);
/// Runs the event loop until `what` is true. Returns false if that did not happen in time.
bool runUntil(const std::function<bool()>& what, std::chrono::steady_clock::duration limit = std::chrono::seconds(60));
void runFor(std::chrono::steady_clock::duration time);

} // namespace burin::testing
