// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace burin::benchmarks {

/// The exponent of a cost's growth with a size, between two sizes: the cost grows as the size to this power.
inline double exponentBetween(double size, double cost, double largerSize, double costOfLarger) noexcept {
    return std::log(costOfLarger / cost) / std::log(largerSize / size);
}

} // namespace burin::benchmarks
