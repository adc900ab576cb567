// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/duration_histogram.h"

#include <algorithm>
#include <cmath>

namespace burin {

double DurationHistogram::quantileMicroseconds(double share) const noexcept {
    if (count_ == 0) return 0.0;
    const auto rank = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < size; ++i) {
        seen += buckets_[i];
        if (seen < rank || seen == 0) continue;
        // The inverse of `bucket`: from value 64 on, each block of 32 buckets is twice as coarse as the previous one.
        const std::size_t shift = i < (std::size_t{2} << subBits) ? 0 : (i >> subBits) - 1;
        const double upper = std::ldexp(static_cast<double>(i - (shift << subBits) + 1), static_cast<int>(shift)) - 1.0;
        return std::min(upper, static_cast<double>(largest_)) * 1e-3;
    }
    return largestMicroseconds();
}

} // namespace burin
