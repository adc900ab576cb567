// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

namespace burin {

/// Precision with which lowestClear finds a height, mm.
inline constexpr double touchPrecision = 1e-5;

/// Leads something straight down until it touches: the lowest height above which all is clear, within `touchPrecision`
/// above it. Nothing where it reaches the floor without touching. It can go down by as much as it has to spare, as a
/// clearance changes by no more than the way; beside a wall that leads to ever shorter steps, hence a shortest one of
/// 0.02 mm: what is thinner than that, and no nearer than that before, may be passed.
/// @param spareAt mm that it is farther than it has to be at a height, mm @param high from where on it is clear
template <class Spare>
std::optional<double> lowestClear(Spare&& spareAt, double high, double floor) {
    constexpr double shortestStep = 0.02;          // mm
    constexpr double inner = 0.4 * touchPrecision; // mm beyond the place looked for, so that both ends come near to it
    double spare = spareAt(high), low = high, lacking = spare;
    while (lacking > 0.0) {
        if (high <= floor) return {};
        low = std::max(floor, high - std::max(spare, shortestStep));
        lacking = spareAt(low);
        if (lacking > 0.0) {
            high = low;
            spare = lacking;
        }
    }
    // Where the line between both would have none to spare; in the middle every other time, so that it can't creep.
    for (bool halve = false; high - low > touchPrecision; halve = !halve) {
        const double share = halve || !(spare > lacking) ? 0.5 : spare / (spare - lacking);
        const double middle =
            std::clamp(high - share * (high - low) + inner, low + inner, std::max(low + inner, high - inner));
        const double now = spareAt(middle);
        (now > 0.0 ? high : low) = middle;
        (now > 0.0 ? spare : lacking) = now;
    }
    return high;
}

} // namespace burin
