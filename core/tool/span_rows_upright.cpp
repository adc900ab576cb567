// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows_kernels.h"

namespace burin::kernels {

namespace {

using Shape = SpanRows::Shape;
using Upright = SpanRows::Upright;
using End = SpanRows::End;

constexpr float unitsAVoxel = 256.0F;
constexpr int cornerSteps = 6;

struct Spans {
    Integers low = integers(SpanRows::none), high = integers(-SpanRows::none);
};

/// Height of the rounding below its middle, voxels, over lines `inside` away from the outline (square: R² - r²).
template <Shape shape>
BURIN_INLINE Floats drop(const Upright& piece, Floats inside) noexcept {
    if constexpr (shape == Shape::ball) return rootsOf(inside);
    // (corner - over)(corner + over), over = r - flat; corner - over = R - r without cancellation.
    const Floats radius = rootsOf(piece.radius * piece.radius - inside);
    const Floats over = most(radius - piece.flatRadius, Floats{});
    const Floats left = least(inside / (piece.radius + radius), floats(piece.cornerRadius));
    return rootsOf(left * (piece.cornerRadius + over));
}

/// What the piece covers at one end of its way.
template <Shape shape>
BURIN_INLINE void coverEnd(const Upright& piece, const End& end, float rowSquare, Integers u, Spans& spans) noexcept {
    const Floats x = floatsOf(u - end.wholeX) - end.partX;
    const Floats inside = rowSquare - x * x;
    const Integers covered = inside > Floats{};
    Integers low = integers(end.flatLow);
    if constexpr (shape == Shape::ball) {
        low = wholeOf(end.middle - unitsAVoxel * rootsOf(inside)) + end.base;
    } else if constexpr (shape == Shape::bullNose) {
        const Integers rounded = wholeOf(end.middle - unitsAVoxel * drop<shape>(piece, inside)) + end.base;
        const Floats flatInside = floats(piece.radius * piece.radius - piece.flatRadius * piece.flatRadius);
        low = inside >= flatInside ? low : rounded;
    }
    spans.low = covered ? least(spans.low, low) : spans.low;
    spans.high = covered ? most(spans.high, integers(end.top)) : spans.high;
}

/// A place that the piece covers at one end of its way, so that what is covered beyond joins on to that.
BURIN_INLINE void touchEnd(const End& end, float rowSquare, Integers u, Spans& spans) noexcept {
    const Floats x = floatsOf(u - end.wholeX) - end.partX;
    const Integers covered = rowSquare - x * x > Floats{};
    spans.low = covered ? least(spans.low, integers(end.top)) : spans.low;
    spans.high = covered ? most(spans.high, integers(end.top)) : spans.high;
}

/// A line seen from the way: `ahead` along it from the start, `chord` half of the way on which the piece covers it.
struct FromWay {
    Floats ahead, chord, asideSquare;
    Integers meets;
};

/// Offset from axis to line at which a bull nose that rises is lowest over it, between two bounds: the zero of a
/// function that grows, by false position, each second step a halving.
BURIN_INLINE Floats cornerOffset(const Upright& piece, Floats asideSquare, Floats low, Floats high) noexcept {
    const Floats rise = floats(piece.rise < 0.0F ? -piece.sine : piece.sine);
    // Over the flat middle it does not fall.
    const Floats flatEdge = rootsOf(piece.flatRadius * piece.flatRadius - asideSquare);
    low = least(most(low, flatEdge), high);
    const auto excess = [&](Floats offset) __attribute__((always_inline)) {
        const Floats radius = rootsOf(asideSquare + offset * offset);
        const Floats over = least(most(radius - piece.flatRadius, Floats{}), floats(piece.cornerRadius));
        const Floats below = rootsOf((piece.cornerRadius - over) * (piece.cornerRadius + over));
        const Floats grown = piece.cosine * over * offset - rise * below * radius;
        return over > Floats{} ? grown : floats(-piece.cornerRadius);
    };
    Floats atLow = excess(low), atHigh = excess(high);
    const Integers lowBest = atLow >= Floats{}, highBest = atHigh <= Floats{};
    const Floats first = low, last = high;
    for (int step = 0; step < cornerSteps; ++step) {
        const Floats bend = atHigh - atLow;
        const Floats part = step % 2 == 0 ? least(most(-atLow / bend, Floats{}), floats(1.0F)) : floats(0.5F);
        const Floats next = low + part * (high - low);
        const Floats there = excess(next);
        const Integers before = there < Floats{};
        low = before ? next : low;
        atLow = before ? there : atLow;
        high = before ? high : next;
        atHigh = before ? atHigh : there;
    }
    const Floats middle = 0.5F * (low + high);
    return highBest ? last : lowBest ? first : middle;
}

/// Lower face between the ends.
template <Shape shape>
BURIN_INLINE void coverLow(const Upright& piece, const FromWay& line, Spans& spans) noexcept {
    const Floats zero{}, one = floats(1.0F);
    if constexpr (shape == Shape::ball) {
        const Floats part = (line.ahead - piece.sine * line.chord) * piece.perReach;
        const Integers valid = line.meets & (part > zero) & (part < one);
        const Floats height = piece.rise * part - (unitsAVoxel * piece.cosine) * line.chord;
        const Integers low = wholeOf(piece.roundMiddle + (valid ? height : zero)) + piece.base;
        spans.low = valid ? least(spans.low, low) : spans.low;
        return;
    }
    const Integers passes = (line.ahead > zero) & (line.ahead < floats(piece.reach));
    if constexpr (shape == Shape::flat) {
        const Floats offset = piece.rise > 0.0F ? line.chord : piece.rise < 0.0F ? -line.chord : zero;
        const Floats part = (line.ahead - offset) * piece.perReach;
        const Integers valid = line.meets & (passes | ((part > zero) & (part < one)));
        const Floats height = piece.rise * least(most(part, zero), one);
        const Integers low = wholeOf(piece.flatMiddle + height) + piece.flatBase;
        spans.low = valid ? least(spans.low, low) : spans.low;
    } else {
        Floats offset = zero;
        const Floats first = most(line.ahead - piece.reach, -line.chord), last = least(line.ahead, line.chord);
        if (piece.rise > 0.0F)
            offset = cornerOffset(piece, line.asideSquare, most(first, zero), last);
        else if (piece.rise < 0.0F)
            offset = -cornerOffset(piece, line.asideSquare, most(-last, zero), -first);
        offset = least(most(offset, first), last);
        const Floats part = (line.ahead - offset) * piece.perReach;
        const Integers valid = line.meets & (first <= last) & (passes | ((part > zero) & (part < one)));
        const Floats inside = piece.radius * piece.radius - line.asideSquare - offset * offset;
        const Floats height = piece.rise * least(most(part, zero), one) - unitsAVoxel * drop<shape>(piece, inside);
        const Integers low = wholeOf(piece.roundMiddle + (valid ? height : zero)) + piece.base;
        spans.low = valid ? least(spans.low, low) : spans.low;
    }
}

/// Upper face between the ends; it is flat.
BURIN_INLINE void coverHigh(const Upright& piece, const FromWay& line, Spans& spans) noexcept {
    const Floats zero{}, one = floats(1.0F);
    const Floats offset = piece.rise > 0.0F ? -line.chord : piece.rise < 0.0F ? line.chord : zero;
    const Floats part = (line.ahead - offset) * piece.perReach;
    const Integers passes = (line.ahead > zero) & (line.ahead < floats(piece.reach));
    const Integers valid = line.meets & (passes | ((part > zero) & (part < one)));
    const Floats height = piece.rise * least(most(part, zero), one);
    const Integers high = wholeOf(piece.topMiddle + height) + piece.topBase;
    spans.high = valid ? most(spans.high, high) : spans.high;
}

/// What depends on the row alone.
struct Row {
    float fromSquare, toSquare;      ///< R² - y² at both ends, voxels²
    float ahead, aside, wayX, wayY;  ///< of the line at x = 0, seen from the start
};

template <Shape shape, bool withStart, bool moves>
BURIN_INLINE void cover(const Upright& piece, const Row& row, const Stretch& stretch) noexcept {
    Integers u = Integers{0, 1, 2, 3, 4, 5, 6, 7} + stretch.firstGroup * lanes;
    for (std::int32_t group = 0; group < stretch.groups; ++group, u += lanes) {
        Spans spans;
        coverEnd<shape>(piece, piece.to, row.toSquare, u, spans);
        if constexpr (withStart)
            coverEnd<shape>(piece, piece.from, row.fromSquare, u, spans);
        else
            touchEnd(piece.from, row.fromSquare, u, spans);
        if constexpr (moves) {
            const Floats x = floatsOf(u - piece.from.wholeX) - piece.from.partX;
            const Floats aside = row.aside - x * row.wayY;
            const Floats inside = (piece.radius - aside) * (piece.radius + aside);
            const FromWay line{x * row.wayX + row.ahead, rootsOf(inside), aside * aside, inside > Floats{}};
            coverLow<shape>(piece, line, spans);
            coverHigh(piece, line, spans);
        }
        store(most(spans.low, Integers{}), stretch.low[group]);
        store(least(spans.high, integers(piece.lineEnd)), stretch.high[group]);
    }
}

template <Shape shape>
BURIN_INLINE void coverRow(const Upright& piece, const Stretch& stretch) noexcept {
    const double radius = piece.radius;
    const double fromY = stretch.v - piece.from.y, toY = stretch.v - piece.to.y;
    const Row row{static_cast<float>((radius - fromY) * (radius + fromY)),
                  static_cast<float>((radius - toY) * (radius + toY)),
                  static_cast<float>(fromY * piece.wayY),
                  static_cast<float>(fromY * piece.wayX),
                  static_cast<float>(piece.wayX),
                  static_cast<float>(piece.wayY)};
    if (stretch.withStart)
        stretch.moves ? cover<shape, true, true>(piece, row, stretch) : cover<shape, true, false>(piece, row, stretch);
    else
        stretch.moves ? cover<shape, false, true>(piece, row, stretch)
                      : cover<shape, false, false>(piece, row, stretch);
}

} // namespace

BURIN_VECTORISED void uprightBall(const SpanRows::Upright& piece, const Stretch& stretch) noexcept {
    coverRow<Shape::ball>(piece, stretch);
}

BURIN_VECTORISED void uprightFlat(const SpanRows::Upright& piece, const Stretch& stretch) noexcept {
    coverRow<Shape::flat>(piece, stretch);
}

BURIN_VECTORISED void uprightBullNose(const SpanRows::Upright& piece, const Stretch& stretch) noexcept {
    coverRow<Shape::bullNose>(piece, stretch);
}

} // namespace burin::kernels
