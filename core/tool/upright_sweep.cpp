// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/upright_sweep.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

// A move that is shorter in the plane counts as vertical: the outline moves by less than the resolution of any value
// here.
constexpr double leastReach = 1e-12; // mm

double rootOf(double square) noexcept {
    return std::sqrt(std::max(square, 0.0));
}

/// A line over the rounded corner of a moving piece.
struct CornerLine {
    double flat, corner; ///< mm, radius of the flat middle and of the rounding
    double aside;        ///< mm, distance of the line from the plane that the axis moves in
    double reach, rise;  ///< mm, of the move in the plane and along the axis, both > 0
};

/// Returns the offset, mm, at which the line's height over the moving corner is stationary. With the angle a on the
/// rounding's arc, radius r = flat + corner sin a and offset u = sqrt(r² - aside²), that is where reach sin a u = rise
/// cos a r; left of it the first side is smaller. Newton steps in a bracket, which is halved whenever they leave it.
double restingOffset(const CornerLine& line) noexcept {
    double low = line.aside > line.flat ? std::asin(std::min(1.0, (line.aside - line.flat) / line.corner)) : 0.0;
    double high = 0.5 * pi;
    const auto offsetAt = [&](double radius) { return rootOf((radius - line.aside) * (radius + line.aside)); };
    double angle = 0.5 * (low + high);
    for (int step = 0; step < 80; ++step) {
        const double sine = std::sin(angle), cosine = std::cos(angle);
        const double radius = line.flat + line.corner * sine, growth = line.corner * cosine;
        const double offset = offsetAt(radius);
        const double value = line.reach * sine * offset - line.rise * cosine * radius;
        if (value == 0.0) break;
        (value < 0.0 ? low : high) = angle;
        const double slope = offset > 0.0 ? line.reach * (cosine * offset + sine * radius * growth / offset) -
                                                line.rise * (cosine * growth - sine * radius)
                                          : 0.0;
        double next = slope > 0.0 ? angle - value / slope : low;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double change = std::abs(next - angle);
        angle = next;
        if (change < 1e-13) break; // rad: far below 1e-9 mm on any tool
    }
    return offsetAt(line.flat + line.corner * std::sin(angle));
}

} // namespace

