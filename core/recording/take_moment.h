// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>

namespace burin {

/// A moment of a setup's recordings: all takes before this one are over, and so are its first `samples` samples. Takes
/// are in the order of their numbers.
struct TakeMoment {
    std::int64_t take = 0; ///< 0: before the first one
    std::uint64_t samples = 0;
    friend auto operator<=>(const TakeMoment&, const TakeMoment&) = default;
};

} // namespace burin
