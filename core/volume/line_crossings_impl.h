// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/line_crossings.h"

#include <algorithm>
#include <utility>

namespace burin {

inline LineRange linesWithin(std::int64_t lowU, std::int64_t lowV, std::int64_t highU, std::int64_t highV,
                             const LineRange& range) noexcept {
    constexpr std::int64_t below = (std::int64_t{1} << latticeBits) - 1;
    const auto clamped = [](std::int64_t line, std::int32_t low, std::int32_t high) {
        return static_cast<std::int32_t>(std::clamp<std::int64_t>(line, low, high));
    };
    return {clamped((lowU + below) >> latticeBits, range.lowU, range.highU),
            clamped((lowV >> latticeBits) + 1, range.lowV, range.highV),
            clamped((highU + below) >> latticeBits, range.lowU, range.highU),
            clamped((highV >> latticeBits) + 1, range.lowV, range.highV)};
}

inline TriangleCover::TriangleCover(const std::array<LatticeVertex, 3>& points, const LineRange& range) noexcept
    : points_(points) {
    const auto& [a, b, c] = points;
    lines_ = linesWithin(std::min({a.u, b.u, c.u}), std::min({a.v, b.v, c.v}), std::max({a.u, b.u, c.u}),
                         std::max({a.v, b.v, c.v}), range);
}

/// Edge functions of 32 bits, and no more than a few lines beside the triangle to look at in vain.
inline bool TriangleCover::isSmall() const noexcept {
    constexpr std::int64_t reach = std::int64_t{1} << 22; // 64 voxels
    constexpr std::int32_t wide = 12;                     // lines
    const auto& [a, b, c] = points_;
    const auto near = [](std::int64_t x, std::int64_t y) { return x - y < reach && y - x < reach; };
    return lines_.highU - lines_.lowU <= wide && near(a.u, b.u) && near(a.u, c.u) && near(a.v, b.v) && near(a.v, c.v);
}

/// At the first line of the range. Whole numbers of lattice steps squared, over one line's step: lines lie that far
/// apart, so what is left over decides nothing.
inline TriangleCover::Edge TriangleCover::edge(const LatticeVertex& from, const LatticeVertex& to) const noexcept {
    const std::int64_t du = to.u - from.u, dv = to.v - from.v;
    const std::int64_t u = (std::int64_t{lines_.lowU} << latticeBits) - from.u;
    const std::int64_t v = (std::int64_t{lines_.lowV} << latticeBits) - from.v;
    const bool holdsItsLines = dv < 0 || (dv == 0 && du < 0);
    return {static_cast<std::int32_t>((du * v - dv * u - (holdsItsLines ? 0 : 1)) >> latticeBits),
            static_cast<std::int32_t>(-dv), static_cast<std::int32_t>(du)};
}

template <class Visit>
void TriangleCover::forEachLine(double lowest, double highest, Visit&& visit) const {
    if (lines_.empty()) return;
    const auto& [a, b, c] = points_;
    // The plane's height over the lattice, relative to the first corner to keep digits.
    const std::int64_t bu = b.u - a.u, bv = b.v - a.v, cu = c.u - a.u, cv = c.v - a.v;
    const double bz = b.along - a.along, cz = c.along - a.along;
    const bool small = isSmall();
    const double area =
        small ? static_cast<double>(bu * cv - bv * cu)
              : static_cast<double>(bu) * static_cast<double>(cv) - static_cast<double>(bv) * static_cast<double>(cu);
    if (small && area == 0.0) return;
    const double slopeU = (bz * static_cast<double>(cv) - cz * static_cast<double>(bv)) / area;
    const double slopeV = (cz * static_cast<double>(bu) - bz * static_cast<double>(cu)) / area;
    // A triangle seen nearly edge-on has slopes without meaning; its crossing lies between its corners all the same.
    const double low = std::clamp(std::min({a.along, b.along, c.along}), lowest, highest);
    const double high = std::clamp(std::max({a.along, b.along, c.along}), lowest, highest);
    constexpr double step = static_cast<double>(std::int64_t{1} << latticeBits);
    const auto clamped = [&](double along) {
        along = along > low ? along : low; // what is not a number becomes the lower one
        return along < high ? along : high;
    };
    const double du = static_cast<double>((std::int64_t{lines_.lowU} << latticeBits) - a.u);
    const double dv = static_cast<double>((std::int64_t{lines_.lowV} << latticeBits) - a.v);
    const double alongFirst = a.along + slopeU * du + slopeV * dv;
    if (!small) {
        for (std::int32_t v = lines_.lowV; v < lines_.highV; ++v) {
            const Row covered = row(v);
            const double alongRow = alongFirst + slopeV * step * (v - lines_.lowV);
            for (std::int32_t u = covered.first; u < covered.end; ++u)
                visit(u, v, clamped(alongRow + slopeU * step * (u - lines_.lowU)), covered.leaves);
        }
        return;
    }
    // Seen against the runs a counter-clockwise triangle faces along them: the line leaves.
    const bool leaves = area > 0.0;
    Edge first = leaves ? edge(a, b) : edge(b, a), second = leaves ? edge(b, c) : edge(c, b),
         third = leaves ? edge(c, a) : edge(a, c);
    for (std::int32_t v = lines_.lowV; v < lines_.highV; ++v) {
        std::int32_t one = first.value, two = second.value, three = third.value;
        const double alongRow = alongFirst + slopeV * step * (v - lines_.lowV);
        for (std::int32_t u = lines_.lowU; u < lines_.highU; ++u) {
            if ((one | two | three) >= 0) visit(u, v, clamped(alongRow + slopeU * step * (u - lines_.lowU)), leaves);
            one += first.alongU;
            two += second.alongU;
            three += third.alongU;
        }
        first.value += first.alongV;
        second.value += second.alongV;
        third.value += third.alongV;
    }
}

} // namespace burin
