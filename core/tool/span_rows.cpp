// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows.h"

#include "core/tool/span_rows_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double unitsAVoxel = 256.0;
// A way that is shorter across the runs counts as one along them.
constexpr double leastReach = 1e-9; // voxels
constexpr double shortWay = 8.0;    // voxels
// Lines that are left out lie so far behind those that can have more: roundings don't decide about any.
constexpr double clipMargin = 1.0; // voxels

/// Nearest run unit, held within what an int can say.
std::int32_t unitOf(double voxels) noexcept {
    constexpr double bound = 1e9;
    return static_cast<std::int32_t>(std::floor(std::clamp(voxels * unitsAVoxel, -bound, bound) + 0.5));
}

std::int32_t wholeOf(double voxels) noexcept {
    const double held = std::clamp(voxels, -1e9, 1e9);
    const auto whole = static_cast<std::int32_t>(held); // std::floor is a call where SSE4 is not given
    return whole - (held < whole ? 1 : 0);
}

struct Extent {
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
    void include(double x) noexcept {
        low = std::min(low, x);
        high = std::max(high, x);
    }
};

void includeCircle(Extent& extent, double x, double y, double radius) noexcept {
    const double square = (radius - y) * (radius + y);
    if (square <= 0.0) return;
    extent.include(x - std::sqrt(square));
    extent.include(x + std::sqrt(square));
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
    // The search for a rounding's lowest place between the ends comes near enough within so many voxels.
    if (shape_ == Shape::bullNose) longestWay_ = shortWay;
    upright_.radius = static_cast<float>(radius_);
    upright_.flatRadius = static_cast<float>(piece.bottomRadius - piece.cornerRadius);
    upright_.cornerRadius = static_cast<float>(piece.cornerRadius);
    upright_.lineEnd = tilted_.lineEnd = lineEnd;
    reach_ = std::max(std::hypot(piece.top, radius_), std::hypot(piece.bottom, radius_));
}

double SpanRows::longestWay(const glm::dvec3& axis) const noexcept {
    if (shape_ != Shape::bullNose || isUpright(axis)) return longestWay_;
    return std::min(longestWay_, std::sqrt(8.0 * piece_.cornerRadius * leaningRoundingError));
}

bool SpanRows::isUpright(const glm::dvec3& axis) const noexcept {
    return axis.z > 0.0 && std::hypot(axis.x, axis.y) * reach_ <= uprightError;
}

void SpanRows::beginEnd(End& end, const glm::dvec3& tip) const noexcept {
    end.x = tip.x;
    end.y = tip.y;
    end.wholeX = wholeOf(tip.x);
    end.partX = static_cast<float>(tip.x - end.wholeX);
    end.top = unitOf(tip.z + piece_.top);
    const double middle = std::clamp((tip.z + piece_.bottom + piece_.cornerRadius) * unitsAVoxel, -1e9, 1e9);
    const double whole = std::floor(middle);
    end.base = static_cast<std::int32_t>(whole - depth_);
    end.middle = static_cast<float>(middle - whole + depth_ + 0.5);
    // Exactly where Grid's rule puts the flat, whatever the rounding's middle is.
    end.flatHeight = static_cast<float>(unitOf(tip.z + piece_.bottom) - end.base) + 0.5F - end.middle;
}

void SpanRows::beginWay(const glm::dvec3& from, const glm::dvec3& to) noexcept {
    const double wayX = to.x - from.x, wayY = to.y - from.y, rise = to.z - from.z;
    const double reach = std::hypot(wayX, wayY);
    moves_ = reach > leastReach;
    if (!moves_) return;
    Upright& piece = upright_;
    const double length = std::hypot(reach, rise);
    piece.wayX = wayX / reach;
    piece.wayY = wayY / reach;
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
    withStart_ = withStart;
    axis_ = from.axis;
    tilts_ = !isUpright(axis_);
    if (tilts_) return beginTilted(from, toTip);
    beginEnd(upright_.from, from.tip);
    beginEnd(upright_.to, toTip);
    beginWay(from.tip, toTip);
    upright_.levelTop = std::min(upright_.to.top, upright_.lineEnd);
    upright_.highestTop = std::max(upright_.from.top, upright_.to.top);
    upright_.joins = std::abs(toTip.z - from.tip.z) < piece_.top - piece_.bottom - piece_.cornerRadius;
    upright_.topRises = std::min(upright_.from.top, upright_.lineEnd) != upright_.levelTop;
    const double rise = toTip.z - from.tip.z;
    const bool topStays = rise <= 0.0 || std::min(upright_.from.top, upright_.lineEnd) == upright_.levelTop;
    clipsLow_ = !withStart && moves_ && (rise >= 0.0 || shape_ == Shape::ball);
    clips_ = clipsLow_ && topStays;
    behind_ = clipsLow_ ? std::max(0.0, -rise) / static_cast<double>(upright_.reach) : 0.0;
    rows_ = {wholeOf(std::min(from.tip.y, toTip.y) - radius_), wholeOf(std::max(from.tip.y, toTip.y) + radius_) + 1};
    columns_ = {wholeOf(std::min(from.tip.x, toTip.x) - radius_), wholeOf(std::max(from.tip.x, toTip.x) + radius_) + 1};
}

