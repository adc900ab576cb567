// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows.h"

#include "core/tool/span_rows_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

// A move that is shorter across the runs counts as parallel to them.
constexpr double leastReach = 1e-9; // voxels
constexpr double shortWay = 8.0;    // voxels

/// Returns the nearest run unit, limited to the range of int.
std::int32_t unitOf(double voxels) noexcept {
    constexpr double bound = 1e9;
    return static_cast<std::int32_t>(std::floor(std::clamp(voxels * SpanRows::unitsAVoxel, -bound, bound) + 0.5));
}

std::int32_t wholeOf(double voxels) noexcept {
    const double held = std::clamp(voxels, -1e9, 1e9);
    const auto whole = static_cast<std::int32_t>(held); // std::floor is a function call without SSE4
    return whole - (held < whole ? 1 : 0);
}

} // namespace

bool SpanRows::serves(const RevolvedPiece& piece) noexcept {
    return !piece.bulges() && piece.bottomRadius == piece.topRadius && piece.bottomRadius > 0.0 &&
           piece.top > piece.bottom;
}

SpanRows::SpanRows(const RevolvedPiece& piece, std::int32_t lineEnd) noexcept
    : piece_(piece)
    , radius_(piece.bottomRadius)
    , longestWay_(std::max(shortWay, 0.25 * radius_))
    , depth_(std::ceil((piece.cornerRadius + longestWay_) * unitsAVoxel) + 2.0) {
    if (piece.cornerRadius == 0.0)
        shape_ = Shape::flat;
    else
        shape_ = piece.cornerRadius == piece.bottomRadius ? Shape::ball : Shape::bullNose;
    // The search for a rounding's lowest point between the ends is accurate enough within this number of voxels.
    if (shape_ == Shape::bullNose) longestWay_ = shortWay;
    upright_.radius = static_cast<float>(radius_);
    upright_.flatRadius = static_cast<float>(piece.bottomRadius - piece.cornerRadius);
    upright_.cornerRadius = static_cast<float>(piece.cornerRadius);
    upright_.lineEnd = tilted_.lineEnd = lineEnd;
    reach_ = std::max(std::hypot(piece.top, radius_), std::hypot(piece.bottom, radius_));
}

double SpanRows::longestWay(const glm::dvec3& axis) const noexcept {
    if (isUpright(axis)) return longestWay_;
    // Two circles of that radius miss at most the allowed error of what one sweeps between them. Those of a corner that
    // is smaller than the error itself miss less, for any move.
    const double roundest = piece_.cornerRadius <= leaningWayError ? radius_ : piece_.cornerRadius;
    return std::min(longestWay_, std::sqrt(8.0 * roundest * leaningWayError));
}

bool SpanRows::isUpright(const glm::dvec3& axis) const noexcept {
    return axis.z > 0.0 && std::hypot(axis.x, axis.y) * reach_ <= uprightError;
}

void SpanRows::beginEnd(End& end, const glm::dvec3& tip) const noexcept {
    end.wholeX = wholeOf(tip.x);
    end.wholeY = wholeOf(tip.y);
    end.partX = static_cast<float>(tip.x - end.wholeX);
    end.partY = static_cast<float>(tip.y - end.wholeY);
    end.top = unitOf(tip.z + piece_.top);
    const double middle = std::clamp((tip.z + piece_.bottom + piece_.cornerRadius) * unitsAVoxel, -1e9, 1e9);
    const double whole = std::floor(middle);
    end.base = static_cast<std::int32_t>(whole - depth_);
    end.middle = static_cast<float>(middle - whole + depth_ + 0.5);
    // Exactly where Grid's rule places the flat, independent of the rounding's middle.
    end.flatHeight = static_cast<float>(unitOf(tip.z + piece_.bottom) - end.base) + 0.5F - end.middle;
}

void SpanRows::beginWay(const glm::dvec3& from, const glm::dvec3& to) noexcept {
    const double wayX = to.x - from.x, wayY = to.y - from.y, rise = to.z - from.z;
    const double reach = std::hypot(wayX, wayY);
    Upright& piece = upright_;
    piece.moves = reach > leastReach;
    if (!piece.moves) return;
    const double length = std::hypot(reach, rise);
    piece.wayX = static_cast<float>(wayX / reach);
    piece.wayY = static_cast<float>(wayY / reach);
    piece.reach = static_cast<float>(reach);
    piece.perReach = static_cast<float>(1.0 / reach);
    piece.rise = static_cast<float>(rise * unitsAVoxel);
    piece.riseSign = rise > 0.0 ? 1.0F : rise < 0.0 ? -1.0F : 0.0F;
    piece.sine = static_cast<float>(rise / length);
    piece.cosine = static_cast<float>(reach / length);
    const double top = std::clamp((to.z + piece_.top) * unitsAVoxel, -1e9, 1e9), whole = std::floor(top);
    piece.topBase = static_cast<std::int32_t>(whole - depth_);
    piece.topMiddle = static_cast<float>(top - whole + depth_ + 0.5);
}

