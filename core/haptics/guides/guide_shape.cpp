// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/guides/guide_shape.h"

#include "core/geometry/frame_along.h"
#include "core/geometry/pose.h"
#include "core/haptics/boundary/fixed_axis_boundary.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double onIt = 1e-6;          // mm: the hand is on the guide, so that the direction from it is undefined
constexpr double usableGradient = 0.2; // below it (at a medial axis) the direction is noise
constexpr double clearSide = 0.1;      // share of the step-over: a hand farther from the last pass has chosen its side
constexpr double footTravel = 0.05;    // mm per tick that a foot may move in addition to the hand's motion
constexpr double footOverHand = 4.0;   // factor by which it may also be faster than the hand
constexpr double nearPass = 0.5;       // share of the step-over
constexpr double smallestMix = 1e-3;   // of opposed directions
constexpr double surfaceTravel = 10.0; // mm per tick
constexpr int surfaceSteps = 12;
constexpr double surfaceTolerance = 0.25; // share of the field's spacing
constexpr double farthestLevel = 1e6;

/// Two planes that hold a tip at a point of a curve, so that it can only slide along the curve.
GuideRows rowsAcross(const glm::dvec3& tangent, const glm::dvec3& point, const glm::dvec3& place) noexcept {
    const glm::dvec3 away = place - point;
    const double distance = glm::length(away);
    const glm::dvec3 first = distance > onIt ? away / distance : anyAcross(tangent);
    const glm::dvec3 second = glm::cross(tangent, first);
    GuideRows rows;
    rows.add(first, point);
    // Straight beyond an end, any perpendicular direction will do.
    rows.add(glm::length(second) > 1e-3 ? glm::normalize(second) : anyAcross(first), point);
    return rows;
}

/// Direction of a polyline; at its vertices halfway between the segments.
glm::dvec3 directionAt(const Polyline& line, const PolylineFoot& foot) noexcept {
    const auto direction = [&](std::size_t segment) {
        return glm::normalize(line.points[segment + 1] - line.points[segment]);
    };
    const glm::dvec3 here = direction(foot.segment);
    const bool behind = foot.share < 0.5;
    if (behind ? foot.segment == 0 : foot.segment + 1 == line.segments()) return here;
    const glm::dvec3 next = direction(behind ? foot.segment - 1 : foot.segment + 1);
    const glm::dvec3 mixed = glm::mix(here, next, std::abs(foot.share - 0.5));
    const double length = glm::length(mixed);
    return length > smallestMix ? mixed / length : here;
}

} // namespace

void GuideShape::set(const Guide& guide) noexcept {
    guide_ = guide;
    tracker_.reset();
    foot_ = {};
    level_ = 0;
    side_ = 0.0;
}

double GuideShape::spacing() const noexcept {
    if (guide_.kind == GuideKind::levels) return guide_.distance;
    if (guide_.kind == GuideKind::stepOver) return 2.0 * guide_.distance;
    return 0.0;
}

glm::dvec3 GuideShape::across(const glm::dvec3& place) const noexcept {
    return place - guide_.direction * glm::dot(guide_.direction, place);
}

double GuideShape::offsetOfPlane() const noexcept {
    const double first = glm::dot(guide_.direction, guide_.point);
    return guide_.kind == GuideKind::levels ? first + level_ * guide_.distance : first;
}

Polyline GuideShape::curve() const noexcept {
    return {guide_.curve->points(), guide_.curve->closed() ? PolylineEnds::join : PolylineEnds::stop};
}

