// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin {

/// A moment in a setup's recordings: after all takes before this one in the setup's TakeOrder, and after the first
/// `samples` samples of this take.
struct TakeMoment {
    std::int64_t take = 0; ///< 0: before the first one
    std::uint64_t samples = 0;
    friend bool operator==(const TakeMoment&, const TakeMoment&) = default;
};

} // namespace burin
