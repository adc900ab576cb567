// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/piece_chord.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallestStep = 1e-11; // mm; where a line grazes, what is left is as long as the last step
// By so much a line beside a face counts as in it: what roundings make of a metre.
constexpr double besideFace = 1e-12; // mm

bool clip(Span& span, double low, double high) noexcept {
    span.low = std::max(span.low, low);
    span.high = std::min(span.high, high);
    return span.low < span.high;
}

/// Where low < offset + slope z < high.
bool clipToSlab(Span& span, double slope, double offset, double low, double high) noexcept {
    if (slope == 0.0) return low < offset && offset < high;
    const double first = (low - offset) / slope, second = (high - offset) / slope;
    return clip(span, std::min(first, second), std::max(first, second));
}

} // namespace

PieceChord::PieceChord(const RevolvedPiece& piece, const glm::dvec3& axis) noexcept
    : piece_(piece), lean_(std::hypot(axis.x, axis.y)), rise_(axis.z) {
    if (lean_ > 0.0) direction_ = glm::dvec2(axis) / lean_;
    if (piece.bulges()) {
        roundRadius_ = piece.bulgeRadius;
        ringRadius_ = piece.bulgeCentreRadius;
        ringHeight_ = piece.bulgeCentreHeight;
    } else {
        widening_ = (piece.topRadius - piece.bottomRadius) / (piece.top - piece.bottom);
        roundRadius_ = piece.cornerRadius;
        ringRadius_ = piece.bottomRadius - piece.cornerRadius;
        ringHeight_ = piece.bottom + piece.cornerRadius;
    }
}

std::optional<Span> PieceChord::along(double x, double y) const noexcept {
    const Line line{y * direction_.x - x * direction_.y, x * direction_.x + y * direction_.y};
    Span span{-infinity, infinity};
    if (!clipToFaces(line, span)) return std::nullopt;
    const bool met = piece_.bulges()      ? clipToBulge(line, span)
                     : widening_ != 0.0   ? clipToCone(line, span)
                     : roundRadius_ > 0.0 ? clipToCylinder(line, span) && clipToCorner(line, span)
                                          : clipToCylinder(line, span);
    if (!met) return std::nullopt;
    return span;
}

/// A line across the axis may lie in the face in which two pieces of a stack meet: each has it then, or neither had.
bool PieceChord::clipToFaces(const Line& line, Span& span) const noexcept {
    return clipToSlab(span, rise_, line.before * lean_, piece_.bottom - besideFace, piece_.top + besideFace);
}

bool PieceChord::clipToCylinder(const Line& line, Span& span) const noexcept {
    const double square = (piece_.topRadius - line.aside) * (piece_.topRadius + line.aside);
    if (!(square > 0.0)) return false;
    const double half = std::sqrt(square);
    return clipToSlab(span, lean_, -line.before * rise_, -half, half);
}

/// Distance from the axis at z: sqrt(aside² + (z lean - before rise)²); radius of the cone: linear in z, not negative
/// between the faces. Their squares are equal at the roots of A z² + 2 B z + C.
bool PieceChord::clipToCone(const Line& line, Span& span) const noexcept {
    const double across = line.before * rise_;
    const double radius = piece_.bottomRadius + widening_ * (line.before * lean_ - piece_.bottom);
    const double growth = widening_ * rise_;
    const double a = (lean_ - growth) * (lean_ + growth);
    const double b = -lean_ * across - radius * growth;
    const double c = line.aside * line.aside + (across - radius) * (across + radius);
    const double discriminant = b * b - a * c;
    if (a >= 0.0 && discriminant <= 0.0) return a == 0.0 && c < 0.0;
    const double sum = -(b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b));
    const double first = sum / a, second = sum == 0.0 ? first : c / sum;
    const double low = std::min(first, second), high = std::max(first, second);
    if (a >= 0.0) return clip(span, low, high);
    return growth > 0.0 ? clip(span, high, infinity) : clip(span, -infinity, low); // the nappe that the piece is on
}

bool PieceChord::clipToBall(const Line& line, double radius, Span& span) const noexcept {
    const double beside = line.before - ringHeight_ * lean_;
    const double square = (radius - line.aside) * (radius + line.aside) - beside * beside;
    if (!(square > 0.0)) return false;
    const double half = std::sqrt(square), middle = ringHeight_ * rise_;
    return clip(span, middle - half, middle + half);
}

bool PieceChord::clipToCorner(const Line& line, Span& span) const noexcept {
    const bool lowInCorner = heightAt(line, span.low) < ringHeight_,
               highInCorner = heightAt(line, span.high) < ringHeight_;
    if (!lowInCorner && !highInCorner) return true;
    if (ringRadius_ == 0.0) {
        Span ball{-infinity, infinity};
        return clipToBall(line, roundRadius_, ball) &&
               clip(span, lowInCorner ? ball.low : -infinity, highInCorner ? ball.high : infinity);
    }
    if (lowInCorner && !advance(line, 1.0, span.low)) return false;
    if (highInCorner && !advance(line, -1.0, span.high)) return false;
    return span.low < span.high;
}

bool PieceChord::clipToBulge(const Line& line, Span& span) const noexcept {
    if (!clipToBall(line, std::max(ringRadius_, 0.0) + roundRadius_, span)) return false;
    if (ringRadius_ == 0.0) return true;
    return advance(line, 1.0, span.low) && advance(line, -1.0, span.high) && span.low < span.high;
}

/// Moves z, if it lies outside of the rounding, on to its surface. False: there is none in that direction.
bool PieceChord::advance(const Line& line, double direction, double& z) const noexcept {
    for (int step = 0; step < 64; ++step) {
        const double across = z * lean_ - line.before * rise_;
        const double fromAxis = std::sqrt(line.aside * line.aside + across * across);
        const double out = std::max(fromAxis - ringRadius_, 0.0);
        double over = heightAt(line, z) - ringHeight_;
        if (!piece_.bulges()) over = std::min(over, 0.0); // above its corner a bull nose is a cylinder
        const double fromRing = std::sqrt(out * out + over * over);
        const double distance = fromRing - roundRadius_;
        if (distance <= 0.0) return true;
        const double slope = direction *
                             ((out > 0.0 && fromAxis > 0.0 ? out * across * lean_ / fromAxis : 0.0) + over * rise_) /
                             fromRing;
        if (!(slope < 0.0)) return false;
        const double move = -distance / slope;
        z += direction * move;
        if (move < smallestStep) return true;
    }
    return true;
}

} // namespace burin