GuideFoot GuideShape::foot(const GuideSurroundings& around, const glm::dvec3& hand, bool held, double moved) noexcept {
    switch (guide_.kind) {
    case GuideKind::plane:
    case GuideKind::levels:
        foot_ = planeFoot(hand, held);
        break;
    case GuideKind::line: {
        const glm::dvec3 away = hand - guide_.point;
        foot_ = {true, guide_.point + guide_.direction * glm::dot(guide_.direction, away), 0.0};
        break;
    }
    case GuideKind::curve:
        foot_ = {true,
                 held ? tracker_.follow(curve(), hand, footTravel + footOverHand * moved).point
                      : tracker_.search(curve(), hand).point,
                 0.0};
        break;
    case GuideKind::surface:
        foot_ = surfaceFoot(around, hand, held);
        break;
    case GuideKind::stepOver:
        foot_ = passFoot(around.lastPass, hand, held, moved);
        break;
    case GuideKind::axis:
        foot_ = {};
        break;
    }
    foot_.distance = glm::length(hand - foot_.point);
    return foot_;
}

GuideFoot GuideShape::planeFoot(const glm::dvec3& hand, bool held) noexcept {
    const glm::dvec3 normal = guide_.direction;
    if (!held && guide_.kind == GuideKind::levels) {
        const double levels = glm::dot(normal, hand - guide_.point) / guide_.distance;
        level_ = static_cast<int>(std::lround(std::clamp(levels, -farthestLevel, farthestLevel)));
    }
    return {true, hand - normal * (glm::dot(normal, hand) - offsetOfPlane()), 0.0};
}

/// A hand nearer to the part than the guide is moved out in the same way as the proxy, which settles in corners.
GuideFoot GuideShape::surfaceFoot(const GuideSurroundings& around, const glm::dvec3& hand, bool held) const noexcept {
    const FieldSample here = around.field.at(hand);
    if (!held && !here.fine) return {};
    const glm::dvec3 start = held && foot_.known ? foot_.point : hand;
    if (here.clearance >= guide_.distance) return surfaceFromOutside(around.field, hand, start);
    FixedAxisBoundary surface(around.field, guide_.distance);
    const Proxy proxy(surface);
    const ToolPose feasible = proxy.retreat({start}, surfaceTravel);
    if (!proxy.feasible(feasible)) return {};
    ProxyStride stride;
    stride.travel = surfaceTravel;
    const ProxyStep step = proxy.advance(feasible, {hand}, stride);
    const bool there =
        around.field.at(step.pose.tip).clearance - guide_.distance <= surfaceTolerance * around.field.spacing();
    return {there, step.pose.tip, 0.0};
}

/// From outside, the nearest point is the one whose normal goes through the hand: found by projecting onto the tangent
/// plane of the previous projection. Converges for hands nearer than the surface's radius of curvature.
GuideFoot GuideShape::surfaceFromOutside(const ClearanceField& field, const glm::dvec3& hand,
                                         const glm::dvec3& start) const noexcept {
    glm::dvec3 point = start;
    for (int i = 0; i < surfaceSteps; ++i) {
        const FieldSample sample = field.at(point);
        const double steepness = glm::length(sample.gradient);
        if (!sample.fine || steepness < usableGradient) return {};
        const double missing = (sample.clearance - guide_.distance) / steepness;
        const glm::dvec3 normal = sample.gradient / steepness;
        const glm::dvec3 next = hand - normal * (glm::dot(normal, hand - point) + missing);
        const double step = glm::length(next - point);
        point = next;
        if (step < onIt) break;
    }
    const FieldSample end = field.at(point);
    const double off = std::abs(end.clearance - guide_.distance);
    return {end.fine && off <= surfaceTolerance * field.spacing(), point, 0.0};
}

GuideFoot GuideShape::passFoot(const LastPass& lastPass, const glm::dvec3& hand, bool held, double moved) noexcept {
    const Polyline pass{lastPass.points(), PolylineEnds::goOn};
    if (pass.points.size() < 2) return {};
    if (lastPass.number() != passes_) {
        passes_ = lastPass.number();
        tracker_.reset();
        side_ = 0.0;
        if (held) return {}; // its reference is another pass now: it has to release the previous one first
    }
    const glm::dvec3 place = across(hand);
    const PolylineFoot& at =
        held ? tracker_.follow(pass, place, footTravel + footOverHand * moved) : tracker_.search(pass, place);
    if (!held) {
        const glm::dvec3 left = glm::cross(guide_.direction, pass.points[at.segment + 1] - pass.points[at.segment]);
        side_ = std::copysign(1.0, glm::dot(left, place - at.point));
        if (at.distance < clearSide * guide_.distance) side_ = 0.0;
    }
    if (side_ == 0.0) return {};
    const GuideRows::Row row = passRow(pass, at, place).rows[0];
    return {true, hand - row.normal * (glm::dot(row.normal, hand) - row.offset), 0.0};
}

