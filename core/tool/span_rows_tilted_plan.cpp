// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows_kernels.h"

namespace burin::kernels {

namespace {

constexpr float far = 1e6F; // voxels, beyond every line
// Voxels by which more is requested, so that rounding can't affect any line.
constexpr float slack = 1.0F / 8.0F;
// A straight side of the shadow that rises by less over the rows is covered by the ends.
constexpr float leastRise = 1e-6F; // voxels

/// Returns numbers rounded down to integers.
BURIN_INLINE Integers floorsOf(Floats numbers) noexcept {
    const Integers whole = wholeOf(numbers);
    return whole + (floatsOf(whole) > numbers); // a true comparison is -1
}

BURIN_INLINE Floats clamped(Floats numbers, float low, float high) noexcept {
    return least(most(numbers, floats(low)), floats(high));
}

/// Returns the groups of the positions x, in voxels from a line that is `whole` lines from the grid's first.
BURIN_INLINE Integers groupsOf(Floats x, std::int32_t whole) noexcept {
    return (floorsOf(clamped(x, -far, far)) + whole) >> 3;
}

/// Returns side · x of the shadow's outermost point at these y; -far if there is none.
BURIN_INLINE Floats edgeOf(const TiltedShadow& shadow, Floats y, float side) noexcept {
    constexpr float rounding = 1e-5F;
    Floats outmost = floats(-far);
    for (const TiltedShadow::Ellipse& end : shadow.ends) {
        const Floats dy = y - end.middle.y, square = 1.0F - dy * dy * end.perSquare;
        const Floats x = side * (end.middle.x + end.slope * dy) + end.half * rootsOf(square);
        outmost = square >= floats(-rounding) ? most(outmost, x) : outmost;
    }
    const glm::vec2 along = shadow.ends[1].middle - shadow.ends[0].middle;
    const float rise = along.y < 0.0F ? -along.y : along.y;
    if (rise < leastRise) return outmost;
    const float off = slack / rise; // part of the side that a row at this distance may meet
    for (const float sign : {-1.0F, 1.0F}) {
        const glm::vec2 from = shadow.ends[0].middle + sign * shadow.contact;
        const Floats part = (y - from.y) / along.y;
        const Floats one = clamped(part - off, 0.0F, 1.0F), other = clamped(part + off, 0.0F, 1.0F);
        const Floats x = side * from.x + most(one * (side * along.x), other * (side * along.x));
        const Integers meets = (part >= floats(-off)) & (part <= floats(1.0F + off));
        outmost = meets ? most(outmost, x) : outmost;
    }
    return outmost;
}

/// Finds the groups of the shadow, with a margin around it.
BURIN_INLINE void findShadow(const TiltedShadow& shadow, float margin, Floats y, std::int32_t whole, float part,
                             TiltedRows& rows) noexcept {
    const float low = static_cast<float>(shadow.low.y), high = static_cast<float>(shadow.high.y);
    // The outermost point within the margin of a row: the edge is convex.
    const Floats left = least(most(floats(shadow.outmost[0]), y - margin), y + margin);
    const Floats right = least(most(floats(shadow.outmost[1]), y - margin), y + margin);
    const Floats first = -edgeOf(shadow, clamped(left, low, high), -1.0F) - (margin + slack);
    const Floats last = edgeOf(shadow, clamped(right, low, high), 1.0F) + (margin + slack);
    const Integers meets = (y >= floats(low - margin - slack)) & (y <= floats(high + margin + slack)) & (first <= last);
    const Integers begin = groupsOf(first + part, whole), end = groupsOf(last + part, whole) + 1;
    store(begin, rows.begin);
    store(meets ? end : begin, rows.end);
}

/// The intersection of rows of lines with the plane of a disc about the axis: chords of the disc, seen obliquely.
struct DiscRows {
    Floats middle; ///< of the chords, voxels from the reference line of positions
    Floats gone;   ///< squared distances of the chords from the disc's middle, scaled by `square`
    float square;  ///< that scale
    float halfOf;  ///< ratio of half a chord's length to the root of `left`
    BURIN_INLINE DiscRows(const TiltedPiece& piece, float height, Floats y, float part) noexcept
        : square(1.0F - piece.axisY * piece.axisY) {
        const float steep = piece.axisZ < 0.0F ? -piece.axisZ : piece.axisZ, perSquare = 1.0F / square;
        middle = (height - piece.axisY * y) * (piece.axisX * perSquare) + part;
        const Floats dy = y - piece.axisY * height;
        gone = dy * dy;
        halfOf = steep * perSquare;
    }
    /// Returns the scaled square of half a chord of a disc with this squared radius.
    BURIN_INLINE Floats left(float radiusSquare) const noexcept { return square * radiusSquare - gone; }
};

/// The groups within a chord, without those that contain its ends.
struct Within {
    Integers begin, end;
    Integers any; ///< rows that have some: all bits or none
    BURIN_INLINE Within(const DiscRows& disc, Floats left, std::int32_t whole) noexcept {
        const Floats half = rootsOf(left) * disc.halfOf - slack;
        begin = groupsOf(disc.middle - half, whole) + 1;
        end = groupsOf(disc.middle + half, whole);
        any = (left > Floats{}) & (half > Floats{}) & (begin < end);
    }
};

/// Finds lines that meet a face's plane close enough to its rim.
BURIN_INLINE void findRim(const TiltedPiece& piece, float height, Floats y, std::int32_t whole, float part,
                          TiltedRows::RimGroups& groups) noexcept {
    const DiscRows disc(piece, height, y, part);
    const float radius = piece.radius * piece.radius;
    const Floats outer = disc.left(radius + piece.rimReach);
    const Floats outerHalf = rootsOf(outer) * disc.halfOf + slack;
    // A row that misses the disc by a tiny distance counts as touching it.
    const Integers meets = outer > floats(-slack * piece.radius);
    const Integers begin = groupsOf(disc.middle - outerHalf, whole), end = groupsOf(disc.middle + outerHalf, whole) + 1;
    store(begin, groups.outerBegin);
    store(meets ? end : begin, groups.outerEnd);
    const Within inner(disc, disc.left(radius - piece.rimReach), whole);
    store(inner.any ? inner.begin : begin, groups.innerBegin);
    store(inner.any ? inner.end : begin, groups.innerEnd);
}

/// Finds lines that pass a ball's equator and its upper face, neither of them near its edge.
BURIN_INLINE void findBallToFace(const TiltedPiece& piece, Floats y, std::int32_t whole, float part,
                                 TiltedRows& rows) noexcept {
    // Far above the rounding error of a height, which can be larger for steep planes.
    constexpr float leastSteep = 1.0F / 64.0F;
    const float edge = 1.0F / 16.0F + (piece.topHeight + piece.radius) / 16384.0F; // voxels
    const float square = piece.radius * (piece.radius - 2.0F * edge);
    const float steep = piece.axisZ < 0.0F ? -piece.axisZ : piece.axisZ;
    store(integers(0), rows.ballToFaceBegin);
    store(integers(0), rows.ballToFaceEnd);
    if (piece.rounding != TiltedPiece::Rounding::ball || steep < leastSteep) return;
    const DiscRows equator(piece, piece.middleHeight, y, part), face(piece, piece.topHeight, y, part);
    const Within one(equator, equator.left(square), whole), other(face, face.left(square), whole);
    const Integers begin = most(one.begin, other.begin), end = least(one.end, other.end);
    const Integers any = one.any & other.any & (begin < end);
    store(any ? begin : integers(0), rows.ballToFaceBegin);
    store(any ? end : integers(0), rows.ballToFaceEnd);
}

} // namespace

BURIN_VECTORISED_TO_AVX512 void planTiltedRows(const TiltedPiece& piece, const TiltedShadow& shadow, float margin,
                                               std::int32_t firstRow, TiltedRows& rows) noexcept {
    rows.first = firstRow;
    const Floats y = floatsOf(Integers{0, 1, 2, 3, 4, 5, 6, 7} + (firstRow - piece.to.wholeY)) -
                     static_cast<float>(piece.to.y - piece.to.wholeY);
    const std::int32_t whole = piece.to.wholeX;
    const float part = static_cast<float>(piece.to.x - whole);
    findShadow(shadow, margin, y, whole, part, rows);
    findBallToFace(piece, y, whole, part, rows);
    if (!piece.moves || piece.withStart || piece.rimsEverywhere) return;
    for (std::size_t i = piece.rounding == TiltedPiece::Rounding::none ? 0 : 1; i < 2; ++i)
        findRim(piece, piece.rims[i].height, y, whole, part, rows.rims[i]);
}

} // namespace burin::kernels
