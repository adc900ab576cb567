// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/arc_fit.h"

#include "core/base/units.h"

#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double widestChord = pi / 3.0;
/// Ends nearer to each other than this, in increments, could coincide for a control, and the arc become a full turn.
constexpr double fewestFigures = 16.0;

/// Coordinates in the plane of an arc and along its axis.
struct PlaneOfArc {
    int u, v, w;
    explicit PlaneOfArc(int axis) : u((axis + 1) % 3), v((axis + 2) % 3), w(axis) {}
    glm::dvec2 of(const glm::dvec3& place) const { return {place[u], place[v]}; }
};

double cross(const glm::dvec2& a, const glm::dvec2& b) noexcept {
    return a.x * b.y - a.y * b.x;
}

/// The position of the centre on the bisector of both ends, as a multiple of the chord rotated to the left; empty for
/// collinear points.
std::optional<double> centreOnBisector(std::span<const StrokePoint> points, const PlaneOfArc& plane) {
    const glm::dvec2 from = plane.of(points.front().pose.tip), to = plane.of(points.back().pose.tip);
    const glm::dvec2 middle = 0.5 * (from + to), chord = to - from;
    const glm::dvec2 left(-chord.y, chord.x);
    const double half = 0.25 * glm::dot(chord, chord);
    double sum = 0.0, square = 0.0;
    for (const StrokePoint& point : points.subspan(1, points.size() - 2)) {
        const glm::dvec2 offset = plane.of(point.pose.tip) - middle;
        const double side = glm::dot(left, offset);
        sum += side * (glm::dot(offset, offset) - half);
        square += side * side;
    }
    if (!(square > 0.0)) return {};
    return 0.5 * sum / square;
}

/// Moves a centre along the bisector until the points outside the arc lie as far from it as those inside (minimising
/// the largest distance). The apex of the arc moves by half of the difference.
double evenedOut(double part, std::span<const StrokePoint> points, const PlaneOfArc& plane) {
    constexpr int rounds = 3;
    const glm::dvec2 from = plane.of(points.front().pose.tip), to = plane.of(points.back().pose.tip), chord = to - from;
    const glm::dvec2 middle = 0.5 * (from + to), left(-chord.y, chord.x);
    const double length = glm::length(chord);
    const double side = glm::dot(left, plane.of(points[points.size() / 2].pose.tip) - middle) < 0.0 ? -1.0 : 1.0;
    for (int round = 0; round < rounds; ++round) {
        const glm::dvec2 centre = middle + part * left;
        const double radius = glm::distance(centre, from);
        double most = 0.0, least = 0.0; // beyond the arc
        for (const StrokePoint& point : points) {
            const double beyond = glm::distance(plane.of(point.pose.tip), centre) - radius;
            most = std::max(most, beyond);
            least = std::min(least, beyond);
        }
        const double apex = part * length + side * (radius + 0.5 * (most + least));
        if (!(apex * side > 0.0)) return part;
        part = (apex - 0.25 * length * length / apex) / (2.0 * length);
    }
    return part;
}

