// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/piece_chord.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallestStep = 1e-11; // mm; for a grazing line, the remaining distance is as long as the last step
// A line within this distance of a face counts as lying in it: the rounding error of a metre.
constexpr double besideFace = 1e-12; // mm
// A line within this distance of the outline counts as lying on it, touching the piece in one point. The chord is the
// root of the distance to the outline: otherwise touching lines would, depending on rounding, have chords of 1e-7 mm or
// none.
constexpr double besideOutline = 1e-12; // mm
constexpr double grazingChord = 1e-4;   // mm, longer than any chord this close to the outline of a tool
// Relative to the square of the sine of the axis' inclination. If it is less, a cone's generators are parallel to the
// lines: the rest is rounding error.
constexpr double leastOpening = 1e-15;

bool clip(Span& span, double low, double high) noexcept {
    span.low = std::max(span.low, low);
    span.high = std::min(span.high, high);
    return span.low <= span.high;
}

/// Clips to where low < offset + slope z < high.
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
        tipRadius_ = piece.bottomRadius - widening_ * piece.bottom;
        opening_ = (lean_ - widening_ * rise_) * (lean_ + widening_ * rise_);
        if (std::abs(opening_) < leastOpening * lean_ * lean_) opening_ = 0.0;
        openingRoot_ = std::sqrt(std::max(opening_, 0.0));
        outlineUnit_ = lean_ * std::hypot(1.0, widening_);
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

/// Clips to the end faces. A line perpendicular to the axis may lie in the face in which two pieces of a stack meet: it
/// then belongs to both, as otherwise neither might have it.
bool PieceChord::clipToFaces(const Line& line, Span& span) const noexcept {
    return clipToSlab(span, rise_, line.before * lean_, piece_.bottom - besideFace, piece_.top + besideFace);
}

bool PieceChord::clipToCylinder(const Line& line, Span& span) const noexcept {
    const double aside = std::abs(line.aside), inside = piece_.topRadius - aside;
    if (!(inside >= -besideOutline)) return false;
    const double half = inside > besideOutline ? std::sqrt(inside * (piece_.topRadius + aside)) : 0.0;
    return clipToSlab(span, lean_, -line.before * rise_, -half, half);
}

/// Distance from the axis at z: sqrt(aside² + (z lean - before rise)²); radius of the cone: linear in z, not negative
/// between the faces. Their squares are equal at the roots of A z² + 2 B z + C. The outline is two straight lines, on
/// which aside is as long as `reach` over the root of A. The discriminant is written in this form, since in B² - A C
/// everything that distinguishes a touching line from others would cancel.
bool PieceChord::clipToCone(const Line& line, Span& span) const noexcept {
    const double across = line.before * rise_;
    const double radius = piece_.bottomRadius + widening_ * (line.before * lean_ - piece_.bottom);
    const double growth = widening_ * rise_;
    const double a = opening_;
    const double b = -lean_ * across - radius * growth;
    const double c = line.aside * line.aside + (across - radius) * (across + radius);
    const double reach = lean_ * tipRadius_ + widening_ * line.before, aside = std::abs(line.aside);
    double discriminant = reach * reach - a * aside * aside;
    if (a >= 0.0) {
        const double inside = reach - openingRoot_ * aside, beside = besideOutline * outlineUnit_;
        if (!(inside >= -beside)) return false;
        if (!(inside > beside)) return a > 0.0 && clip(span, -b / a, -b / a);
        discriminant = inside * (reach + openingRoot_ * aside);
    }
    const double sum = -(b + std::copysign(std::sqrt(discriminant), b));
    const double first = sum / a, second = sum == 0.0 ? first : c / sum;
    const double low = std::min(first, second), high = std::max(first, second);
    if (a >= 0.0) return clip(span, low, high);
    return growth > 0.0 ? clip(span, high, infinity) : clip(span, -infinity, low); // the nappe that contains the piece
}

bool PieceChord::clipToBall(const Line& line, double radius, Span& span) const noexcept {
    const double beside = line.before - ringHeight_ * lean_;
    const double square = (radius - line.aside) * (radius + line.aside) - beside * beside;
    const double least = 2.0 * radius * besideOutline;
    if (!(square >= -least)) return false;
    const double half = square > least ? std::sqrt(square) : 0.0, middle = ringHeight_ * rise_;
    return clip(span, middle - half, middle + half);
}

inline PieceChord::RingPlace PieceChord::ringPlaceAt(const Line& line, double z) const noexcept {
    RingPlace place;
    place.across = z * lean_ - line.before * rise_;
    place.fromAxis = std::sqrt(line.aside * line.aside + place.across * place.across);
    place.out = std::max(place.fromAxis - ringRadius_, 0.0);
    place.over = heightAt(line, z) - ringHeight_;
    if (!piece_.bulges()) place.over = std::min(place.over, 0.0); // above its corner a bull nose is a cylinder
    place.fromRing = std::sqrt(place.out * place.out + place.over * place.over);
    return place;
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
    return enterRounding(line, lowInCorner, highInCorner, span);
}

bool PieceChord::clipToBulge(const Line& line, Span& span) const noexcept {
    if (!clipToBall(line, std::max(ringRadius_, 0.0) + roundRadius_, span)) return false;
    if (ringRadius_ == 0.0) return true;
    return enterRounding(line, true, true, span);
}

bool PieceChord::enterRounding(const Line& line, bool low, bool high, Span& span) const noexcept {
    if (low && !advance(line, 1.0, span.low)) return false;
    if (high && !advance(line, -1.0, span.high)) return false;
    if (span.high - span.low > grazingChord) return true;
    const double middle = 0.5 * (span.low + span.high);
    if (ringPlaceAt(line, middle).fromRing >= roundRadius_ - besideOutline) span = {middle, middle};
    return span.low <= span.high;
}

/// Moves z onto the surface of the rounding if it lies outside. Returns false if there is no surface in that direction.
bool PieceChord::advance(const Line& line, double direction, double& z) const noexcept {
    for (int step = 0; step < 64; ++step) {
        const auto [across, fromAxis, out, over, fromRing] = ringPlaceAt(line, z);
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
