// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/voxelisation/line_crossings.h"

#include <algorithm>
#include <bit>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace burin {

inline TriangleCover::TriangleCover(const LatticeVertex& a, const LatticeVertex& b, const LatticeVertex& c,
                                    const LineRectangle& range) noexcept
    : a_(a), b_(b), c_(c) {
    constexpr std::int64_t below = (std::int64_t{1} << latticeBits) - 1;
    const auto clamped = [](std::int64_t line, std::int32_t low, std::int32_t high) {
        return static_cast<std::int32_t>(std::clamp<std::int64_t>(line, low, high));
    };
    lines_ = {clamped((std::min({a.u, b.u, c.u}) + below) >> latticeBits, range.lowU, range.highU),
              clamped((std::min({a.v, b.v, c.v}) >> latticeBits) + 1, range.lowV, range.highV),
              clamped((std::max({a.u, b.u, c.u}) + below) >> latticeBits, range.lowU, range.highU),
              clamped((std::max({a.v, b.v, c.v}) >> latticeBits) + 1, range.lowV, range.highV)};
}

/// Whether edge functions fit into 32 bits and not too many lines beside the triangle would be tested in vain.
inline bool TriangleCover::isSmall() const noexcept {
    constexpr std::int64_t reach = std::int64_t{1} << 22; // 64 voxels
    const auto far = [](std::int64_t x, std::int64_t y) {
        return static_cast<std::uint64_t>(x - y + reach) >= static_cast<std::uint64_t>(2 * reach);
    };
    return !(lines_.highU - lines_.lowU > mostColumns || lines_.highV - lines_.lowV > mostRows || far(a_.u, b_.u) ||
             far(a_.u, c_.u) || far(a_.v, b_.v) || far(a_.v, c_.v));
}

/// The edge function at the first line of the range, in squared lattice steps, as an integer, divided by the step
/// between lines: lines lie that far apart, so the remainder does not affect the sign.
inline TriangleCover::Edge TriangleCover::edge(const LatticeVertex& from, const LatticeVertex& to) const noexcept {
    const std::int64_t du = to.u - from.u, dv = to.v - from.v;
    const std::int64_t u = (std::int64_t{lines_.lowU} << latticeBits) - from.u;
    const std::int64_t v = (std::int64_t{lines_.lowV} << latticeBits) - from.v;
    const bool holdsItsLines = dv < 0 || (dv == 0 && du < 0);
    return {static_cast<std::int32_t>((du * v - dv * u - (holdsItsLines ? 0 : 1)) >> latticeBits),
            static_cast<std::int32_t>(-dv), static_cast<std::int32_t>(du)};
}

/// Returns the bits of all rows combined.
inline std::uint32_t TriangleCover::mask(std::int64_t area, Mask& rows) const noexcept {
    const bool turned = area < 0; // edges have the inside on their left
    const Edge one = turned ? edge(b_, a_) : edge(a_, b_), two = turned ? edge(c_, b_) : edge(b_, c_),
               three = turned ? edge(a_, c_) : edge(c_, a_);
    const std::int32_t width = lines_.highU - lines_.lowU, height = lines_.highV - lines_.lowV;
    std::uint32_t all = 0;
#ifdef __SSE2__
    const auto four = [](const Edge& edge, std::int32_t u) {
        const std::int32_t at = edge.value + u * edge.alongU, step = edge.alongU;
        return _mm_setr_epi32(at, at + step, at + 2 * step, at + 3 * step);
    };
    const __m128i upOne = _mm_set1_epi32(one.alongV), upTwo = _mm_set1_epi32(two.alongV),
                  upThree = _mm_set1_epi32(three.alongV);
    std::fill_n(rows.begin(), height, 0U);
    for (std::int32_t u = 0; u < width; u += 4) {
        __m128i first = four(one, u), second = four(two, u), third = four(three, u);
        const std::uint32_t within = width - u < 4 ? (1U << (width - u)) - 1 : 0xfU;
        for (std::int32_t v = 0; v < height; ++v) {
            const __m128i signs = _mm_or_si128(_mm_or_si128(first, second), third);
            const auto outside = static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(signs)));
            const std::uint32_t inside = (~outside & within) << u;
            rows[static_cast<std::size_t>(v)] |= inside;
            all |= inside;
            first = _mm_add_epi32(first, upOne);
            second = _mm_add_epi32(second, upTwo);
            third = _mm_add_epi32(third, upThree);
        }
    }
