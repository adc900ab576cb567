// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/hole_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace burin {

std::vector<std::size_t> shortestOrder(std::span<const glm::dvec2> places) {
    constexpr int mostTurns = 20; // rounds of improving the order
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto way = [&](std::size_t a, std::size_t b) { return glm::distance(places[order[a]], places[order[b]]); };
    for (std::size_t i = 1; i < order.size(); ++i) {
        std::size_t next = i;
        for (std::size_t k = i + 1; k < order.size(); ++k)
            if (way(i - 1, k) < way(i - 1, next)) next = k;
        std::swap(order[i], order[next]);
    }
    bool shorter = true;
    for (int round = 0; shorter && round < mostTurns; ++round) {
        shorter = false;
        for (std::size_t i = 1; i + 1 < order.size(); ++i)
            for (std::size_t k = i + 1; k < order.size(); ++k) {
                const bool last = k + 1 == order.size();
                const double now = way(i - 1, i) + (last ? 0.0 : way(k, k + 1));
                const double then = way(i - 1, k) + (last ? 0.0 : way(i, k + 1));
                if (!(then < now - 1e-9)) continue;
                std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i),
                             order.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                shorter = true;
            }
    }
    return order;
}

} // namespace burin