/// The gradient of the distance to the last pass points away from it. Near the pass that direction is noise; there the
/// direction straight across the pass is used, which rotates uniformly around the polyline's corners.
GuideRows GuideShape::passRow(const Polyline& pass, const PolylineFoot& foot, const glm::dvec3& place) const noexcept {
    const glm::dvec3 onSide = side_ * glm::cross(guide_.direction, directionAt(pass, foot));
    const glm::dvec3 away = place - foot.point;
    // A hand on the other side of the last pass has a negative distance, which the guide has to correct.
    const double distance = std::copysign(glm::length(away), glm::dot(away, onSide));
    const double share = std::min(1.0, std::abs(distance) / (nearPass * guide_.distance));
    const glm::dvec3 outwards = std::abs(distance) > onIt ? away / distance : onSide;
    const glm::dvec3 mixed = glm::mix(onSide, outwards, share);
    const double length = glm::length(mixed);
    const glm::dvec3 normal = length > smallestMix ? mixed / length : onSide;
    GuideRows rows;
    rows.add(normal, place + normal * (guide_.distance - distance));
    return rows;
}

GuideRows GuideShape::atFoot(const GuideSurroundings& around, const glm::dvec3& hand) const noexcept {
    if (guide_.kind == GuideKind::curve) return curveRows(tracker_.foot(), hand);
    if (guide_.kind == GuideKind::stepOver)
        return passRow({around.lastPass.points(), PolylineEnds::goOn}, tracker_.foot(), across(hand));
    if (guide_.kind != GuideKind::surface || foot_.distance < onIt) return near(around, hand);
    GuideRows rows;
    rows.add((hand - foot_.point) / foot_.distance, foot_.point);
    return rows;
}

GuideRows GuideShape::curveRows(const PolylineFoot& foot, const glm::dvec3& place) const noexcept {
    return rowsAcross(guide_.curve->tangentAt(foot.segment, foot.share), foot.point, place);
}

GuideRows GuideShape::near(const GuideSurroundings& around, const glm::dvec3& place) const noexcept {
    GuideRows rows;
    switch (guide_.kind) {
    case GuideKind::plane:
    case GuideKind::levels:
        rows.rows[0] = {guide_.direction, offsetOfPlane()};
        rows.count = 1;
        break;
    case GuideKind::line: {
        const double along = glm::dot(guide_.direction, place - guide_.point);
        return rowsAcross(guide_.direction, guide_.point + guide_.direction * along, place);
    }
    case GuideKind::curve: {
        PolylineTracker tracker = tracker_;
        return curveRows(tracker.follow(curve(), place, surfaceTravel), place);
    }
    case GuideKind::surface: {
        const FieldSample sample = around.field.at(place);
        const double steepness = glm::length(sample.gradient);
        if (!sample.fine || steepness < usableGradient) break;
        const glm::dvec3 normal = sample.gradient / steepness;
        rows.add(normal, place - normal * ((sample.clearance - guide_.distance) / steepness));
        break;
    }
    case GuideKind::stepOver: {
        const Polyline pass{around.lastPass.points(), PolylineEnds::goOn};
        if (pass.points.size() < 2 || side_ == 0.0) break;
        PolylineTracker tracker = tracker_;
        return passRow(pass, tracker.follow(pass, across(place), surfaceTravel), across(place));
    }
    case GuideKind::axis:
        break;
    }
    return rows;
}

} // namespace burin
