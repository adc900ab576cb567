// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/shadow_edge.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// A disc that is seen edge-on within this is a line without width: its neighbours contain the same information.
constexpr double leastWidth = 1e-12;
// Seen edge-on within this, a rounding's ring is a line: angles would not distinguish its points, nor their depths. The
// resulting error is less than a millionth of a millimetre at a metre from the tip.
constexpr double leastOpening = 1e-9;
// Tolerance that closes gaps due to rounding: between two arcs that meet, between the sides of two pieces of a stack,
// and at the pole of a ball.
constexpr double joint = 1e-12; // mm

/// Returns the axis (unit length); one that lies in the view's plane except for rounding is moved exactly into it.
glm::dvec3 inView(const glm::dvec3& axis) noexcept {
    return {axis.x, axis.y, std::abs(axis.z) < leastOpening ? 0.0 : axis.z};
}

} // namespace

ShadowEdge::ShadowEdge(const PieceProfile& profile, const glm::dvec3& axis) noexcept
    : profile_(profile)
    , axis_(inView(axis))
    , tilt_(std::hypot(axis_.x, axis_.y))
    , width_(std::hypot(axis_.y, axis_.z)) {
    if (tilt_ > 0.0) along_ = glm::dvec2(axis_) / tilt_;
    if (width_ > leastWidth) {
        slope_ = glm::dvec2(-axis_.x * axis_.y, -axis_.x * axis_.z) / width_;
        sink_ = glm::dvec2(-std::abs(axis_.z), std::copysign(axis_.y, axis_.y * axis_.z)) / width_;
    }
    if (profile_.side().present) addSides();
    if (profile_.arc().radius > 0.0 && profile_.arc().centreRadius != 0.0) addArcs();
}

/// Adds the side's outermost lines: where its normal, which has a given component along the axis, is perpendicular to
/// the depth.
void ShadowEdge::addSides() noexcept {
    const PieceProfile::Side& side = profile_.side();
    if (!(tilt_ > 0.0)) return;
    const double alongAxis = side.sine / tilt_;
    if (!(std::abs(alongAxis) <= 1.0)) return; // one end's shadow contains the other's
    const double beside = std::sqrt((1.0 - alongAxis) * (1.0 + alongAxis));
    for (const double sign : {-1.0, 1.0}) {
        const glm::dvec2 normal = alongAxis * along_ + sign * beside * glm::dvec2(-along_.y, along_.x);
        if (!(normal.y < 0.0)) continue;
        const glm::dvec3 outward = (glm::dvec3(normal, 0.0) - side.sine * axis_) / side.cosine;
        Side line{side.lower.height * axis_ + side.lower.radius * outward,
                  side.upper.height * axis_ + side.upper.radius * outward};
        if (line.from.x > line.to.x) std::swap(line.from, line.to);
        if (line.from.x < line.to.x) sides_[sideCount_++] = line;
    }
}

/// Adds, on either side of the projected axis, the outline's normals that the rounding has, as far as they point down.
void ShadowEdge::addArcs() noexcept {
    const double tilt = std::max(tilt_, std::numeric_limits<double>::min());
    const double axisAngle = std::atan2(along_.y, along_.x);
    const double nearAxis = std::acos(std::clamp(profile_.arc().highSine / tilt, -1.0, 1.0));
    const double offAxis = std::acos(std::clamp(profile_.arc().lowSine / tilt, -1.0, 1.0));
    for (const double sign : {-1.0, 1.0}) {
        double low = axisAngle + (sign > 0.0 ? nearAxis : -offAxis) + 0.5 * pi;
        double high = axisAngle + (sign > 0.0 ? offAxis : -nearAxis) + 0.5 * pi;
        for (const double turn : {-2.0 * pi, 0.0, 2.0 * pi}) {
            Arc arc{std::max(low + turn, -0.5 * pi), std::min(high + turn, 0.5 * pi), sign, 0.0, 0.0};
            if (!(arc.low < arc.high) || arcCount_ == arcs_.size()) continue;
            arc.acrossLow = onArc(std::sin(arc.low), std::cos(arc.low), sign).place.x;
            arc.acrossHigh = onArc(std::sin(arc.high), std::cos(arc.high), sign).place.x;
            arcs_[arcCount_++] = arc;
        }
    }
}

