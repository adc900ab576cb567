// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace burin {

/// s since 1970, UTC. For timestamps shown to people; durations are measured with the steady clock.
inline double unixTime() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

} // namespace burin
