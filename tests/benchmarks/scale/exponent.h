// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace burin::benchmarks {

/// How a cost grows with a size: as the size to this power, between two sizes.
inline double exponentBetween(double size, double cost, double largerSize, double costOfLarger) noexcept {
    return std::log(costOfLarger / cost) / std::log(largerSize / size);
}

} // namespace burin::benchmarks