/// Returns the point of the torus' outline with the normal (sine, -cosine): on the ring's ellipse, offset by the
/// rounding.
ShadowEdge::ArcPoint ShadowEdge::onArc(double sine, double cosine, double sign) const noexcept {
    const PieceProfile::Arc& arc = profile_.arc();
    const glm::dvec2 normal(sine, -cosine), across(-along_.y, along_.x);
    const double alongAxis = glm::dot(normal, along_), beside = glm::dot(normal, across);
    const double flat = axis_.z * axis_.z; // squared axis ratio of the ellipse that is the ring's shadow
    const double outwardLength = std::sqrt(beside * beside + flat * alongAxis * alongAxis);
    glm::dvec3 outward(sign * across, 0.0);
    double ringCurvature = 0.0;
    if (outwardLength > 0.0) {
        outward = glm::dvec3(beside * across + flat * alongAxis * along_, -tilt_ * alongAxis * axis_.z) / outwardLength;
        ringCurvature = arc.centreRadius * flat / (outwardLength * outwardLength * outwardLength);
    }
    return {arc.centreHeight * axis_ + arc.centreRadius * outward + arc.radius * glm::dvec3(normal, 0.0),
            arc.radius + ringCurvature};
}

ShadowEdge::Point ShadowEdge::lowestOnArc(const Arc& arc, double across) const noexcept {
    double low = arc.low, high = arc.high;
    // Start value as for a circle: the sine is linear in the position across.
    const double part = (across - arc.acrossLow) / std::max(arc.acrossHigh - arc.acrossLow, 1e-300);
    const double sineLow = std::sin(low), sineHigh = std::sin(high);
    double angle = std::clamp(std::asin(std::clamp(sineLow + part * (sineHigh - sineLow), -1.0, 1.0)), low, high);
    ArcPoint point;
    double sine = 0.0, cosine = 1.0;
    for (int step = 0; step < 80; ++step) {
        sine = std::sin(angle);
        cosine = std::cos(angle);
        point = onArc(sine, cosine, arc.sign);
        const double beyond = point.place.x - across;
        if (beyond == 0.0) break;
        (beyond < 0.0 ? low : high) = angle;
        const double slope = point.curvatureRadius * cosine;
        double next = slope > 0.0 ? angle - beyond / slope : low;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double change = std::abs(next - angle);
        angle = next;
        if (change < 1e-13) break;
    }
    const double rest = cosine > 1e-6 ? (across - point.place.x) * sine / cosine : 0.0;
    return {point.place.y + rest, point.place.z};
}

void ShadowEdge::lowestOnDisc(const ProfileDisc& disc, double across, Point& best) const noexcept {
    const double x = (across - disc.height * axis_.x) / width_;
    const double square = (disc.radius - x) * (disc.radius + x);
    if (!(square >= 0.0)) return;
    const double root = std::sqrt(square);
    const double up = disc.height * axis_.y + slope_.x * x + sink_.x * root;
    if (up < best.up) best = {up, disc.height * axis_.z + slope_.y * x + sink_.y * root};
}

void ShadowEdge::lowestOnBall(double across, Point& best) const noexcept {
    const PieceProfile::Arc& arc = profile_.arc();
    const double x = across - arc.centreHeight * axis_.x;
    const double square = (arc.radius - x) * (arc.radius + x);
    if (!(square >= 0.0)) return;
    const double root = std::sqrt(square);
    const double over = x * axis_.x - root * axis_.y; // mm, above the plane through the centre across the axis
    if (over < arc.lowSine * arc.radius - joint || over > arc.highSine * arc.radius + joint) return;
    const double up = arc.centreHeight * axis_.y - root;
    if (up < best.up) best = {up, arc.centreHeight * axis_.z};
}

ShadowEdge::Point ShadowEdge::lowest(double across) const noexcept {
    Point best{infinity, 0.0};
    if (width_ > leastWidth)
        for (const ProfileDisc& disc : profile_.discs()) lowestOnDisc(disc, across, best);
    for (std::size_t i = 0; i < sideCount_; ++i) {
        const Side& side = sides_[i];
        if (across < side.from.x - joint || across > side.to.x + joint) continue;
        const glm::dvec3 place = side.from + (across - side.from.x) / (side.to.x - side.from.x) * (side.to - side.from);
        if (place.y < best.up) best = {place.y, place.z};
    }
    if (profile_.arc().radius > 0.0 && profile_.arc().centreRadius == 0.0) lowestOnBall(across, best);
    for (std::size_t i = 0; i < arcCount_; ++i) {
        if (across < arcs_[i].acrossLow - joint || across > arcs_[i].acrossHigh + joint) continue;
        const Point point = lowestOnArc(arcs_[i], across);
        if (point.up < best.up) best = point;
    }
    return best;
}

} // namespace burin
