// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

namespace burin {

/// Precision with which lowestClear finds a height, mm.
inline constexpr double touchPrecision = 1e-5;

/// Moves something straight down until it touches: returns the lowest height above which all is clear, within
/// `touchPrecision` above it. Empty if it reaches the floor without touching. Each step goes down by the spare
/// clearance, because the clearance changes by no more than the height; beside a wall the steps would become ever
/// shorter, hence the shortest step of 0.02 mm: an obstacle that is thinner than that, and was no nearer than that
/// before, may be passed.
/// @param spareAt  spare clearance at a height, mm  @param high  height from which on it is clear, mm
template <class Spare>
std::optional<double> lowestClear(Spare&& spareAt, double high, double floor) {
    constexpr double shortestStep = 0.02;          // mm
    constexpr double inner = 0.4 * touchPrecision; // mm beyond the wanted height, so that both ends approach it
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
    // Where the line between both ends has no spare clearance; every other time in the middle, so that the search can't
    // creep.
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