#else
    for (std::int32_t v = 0; v < height; ++v) {
        std::uint32_t inside = 0;
        for (std::int32_t u = 0; u < width; ++u) {
            const auto value = [u, v](const Edge& edge) { return edge.value + u * edge.alongU + v * edge.alongV; };
            inside |= ((value(one) | value(two) | value(three)) >= 0 ? 1U : 0U) << u;
        }
        all |= rows[static_cast<std::size_t>(v)] = inside;
    }
#endif
    return all;
}

/// Height of a triangle's plane at the lines of its range.
class TriangleCover::Plane {
public:
    Plane(const TriangleCover& cover, double area, double lowest, double highest) noexcept {
        const LatticeVertex &a = cover.a_, &b = cover.b_, &c = cover.c_;
        const LineRectangle& lines = cover.lines_;
        // Relative to the first corner, to preserve precision.
        const double bu = static_cast<double>(b.u - a.u), bv = static_cast<double>(b.v - a.v), bz = b.along - a.along;
        const double cu = static_cast<double>(c.u - a.u), cv = static_cast<double>(c.v - a.v), cz = c.along - a.along;
        constexpr double step = static_cast<double>(std::int64_t{1} << latticeBits);
        const double slopeU = (bz * cv - cz * bv) / area, slopeV = (cz * bu - bz * cu) / area;
        first_ = a.along + slopeU * static_cast<double>((std::int64_t{lines.lowU} << latticeBits) - a.u) +
                 slopeV * static_cast<double>((std::int64_t{lines.lowV} << latticeBits) - a.v);
        stepU_ = slopeU * step;
        stepV_ = slopeV * step;
        low_ = std::clamp(std::min({a.along, b.along, c.along}), lowest, highest);
        high_ = std::clamp(std::max({a.along, b.along, c.along}), lowest, highest);
    }
    /// @param u, v lines from the low end of the range
    double at(std::int32_t u, std::int32_t v) const noexcept {
        // The slopes of a triangle seen nearly edge-on are meaningless; its crossing still lies between its corners.
        double along = first_ + stepV_ * v + stepU_ * u;
        along = along > low_ ? along : low_; // NaN becomes the lower one
        return along < high_ ? along : high_;
    }

private:
    double first_, stepU_, stepV_, low_, high_;
};

template <class Visit>
void TriangleCover::forEachLine(double lowest, double highest, Visit&& visit) const {
    if (lines_.empty()) return;
    if (isSmall()) {
        const std::int64_t area = (b_.u - a_.u) * (c_.v - a_.v) - (b_.v - a_.v) * (c_.u - a_.u);
        Mask rows;
        if (area == 0 || mask(area, rows) == 0) return;
        const Plane plane(*this, static_cast<double>(area), lowest, highest);
        for (std::int32_t v = 0; v < lines_.highV - lines_.lowV; ++v)
            for (std::uint32_t left = rows[static_cast<std::size_t>(v)]; left != 0; left &= left - 1) {
                const std::int32_t u = std::countr_zero(left);
                // Seen against the run direction a counter-clockwise triangle faces along it: the line leaves.
                visit(lines_.lowU + u, lines_.lowV + v, plane.at(u, v), area > 0);
            }
        return;
    }
    const double area = static_cast<double>(b_.u - a_.u) * static_cast<double>(c_.v - a_.v) -
                        static_cast<double>(b_.v - a_.v) * static_cast<double>(c_.u - a_.u);
    const Plane plane(*this, area, lowest, highest);
    for (std::int32_t v = lines_.lowV; v < lines_.highV; ++v) {
        const Row covered = row(v);
        for (std::int32_t u = covered.first; u < covered.end; ++u)
            visit(u, v, plane.at(u - lines_.lowU, v - lines_.lowV), covered.leaves);
    }
}

} // namespace burin
