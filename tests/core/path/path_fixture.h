// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/path/evaluate.h"
#include "tests/core/volume/shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>

/// Hand-made takes and parts for the tests of paths.
namespace burin::test {

inline Tool ballTool(double diameter = 6.0) {
    Tool tool;
    tool.id = "ball";
    tool.cutter.type = CutterType::ball;
    tool.cutter.diameter = diameter;
    tool.cutter.cornerRadius = 0.5 * diameter;
    tool.cutter.fluteLength = 22.0;
    tool.cutter.shankDiameter = diameter - 0.2;
    tool.cutter.stickOut = 50.0;
    tool.cutter.holder = {{28.0, 28.0, 18.0}};
    return tool;
}

inline Tool flatTool(double diameter = 6.0) {
    Tool tool = ballTool(diameter);
    tool.id = "flat";
    tool.cutter.type = CutterType::flat;
    tool.cutter.cornerRadius = 0.0;
    return tool;
}

/// The values of a tick of a made-up take in addition to the tip.
struct Tick {
    glm::dvec3 tip{0.0};
    bool removes = true;
    std::uint32_t flags = 0;
};

inline Take takeOf(const std::vector<Tick>& ticks, double allowance = 0.0) {
    Take take;
    take.info.id = 1;
    take.info.allowance = allowance;
    take.info.tickPeriod = 0.001;
    for (const Tick& tick : ticks) {
        Sample sample;
        sample.tick = take.samples.size();
        sample.time = 0.001 * static_cast<double>(sample.tick);
        sample.proxy.tip = tick.tip;
        sample.flags = tick.flags;
        if (tick.removes) sample.removed[0] = {100, 2};
        take.samples.push_back(sample);
    }
    return take;
}

/// Ticks of 1 ms along a polyline at a speed in mm/s.
inline std::vector<Tick> along(const std::vector<glm::dvec3>& corners, double speed, bool removes = true,
                               std::uint32_t flags = 0) {
    std::vector<Tick> ticks;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const double length = glm::distance(corners[i - 1], corners[i]);
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(length / (0.001 * speed))));
        for (std::size_t k = 0; k < count; ++k)
            ticks.push_back({glm::mix(corners[i - 1], corners[i], static_cast<double>(k) / static_cast<double>(count)),
                             removes, flags});
    }
    ticks.push_back({corners.back(), removes, flags});
    return ticks;
}

inline void append(std::vector<Tick>& ticks, const std::vector<Tick>& more) {
    ticks.insert(ticks.end(), more.begin(), more.end());
}

