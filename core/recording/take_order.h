// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/take_moment.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace burin {

/// The order in which takes of a setup are replayed and listed, by their ids.
class TakeOrder {
public:
    TakeOrder() = default;
    /// @param takes ids without duplicates
    explicit TakeOrder(std::vector<std::int64_t> takes) : takes_(std::move(takes)) {}

    const std::vector<std::int64_t>& takes() const noexcept { return takes_; }
    /// Returns the position of a take, from 1. Id 0 (no take) comes before all takes, an unknown take after all.
    std::size_t placeOf(std::int64_t take) const noexcept;
    bool isBefore(const TakeMoment& one, const TakeMoment& other) const noexcept;
    /// Returns the order with one of its takes moved directly before another one; `before` 0: to the end.
    TakeOrder with(std::int64_t take, std::int64_t before) const;

    friend bool operator==(const TakeOrder&, const TakeOrder&) = default;

private:
    std::vector<std::int64_t> takes_;
};

} // namespace burin
