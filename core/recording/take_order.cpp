// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/recording/take_order.h"

#include <algorithm>

namespace burin {

std::size_t TakeOrder::placeOf(std::int64_t take) const noexcept {
    if (take == 0) return 0;
    return static_cast<std::size_t>(std::ranges::find(takes_, take) - takes_.begin()) + 1;
}

bool TakeOrder::isBefore(const TakeMoment& one, const TakeMoment& other) const noexcept {
    const std::size_t place = placeOf(one.take), otherPlace = placeOf(other.take);
    return place != otherPlace ? place < otherPlace : one.samples < other.samples;
}

TakeOrder TakeOrder::with(std::int64_t take, std::int64_t before) const {
    std::vector<std::int64_t> takes = takes_;
    std::erase(takes, take);
    takes.insert(std::ranges::find(takes, before), take);
    return TakeOrder(std::move(takes));
}

} // namespace burin
