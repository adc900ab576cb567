// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace burin {

/// What cuts took, counted as they take it.
struct RemovedUnits {
    std::array<std::uint64_t, 256> byProperty{}; ///< run units
    std::uint64_t total = 0;                     ///< run units
    double momentU = 0.0, momentV = 0.0;         ///< run units times line
    double momentAlong = 0.0;                    ///< run units times run unit
    bool outOfMemory = false;                    ///< lines from there on are uncut
};

} // namespace burin