void SpanRows::begin(const LinePose& from, const glm::dvec3& toTip, bool withStart) noexcept {
    upright_.withStart = tilted_.withStart = withStart;
    axis_ = from.axis;
    tilts_ = !isUpright(axis_);
    rowsOfUpright_.first = rowsOfTilted_.first = std::numeric_limits<std::int32_t>::min() / 2; // none for this move yet
    if (tilts_) return beginTilted(from, toTip);
    beginEnd(upright_.from, from.tip);
    beginEnd(upright_.to, toTip);
    beginWay(from.tip, toTip);
    upright_.levelTop = std::min(upright_.to.top, upright_.lineEnd);
    upright_.highestTop = std::max(upright_.from.top, upright_.to.top);
    upright_.joins = std::abs(toTip.z - from.tip.z) < piece_.top - piece_.bottom - piece_.cornerRadius;
    upright_.topRises = std::min(upright_.from.top, upright_.lineEnd) != upright_.levelTop;
    const double rise = toTip.z - from.tip.z;
    const bool topStays = rise <= 0.0 || !upright_.topRises;
    upright_.clipsLow = !withStart && upright_.moves && (rise >= 0.0 || shape_ == Shape::ball);
    upright_.clips = upright_.clipsLow && topStays;
    upright_.slope = upright_.clipsLow && shape_ == Shape::ball ? static_cast<float>(rise) * upright_.perReach : 0.0F;
    rows_ = {wholeOf(std::min(from.tip.y, toTip.y) - radius_), wholeOf(std::max(from.tip.y, toTip.y) + radius_) + 1};
    columns_ = {wholeOf(std::min(from.tip.x, toTip.x) - radius_), wholeOf(std::max(from.tip.x, toTip.x) + radius_) + 1};
}

void SpanRows::beginTilted(const LinePose& from, const glm::dvec3& toTip) noexcept {
    setAxis(tilted_, piece_, axis_);
    const double depth = std::ceil((reach_ + longestWay_) * unitsAVoxel) + 2.0;
    setWay(tilted_, piece_, axis_, from.tip, toTip, depth);
    tilted_.moves = from.tip != toTip;
    shadow_ = shadowOf(piece_, axis_);
    const double margin = glm::length(glm::dvec2(toTip - from.tip));
    margin_ = static_cast<float>(margin);
    columns_ = {wholeOf(toTip.x + shadow_.low.x - margin), wholeOf(toTip.x + shadow_.high.x + margin) + 1};
    rows_ = {wholeOf(toTip.y + shadow_.low.y - margin), wholeOf(toTip.y + shadow_.high.y + margin) + 1};
}

/// Computes what is met of some rows, unless it is known.
void SpanRows::plan(std::int32_t first, std::int32_t end) noexcept {
    const std::int32_t planned = tilts_ ? rowsOfTilted_.first : rowsOfUpright_.first;
    const std::int32_t count = tilts_ ? rowsAtOnce : static_cast<std::int32_t>(UprightRows::count);
    if (first >= planned && end <= planned + count) return;
    if (tilts_)
        kernels::planTiltedRows(tilted_, shadow_, margin_, first, rowsOfTilted_);
    else
        kernels::planRows(upright_, first, rowsOfUpright_);
}

int SpanRows::intervals(std::int32_t first, int rows, const LineInterval& groups, BrickOfSpans* bricks,
                        RowSpans* intervals) noexcept {
    plan(first, first + rows);
    const std::int32_t *const begins = tilts_ ? rowsOfTilted_.begin.lane + (first - rowsOfTilted_.first)
                                              : rowsOfUpright_.begin.data() + (first - rowsOfUpright_.first),
                              *const ends = tilts_ ? rowsOfTilted_.end.lane + (first - rowsOfTilted_.first)
                                                   : rowsOfUpright_.end.data() + (first - rowsOfUpright_.first);
    int count = 0;
    for (int i = 0; i < rows; ++i) {
        const std::int32_t begin = std::max(begins[i], groups.first), end = std::min(ends[i], groups.last + 1);
        if (end <= begin) continue;
        intervals[count++] = {first + i, begin, end - begin, bricks + (begin - groups.first)};
    }
    return count;
}

void SpanRows::spans(std::span<const RowSpans> intervals) noexcept {
    if (intervals.empty()) return;
    plan(intervals.front().v, intervals.back().v + 1);
    if (!tilts_) return kernels::uprightSpans(shape_, upright_, rowsOfUpright_, intervals);
    switch (shape_) {
    case Shape::ball:
        return kernels::tiltedBall(tilted_, rowsOfTilted_, intervals);
    case Shape::flat:
        return kernels::tiltedFlat(tilted_, rowsOfTilted_, intervals);
    case Shape::bullNose:
        return kernels::tiltedBullNose(tilted_, rowsOfTilted_, intervals);
    }
}

} // namespace burin