UprightSweep::UprightSweep(const RevolvedPiece& piece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept
    : piece_(piece)
    , from_(fromTip)
    , to_(toTip)
    , outline_(std::max(piece.bottomRadius, piece.topRadius))
    , outlineSquare_(outline_ * outline_) {
    const glm::dvec2 way(to_.x - from_.x, to_.y - from_.y);
    const double length = std::hypot(way.x, way.y);
    if (length > leastReach) {
        reach_ = length;
        direction_ = way / length;
    }
    const double widening = piece.topRadius - piece.bottomRadius;
    const double height = piece.top - piece.bottom;
    const double rise = to_.z - from_.z;
    if (reach_ > 0.0) sineSquare_ = rise * rise / (rise * rise + reach_ * reach_);
    lower_ = {piece.bottom,
              piece.bottomRadius - piece.cornerRadius,
              piece.cornerRadius,
              widening > 0.0 ? height / widening : 0.0,
              rise,
              from_.z,
              to_.z};
    upper_ = {-piece.top, piece.topRadius, 0.0, widening < 0.0 ? height / -widening : 0.0, -rise, -from_.z, -to_.z};
}

double UprightSweep::heightAt(const Face& face, double square) const noexcept {
    if (square <= face.flatRadius * face.flatRadius) return face.height;
    if (face.cornerRadius == outline_) return face.height + (outline_ - rootOf(outlineSquare_ - square)); // ball
    const double outside = std::sqrt(square) - face.flatRadius;
    if (face.cornerRadius > 0.0)
        return face.height + (face.cornerRadius - rootOf(face.cornerRadius * face.cornerRadius - outside * outside));
    return face.height + face.slope * outside;
}

/// Returns the smallest height of a face over the part of the move on which the line is inside the piece's outline. The
/// height is a convex function of the position on the move, so that the optimum of an unbounded move, clamped to the
/// bounds, is the optimum. Ends are evaluated with their own coordinates even if rounding puts the optimum elsewhere:
/// see the class.
double UprightSweep::least(const Face& face, const Line& line) const noexcept {
    if (face.rise == 0.0) { // the height increases with the distance from the axis, to the last bit
        double square = std::min(line.squareAtFrom, line.squareAtTo);
        if (line.passes) square = std::min(square, line.aside * line.aside);
        return face.from + heightAt(face, square);
    }
    const bool flat = face.flatRadius >= outline_;
    if (flat && line.insideAtFrom && face.rise > 0.0) return face.from + face.height;
    if (flat && line.insideAtTo && face.rise < 0.0) return face.to + face.height;
    double best = std::numeric_limits<double>::infinity();
    if (line.insideAtFrom) best = face.from + heightAt(face, line.squareAtFrom);
    if (line.insideAtTo) best = std::min(best, face.to + heightAt(face, line.squareAtTo));
    return reach_ == 0.0 ? best : std::min(best, leastBetween(face, line));
}

/// As `least`, but between the ends; infinite if an end is best.
double UprightSweep::leastBetween(const Face& face, const Line& line) const noexcept {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    const double chord = line.insideAtFrom && line.insideAtTo ? 0.0 : chordOf(line);
    // Offsets are from the axis to the line, along the move: high at its start, low at its end.
    const double high = line.insideAtFrom ? line.ahead : std::min(line.ahead, chord);
    const double low = line.insideAtTo ? line.ahead - reach_ : std::max(line.ahead - reach_, -chord);
    if (low > high) return nowhere; // touching, to rounding
    // A rising face is lowest early in the move, with the line ahead of the axis; a falling one is its mirror image.
    const double offset = face.rise > 0.0 ? bestOffset(face, line, low, high) : -bestOffset(face, line, -high, -low);
    if ((offset >= high && line.insideAtFrom) || (offset <= low && line.insideAtTo)) return nowhere;
    const double part = std::clamp((line.ahead - offset) / reach_, 0.0, 1.0);
    return face.from + part * face.rise +
           heightAt(face, std::min(line.aside * line.aside + offset * offset, outlineSquare_));
}

double UprightSweep::chordOf(const Line& line) const noexcept {
    return rootOf((outline_ - line.aside) * (outline_ + line.aside));
}

/// Returns the offset between `low` and `high` at which the height is smallest, for a face that rises by `face.rise`
/// or, mirrored, falls by it. The best offset is then not negative.
double UprightSweep::bestOffset(const Face& face, const Line& line, double low, double high) const noexcept {
    if (high <= 0.0) return high;
    const double rise = std::abs(face.rise);
    if (face.cornerRadius == outline_) { // a ball: chord · sine of the move's slope, squared until it is needed
        const double square = (outline_ - line.aside) * (outline_ + line.aside) * sineSquare_;
        if (square >= high * high) return high;
        if (low > 0.0 && square <= low * low) return low;
        return std::clamp(rootOf(square), low, high);
    }
    if (face.cornerRadius > 0.0) return bestOffsetOnCorner(face, line, low, high);
    const double chord = chordOf(line), steep = face.slope * reach_;
    double best = chord; // a flat face, or a cone less steep than the move: at the outline
    if (steep > rise) {
        const double flatEdge = std::min(rootOf(face.flatRadius * face.flatRadius - line.aside * line.aside), chord);
        best = std::clamp(line.aside * rise / std::sqrt((steep - rise) * (steep + rise)), flatEdge, chord);
    }
    return std::clamp(best, low, high);
}

/// As `bestOffset`, on the rounded corner of a bull nose.
double UprightSweep::bestOffsetOnCorner(const Face& face, const Line& line, double low, double high) const noexcept {
    const double rise = std::abs(face.rise);
    // Positive where the height at `offset`, including the rise of the move, has begun to increase.
    const auto excess = [&](double offset) {
        const double square = line.aside * line.aside + offset * offset;
        if (square <= face.flatRadius * face.flatRadius) return -1.0;
        const double radius = std::sqrt(square);
        const double sine = std::min((radius - face.flatRadius) / face.cornerRadius, 1.0);
        return reach_ * sine * offset - rise * rootOf((1.0 - sine) * (1.0 + sine)) * radius;
    };
    if (excess(high) <= 0.0) return high;
    if (low > 0.0 && excess(low) >= 0.0) return low;
    return std::clamp(restingOffset({face.flatRadius, face.cornerRadius, line.aside, reach_, rise}), low, high);
}

std::optional<UprightSweep::Line> UprightSweep::lineAt(double x, double y) const noexcept {
    const glm::dvec2 first(x - from_.x, y - from_.y), last(x - to_.x, y - to_.y);
    Line line;
    line.squareAtFrom = first.x * first.x + first.y * first.y;
    line.squareAtTo = last.x * last.x + last.y * last.y;
    line.insideAtFrom = line.squareAtFrom < outlineSquare_;
    line.insideAtTo = line.squareAtTo < outlineSquare_;
    if (reach_ > 0.0) {
        line.ahead = first.x * direction_.x + first.y * direction_.y;
        line.aside = std::abs(first.y * direction_.x - first.x * direction_.y);
        line.passes = line.ahead > 0.0 && line.ahead < reach_ && line.aside < outline_;
    }
    if (!line.insideAtFrom && !line.insideAtTo && !line.passes) return std::nullopt;
    return line;
}

std::optional<Span> UprightSweep::along(double x, double y) const noexcept {
    const std::optional<Line> line = lineAt(x, y);
    if (!line) return std::nullopt;
    const Span span{least(lower_, *line), -least(upper_, *line)};
    if (!(span.low < span.high)) return std::nullopt;
    return span;
}

std::optional<double> UprightSweep::bottomAlong(double x, double y) const noexcept {
    const std::optional<Line> line = lineAt(x, y);
    if (!line) return std::nullopt;
    return least(lower_, *line);
}

std::optional<Span> UprightSweep::shadow(double y) const noexcept {
    Span shadow{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const auto include = [&](double x) {
        shadow.low = std::min(shadow.low, x);
        shadow.high = std::max(shadow.high, x);
    };
    const auto includeCircle = [&](double centreX, double centreY) {
        const double square = (outline_ - (y - centreY)) * (outline_ + (y - centreY));
        if (square <= 0.0) return;
        include(centreX - std::sqrt(square));
        include(centreX + std::sqrt(square));
    };
    includeCircle(from_.x, from_.y);
    includeCircle(to_.x, to_.y);
    // The two straight sides between the circles, where this y meets them.
    for (const double side : {-outline_, outline_}) {
        const double rise = reach_ * direction_.y;
        if (rise == 0.0) break; // parallel to x: the circles cover everything
        const double part = (y - (from_.y + side * direction_.x)) / rise;
        if (part >= 0.0 && part <= 1.0) include(from_.x - side * direction_.y + part * reach_ * direction_.x);
    }
    if (!(shadow.low < shadow.high)) return std::nullopt;
    return shadow;
}

Box UprightSweep::bounds() const noexcept {
    const glm::dvec3 low = glm::min(from_, to_), high = glm::max(from_, to_);
    return {low + glm::dvec3(-outline_, -outline_, piece_.bottom), high + glm::dvec3(outline_, outline_, piece_.top)};
}

} // namespace burin
