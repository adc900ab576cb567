// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/take_moves.h"

#include <algorithm>
#include <string>

namespace burin {

Result<TakeOrder> orderWithTakeAt(const Project& project, std::int64_t take, std::size_t place) {
    const Result<TakeOutline> outline = project.takeOutline(take);
    if (!outline) return outline.error();
    const SetupId setup = outline->info.setup;
    Result<std::vector<TakeInfo>> others = project.takes(setup);
    if (!others) return std::move(others).error();
    if (place >= others->size())
        return Error{ErrorCode::argumentInvalid, "position", std::to_string(place + 1),
                     "1 … " + std::to_string(others->size())};
    std::erase_if(*others, [take](const TakeInfo& info) { return info.id == take; });
    const Result<TakeOrder> order = project.takeOrder(setup);
    if (!order) return order.error();
    return order->with(take, place < others->size() ? (*others)[place].id : 0);
}

Result<TakeOrder> orderWithTakeBefore(const Project& project, std::int64_t take, std::int64_t before) {
    const Result<TakeOutline> outline = project.takeOutline(take), other = project.takeOutline(before);
    if (!outline) return outline.error();
    if (!other) return other.error();
    if (take == before || outline->info.setup != other->info.setup)
        return Error{ErrorCode::argumentInvalid, "take", std::to_string(before),
                     "another take of the setup of take " + std::to_string(take)};
    const Result<TakeOrder> order = project.takeOrder(outline->info.setup);
    if (!order) return order.error();
    return order->with(take, before);
}

} // namespace burin