inline TriangleMesh boxMesh(const Box& box) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back({(i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                                 (i & 4) != 0 ? box.high.z : box.low.z});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

inline PathContext contextOf(const MeshDistance& part, const Tool& tool, const Box& stock) {
    PathContext context;
    context.part = &part;
    context.tool = tool;
    context.conditions.spindleSpeed = 10000.0;
    context.conditions.feed = 900.0;
    context.conditions.plungeFeed = 300.0;
    context.machine.maximumFeed = 2000.0;
    context.stock = stock;
    return context;
}

inline Result<EvaluatedPath> run(const std::vector<Take>& takes, const std::vector<Edit>& edits,
                                 const PathContext& context) {
    Progress progress;
    return evaluate("path", takes, edits, context, progress);
}

/// Whether edits left an empty path, which is not their fault.
inline bool isEmpty(const Result<EvaluatedPath>& path) {
    return !path && path.error().code == ErrorCode::pathEmpty;
}

/// Whether a point is to be inserted at a moment that earlier edits have removed.
inline bool missesMoment(const Result<EvaluatedPath>& path) {
    return !path && path.error().code == ErrorCode::argumentInvalid && path.error().subject == "at";
}

/// Points of a move at most `step` apart, including both ends. An arc is sampled by its own angles about its axis, with
/// a radius that changes evenly from one end's to the other's.
inline std::vector<glm::dvec3> placesOf(const glm::dvec3& from, const PathPoint& to, double step) {
    std::vector<glm::dvec3> places;
    if (!to.arc) {
        const auto count = static_cast<int>(std::max(1.0, std::ceil(glm::distance(from, to.pose.tip) / step)));
        for (int k = 0; k <= count; ++k) places.push_back(glm::mix(from, to.pose.tip, static_cast<double>(k) / count));
        return places;
    }
    const int w = to.arc->axis, u = (w + 1) % 3, v = (w + 2) % 3;
    const glm::dvec3 a = from - to.arc->centre, b = to.pose.tip - to.arc->centre;
    const double radiusA = std::hypot(a[u], a[v]), radiusB = std::hypot(b[u], b[v]);
    const double full = 2.0 * std::acos(-1.0), start = std::atan2(a[v], a[u]);
    double turn = std::fmod(std::atan2(b[v], b[u]) - start + 2.0 * full, full); // anticlockwise
    if (to.arc->clockwise) turn -= full;
    const auto count = static_cast<int>(std::max(1.0, std::ceil(radiusA * std::abs(turn) / step)));
    for (int k = 0; k <= count; ++k) {
        const double share = static_cast<double>(k) / count, radius = radiusA + share * (radiusB - radiusA);
        glm::dvec3 place = glm::mix(from, to.pose.tip, share);
        place[u] = to.arc->centre[u] + radius * std::cos(start + share * turn);
        place[v] = to.arc->centre[v] + radius * std::sin(start + share * turn);
        places.push_back(place);
    }
    return places;
}

/// Calls `visit(end of the move, point)` at points at most `step` apart along all moves.
inline void walk(const std::vector<PathPoint>& points, double step,
                 const std::function<void(const PathPoint& end, const glm::dvec3& place)>& visit) {
    for (std::size_t i = 1; i < points.size(); ++i)
        for (const glm::dvec3& place : placesOf(points[i - 1].pose.tip, points[i], step)) visit(points[i], place);
}

/// The points of all moves, one after the other.
inline std::vector<glm::dvec3> placesAlong(const std::vector<PathPoint>& points, double step) {
    std::vector<glm::dvec3> places;
    walk(points, step, [&](const PathPoint&, const glm::dvec3& place) { places.push_back(place); });
    return places;
}

inline double lengthAlong(const std::vector<glm::dvec3>& places) {
    double length = 0.0;
    for (std::size_t i = 1; i < places.size(); ++i) length += glm::distance(places[i - 1], places[i]);
    return length;
}

/// Turns of more than 155 degrees between feed moves, one of them shorter than 0.1 mm, with arcs as chords. Moves
/// shorter than the resolution of a program's numbers are ignored. @param arcs whether moves along arcs count
inline std::size_t backStepsIn(const std::vector<PathPoint>& points, bool arcs = true) {
    constexpr double figure = 0.001, apart = 0.02; // mm
    std::size_t count = 0;
    for (std::size_t i = 2; i < points.size(); ++i) {
        if (points[i].kind == MoveKind::rapid || points[i - 1].kind == MoveKind::rapid) continue;
        if (!arcs && (points[i].arc || points[i - 1].arc)) continue;
        const std::vector<glm::dvec3> in = placesOf(points[i - 2].pose.tip, points[i - 1], apart);
        const std::vector<glm::dvec3> out = placesOf(points[i - 1].pose.tip, points[i], apart);
        const double shorter = std::min(lengthAlong(in), lengthAlong(out));
        if (shorter < figure || shorter >= 0.1) continue;
        const glm::dvec3 arrives = in.back() - in[in.size() - 2], leaves = out[1] - out[0];
        const double cosine = glm::dot(arrives, leaves) / (glm::length(arrives) * glm::length(leaves));
        if (std::acos(std::clamp(cosine, -1.0, 1.0)) > 155.0 * pi / 180.0) ++count;
    }
    return count;
}

/// Distance from a point to a polyline; slow and obvious.
inline double distanceToPolyline(const glm::dvec3& point, const std::vector<glm::dvec3>& line) {
    double nearest = glm::distance(point, line.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
        const glm::dvec3 way = line[i] - line[i - 1];
        const double square = glm::dot(way, way);
        const double part = square > 0.0 ? glm::clamp(glm::dot(point - line[i - 1], way) / square, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, glm::distance(point, line[i - 1] + part * way));
    }
    return nearest;
}

inline std::vector<glm::dvec3> tipsOf(const std::vector<Tick>& ticks) {
    std::vector<glm::dvec3> tips;
    for (const Tick& tick : ticks) tips.push_back(tick.tip);
    return tips;
}

/// The largest distance of a point of `line` from a polyline. Both are followed together: for each point only the
/// segments near the previous nearest one are searched.
inline double farthestFrom(const std::vector<glm::dvec3>& line, const std::vector<glm::dvec3>& other) {
    double farthest = 0.0;
    std::size_t at = 0;
    for (const glm::dvec3& place : line) {
        double nearest = 1e300;
        std::size_t found = at;
        for (std::size_t i = at > 30 ? at - 30 : 0; i + 1 < std::min(other.size(), at + 400); ++i) {
            const double distance = distanceToPolyline(place, {other[i], other[i + 1]});
            if (distance >= nearest) continue;
            nearest = distance;
            found = i;
        }
        at = found;
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

inline std::vector<glm::dvec3> tipsOf(const std::vector<PathPoint>& points) {
    std::vector<glm::dvec3> tips;
    for (const PathPoint& point : points) tips.push_back(point.pose.tip);
    return tips;
}

} // namespace burin::test