void SpanRows::beginTilted(const LinePose& from, const glm::dvec3& toTip) noexcept {
    setAxis(tilted_, piece_, axis_);
    const double depth = std::ceil((reach_ + longestWay_) * unitsAVoxel) + 2.0;
    setWay(tilted_, piece_, axis_, from.tip, toTip, depth);
    moves_ = from.tip != toTip;
    foot_ = glm::dvec2(toTip + axis_ * (piece_.bottom + piece_.cornerRadius));
    head_ = glm::dvec2(toTip + axis_ * piece_.top);
    width_ = radius_ + (withStart_ || moves_ ? glm::length(glm::dvec2(toTip - from.tip)) : 0.0);
    const glm::dvec2 low = glm::min(foot_, head_) - width_, high = glm::max(foot_, head_) + width_;
    columns_ = {wholeOf(low.x), wholeOf(high.x) + 1};
    rows_ = {wholeOf(low.y), wholeOf(high.y) + 1};
}

/// Of a leaning piece: the shadow of a capsule about its axis.
LineStretch SpanRows::tiltedRow(std::int32_t v) const noexcept {
    Extent extent;
    includeCircle(extent, foot_.x, v - foot_.y, width_);
    includeCircle(extent, head_.x, v - head_.y, width_);
    const glm::dvec2 axis = head_ - foot_;
    const double length = glm::length(axis);
    if (std::abs(axis.y) > 1e-12)
        for (const double side : {-width_, width_}) {
            const double part = (v - (foot_.y + side * axis.x / length)) / axis.y;
            if (part >= 0.0 && part <= 1.0) extent.include(foot_.x - side * axis.y / length + part * axis.x);
        }
    if (!(extent.low <= extent.high)) return {};
    return {wholeOf(extent.low), wholeOf(extent.high) + 1};
}

LineStretch SpanRows::row(std::int32_t v) const noexcept {
    if (tilts_) return tiltedRow(v);
    const End &from = upright_.from, &to = upright_.to;
    Extent extent;
    includeCircle(extent, to.x, v - to.y, radius_);
    if (withStart_ || moves_) includeCircle(extent, from.x, v - from.y, radius_);
    if (moves_) {
        // The two straight sides between the circles, where this row meets them.
        const double rise = to.y - from.y;
        for (const double side : {-radius_, radius_}) {
            if (rise == 0.0) break; // the circles say it all
            const double part = (v - (from.y + side * upright_.wayX)) / rise;
            if (part >= 0.0 && part <= 1.0) extent.include(from.x - side * upright_.wayY + part * (to.x - from.x));
        }
    }
    if (!(extent.low <= extent.high)) return {};
    const LineStretch lines{wholeOf(extent.low), wholeOf(extent.high) + 1};
    return clips_ ? inFront(lines, v - from.y) : lines;
}

/// Lines that can have more than at the start of the way. The height of the piece over a line is convex along the way:
/// where it does not fall at the start, it never does. Behind the axis a piece that does not sink never falls, and a
/// ball that sinks does not from behind_ · (half its chord) on.
/// @param y voxels, of the row from the axis at the start
LineStretch SpanRows::inFront(const LineStretch& lines, double y) const noexcept {
    const double chord = std::sqrt(std::max(0.0, (radius_ - y) * (radius_ + y)));
    const double ahead = -clipMargin - behind_ * chord - y * upright_.wayY; // of x · wayX, at least
    const double wayX = upright_.wayX, x = upright_.from.x;
    if (std::abs(wayX) * (radius_ + upright_.reach) < clipMargin)
        return ahead > clipMargin ? LineStretch{} : lines; // the row lies across the way
    if (wayX > 0.0) return {std::max(lines.first, wholeOf(x + ahead / wayX)), lines.last};
    return {lines.first, std::min(lines.last, wholeOf(x + ahead / wayX) + 1)};
}

void SpanRows::spans(std::int32_t v, std::int32_t firstGroup, std::int32_t groups, EightIntegers* low,
                     EightIntegers* high) const noexcept {
    kernels::Stretch stretch{v, firstGroup, groups, low, high, withStart_, moves_, 0, groups};
    if (clipsLow_ && !clips_ && !tilts_) {
        const LineStretch front = inFront({8 * firstGroup, 8 * (firstGroup + groups) - 1}, v - upright_.from.y);
        stretch.firstDeeper = (front.first >> 3) - firstGroup;
        stretch.endDeeper = front.last < front.first ? stretch.firstDeeper : (front.last >> 3) - firstGroup + 1;
    }
    switch (shape_) {
    case Shape::ball:
        return tilts_ ? kernels::tiltedBall(tilted_, stretch) : kernels::uprightBall(upright_, stretch);
    case Shape::flat:
        return tilts_ ? kernels::tiltedFlat(tilted_, stretch) : kernels::uprightFlat(upright_, stretch);
    case Shape::bullNose:
        return tilts_ ? kernels::tiltedBullNose(tilted_, stretch) : kernels::uprightBullNose(upright_, stretch);
    }
}

} // namespace burin
