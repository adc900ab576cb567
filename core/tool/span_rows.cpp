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

/// Nearest run unit, held within what an int can say.
std::int32_t unitOf(double voxels) noexcept {
    constexpr double bound = 1e9;
    return static_cast<std::int32_t>(std::floor(std::clamp(voxels * unitsAVoxel, -bound, bound) + 0.5));
}

std::int32_t wholeOf(double voxels) noexcept {
    return static_cast<std::int32_t>(std::floor(std::clamp(voxels, -1e9, 1e9)));
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
    return piece.bottomRadius == piece.topRadius && piece.bottomRadius > 0.0 && piece.top > piece.bottom;
}

SpanRows::SpanRows(const RevolvedPiece& piece, std::int32_t lineEnd) noexcept
    : piece_(piece), radius_(piece.bottomRadius), longestWay_(std::max(8.0, 0.25 * radius_)) {
    if (piece.cornerRadius == 0.0)
        shape_ = Shape::flat;
    else
        shape_ = piece.cornerRadius == piece.bottomRadius ? Shape::ball : Shape::bullNose;
    upright_.radius = static_cast<float>(radius_);
    upright_.flatRadius = static_cast<float>(piece.bottomRadius - piece.cornerRadius);
    upright_.cornerRadius = static_cast<float>(piece.cornerRadius);
    upright_.lineEnd = lineEnd;
}

void SpanRows::beginEnd(End& end, const glm::dvec3& tip) const noexcept {
    end.x = tip.x;
    end.y = tip.y;
    end.wholeX = wholeOf(tip.x);
    end.partX = static_cast<float>(tip.x - end.wholeX);
    end.flatLow = unitOf(tip.z + piece_.bottom);
    end.top = unitOf(tip.z + piece_.top);
    const double middle = (tip.z + piece_.bottom + piece_.cornerRadius) * unitsAVoxel;
    const double depth = std::ceil(piece_.cornerRadius * unitsAVoxel) + 2.0;
    const double whole = std::floor(std::clamp(middle, -1e9, 1e9));
    end.base = static_cast<std::int32_t>(whole - depth);
    end.middle = static_cast<float>(middle - whole + depth + 0.5);
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
    piece.sine = static_cast<float>(rise / length);
    piece.cosine = static_cast<float>(reach / length);
    const double deepest = std::ceil((std::abs(rise) + piece_.cornerRadius) * unitsAVoxel) + 2.0;
    const auto middle = [&](double height, std::int32_t& base) {
        const double units = (from.z + height) * unitsAVoxel;
        const double whole = std::floor(std::clamp(units, -1e9, 1e9));
        base = static_cast<std::int32_t>(whole - deepest);
        return static_cast<float>(units - whole + deepest + 0.5);
    };
    piece.roundMiddle = middle(piece_.bottom + piece_.cornerRadius, piece.base);
    piece.flatMiddle = middle(piece_.bottom, piece.flatBase);
    piece.topMiddle = middle(piece_.top, piece.topBase);
}

void SpanRows::begin(const LinePose& from, const glm::dvec3& toTip, bool withStart) noexcept {
    withStart_ = withStart;
    beginEnd(upright_.from, from.tip);
    beginEnd(upright_.to, toTip);
    beginWay(from.tip, toTip);
    rows_ = {wholeOf(std::min(from.tip.y, toTip.y) - radius_), wholeOf(std::max(from.tip.y, toTip.y) + radius_) + 1};
    columns_ = {wholeOf(std::min(from.tip.x, toTip.x) - radius_), wholeOf(std::max(from.tip.x, toTip.x) + radius_) + 1};
}

LineStretch SpanRows::row(std::int32_t v) const noexcept {
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
    return {wholeOf(extent.low), wholeOf(extent.high) + 1};
}

void SpanRows::spans(std::int32_t v, std::int32_t firstGroup, std::int32_t groups, EightIntegers* low,
                     EightIntegers* high) const noexcept {
    const kernels::Stretch stretch{v, firstGroup, groups, low, high, withStart_, moves_};
    switch (shape_) {
    case Shape::ball:
        return kernels::uprightBall(upright_, stretch);
    case Shape::flat:
        return kernels::uprightFlat(upright_, stretch);
    case Shape::bullNose:
        return kernels::uprightBullNose(upright_, stretch);
    }
}

} // namespace burin