/// The distance between polyline and arc; empty if the points don't follow the arc in order.
std::optional<Deviation> deviationOf(std::span<const StrokePoint> points, const Arc& arc, const ArcTurn& turn) {
    const PlaneOfArc plane(arc.axis);
    const glm::dvec2 centre = plane.of(arc.centre);
    const double middle = 0.5 * (turn.startRadius + turn.endRadius);
    const double spread = 0.5 * std::abs(turn.startRadius - turn.endRadius);
    const double sense = arc.clockwise ? -1.0 : 1.0, climb = arc.to[plane.w] - arc.from[plane.w];
    Deviation deviation;
    deviation.include(spread, arc.from);
    glm::dvec2 before = plane.of(arc.from) - centre;
    double angle = 0.0, radiusBefore = glm::length(before), alongBefore = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec2 here = plane.of(points[i].pose.tip) - centre;
        const double step = sense * std::atan2(cross(before, here), glm::dot(before, here));
        if (step < 0.0 || step > widestChord) return {};
        angle += step;
        const double share = angle / std::abs(turn.sweep);
        if (share > 1.0 + 1e-9) return {};
        const double radius = glm::length(here);
        const double along = points[i].pose.tip[plane.w] - arc.from[plane.w] - share * climb;
        const glm::dvec2 chord = here - before;
        const double square = glm::dot(chord, chord);
        const double foot = square > 0.0 ? glm::clamp(-glm::dot(before, chord) / square, 0.0, 1.0) : 0.0;
        const double nearest = glm::length(before + foot * chord);
        const double across =
            std::max({std::abs(radius - middle), std::abs(radiusBefore - middle), std::abs(nearest - middle)}) + spread;
        const double own = std::abs(points[i].pose.tip[plane.w] - points[i - 1].pose.tip[plane.w]);
        const double bow = own * (0.02 * step * step + 0.25 * std::abs(radius - radiusBefore) / nearest);
        deviation.include(std::hypot(across, std::max(std::abs(along), std::abs(alongBefore)) + bow),
                          points[i].pose.tip);
        before = here;
        radiusBefore = radius;
        alongBefore = along;
    }
    return deviation;
}

} // namespace

std::optional<glm::dvec2> roundedCentre(const glm::dvec2& centre, const glm::dvec2& from, const glm::dvec2& to,
                                        const glm::dvec2& zero, const ArcFitRules& rules) {
    const auto rounded = [&](const glm::dvec2& place) {
        return glm::round((place - zero) / rules.figure) * rules.figure;
    };
    const glm::dvec2 start = rounded(from), end = rounded(to), nearest = rounded(centre);
    double least = std::numeric_limits<double>::infinity();
    glm::dvec2 best(0.0);
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
            const glm::dvec2 here = nearest + rules.figure * glm::dvec2(i, j);
            const double mismatch = std::abs(glm::distance(here, start) - glm::distance(here, end));
            if (mismatch < least) {
                least = mismatch;
                best = here;
            }
        }
    }
    if (least > rules.radiusMismatch) return {};
    return best + zero;
}

std::optional<FittedArc> fitArc(std::span<const StrokePoint> points, int axis, const ArcFitRules& rules) {
    const PlaneOfArc plane(axis);
    const glm::dvec3 &first = points.front().pose.tip, &last = points.back().pose.tip;
    const glm::dvec2 from = plane.of(first), to = plane.of(last), chord = to - from;
    if (glm::length(chord) < fewestFigures * rules.figure) return {};
    const std::optional<double> nearest = centreOnBisector(points, plane);
    if (!nearest) return {};
    const double part = evenedOut(*nearest, points, plane);
    const glm::dvec2 ideal = 0.5 * (from + to) + part * glm::dvec2(-chord.y, chord.x);
    const auto centre = roundedCentre(ideal, from, to, plane.of(rules.programZero), rules);
    if (!centre) return {};
    FittedArc fitted;
    fitted.arc = {first, last, first, axis, false};
    fitted.arc.centre[plane.u] = centre->x;
    fitted.arc.centre[plane.v] = centre->y;
    const glm::dvec2 half = plane.of(points[points.size() / 2].pose.tip);
    fitted.arc.clockwise = cross(half - from, to - half) < 0.0;
    const ArcTurn turn = turnOf(fitted.arc);
    if (turn.startRadius < rules.smallestRadius || turn.startRadius > rules.largestRadius) return {};
    if (std::abs(turn.sweep) > rules.largestSweep + 1e-9) return {};
    const auto deviation = deviationOf(points, fitted.arc, turn);
    if (!deviation || deviation->distance > rules.tolerance) return {};
    fitted.deviation = *deviation;
    return fitted;
}

} // namespace burin
