// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/scenes/tool_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace burin::benchmarks {

namespace {

/// A number from -1 to 1, the same on every machine (the distributions of the standard library are not).
double draw(std::mt19937& random) {
    return static_cast<double>(random()) / 2147483647.5 - 1.0;
}

} // namespace

Cutter cutterOf(CutterType type, double radius, double length) {
    Cutter cutter;
    cutter.type = type;
    cutter.diameter = 2.0 * radius;
    cutter.cornerRadius = type == CutterType::ball ? radius : type == CutterType::flat ? 0.0 : 0.25 * radius;
    cutter.fluteLength = length * radius;
    cutter.shankDiameter = 1.9 * radius;
    cutter.stickOut = (length + 3.0) * radius;
    cutter.holder = {{3.0 * radius, 3.0 * radius, 2.0 * radius}};
    return cutter;
}

namespace {

/// @param room  half extents about the middle
std::vector<glm::dvec3> walkIn(const glm::dvec3& middle, const glm::dvec3& room, double reach, double step,
                               std::size_t ticks, unsigned seed) {
    std::mt19937 random(seed);
    glm::dvec3 place = middle + 0.3 * room * glm::dvec3(draw(random), draw(random), draw(random));
    glm::dvec3 heading = glm::normalize(glm::dvec3(draw(random), draw(random), 0.5 * draw(random)));
    glm::dvec3 turning(0.0);
    std::vector<glm::dvec3> tips{place};
    while (tips.size() <= ticks) {
        // The walk bends over lengths of about `reach`, whatever the step.
        const double share = std::min(1.0, step / reach);
        turning += share * (glm::dvec3(draw(random), draw(random), draw(random)) * 4.0 - turning);
        const glm::dvec3 out = (place - middle) / room;
        const double far = std::max({std::abs(out.x), std::abs(out.y), std::abs(out.z)});
        const glm::dvec3 back = far > 0.75 ? -8.0 * (far - 0.75) * out / far : glm::dvec3(0.0);
        heading = glm::normalize(heading + share * (turning + 4.0 * back));
        place += step * heading;
        tips.push_back(place);
    }
    return tips;
}

/// The middle of the tips, on which the tool stands.
glm::dvec3 middleOf(double side, double reach) {
    return glm::dvec3(0.5 * side) - glm::dvec3(0.0, 0.0, reach);
}
double roomOf(double side, double reach) {
    return std::max(0.5 * side - reach, 0.1 * side);
}

} // namespace

std::vector<glm::dvec3> walk(double side, double reach, double step, std::size_t ticks, unsigned seed) {
    return walkIn(middleOf(side, reach), glm::dvec3(roomOf(side, reach)), reach, step, ticks, seed);
}

std::vector<glm::dvec3> walkFromAbove(double side, double radius, double step, std::size_t ticks) {
    const double room = roomOf(side, radius), depth = 2.2 * radius;
    return walkIn({0.5 * side, 0.5 * side, side - depth}, {room, room, 0.7 * radius}, radius, step, ticks, 1);
}

std::vector<glm::dvec3> raster(double side, double radius, double step, std::size_t ticks) {
    const double angle = 20.0 / 180.0 * std::numbers::pi, length = std::min(0.5 * side, 8.0 * radius);
    const glm::dvec3 along(std::cos(angle), std::sin(angle), 0.0), aside(-along.y, along.x, 0.0);
    const glm::dvec3 start = glm::dvec3(0.5 * side, 0.5 * side, 0.97 * side - radius) - 0.5 * length * along;
    std::vector<glm::dvec3> tips;
    glm::dvec2 place(0.0); // along and aside
    double heading = 1.0, sidestep = 0.0;
    while (tips.size() <= ticks) {
        tips.push_back(start + place.x * along + place.y * aside);
        if (sidestep > 0.0) {
            place.y += step;
            sidestep -= step;
        } else {
            place.x += heading * step;
            if (place.x > length || place.x < 0.0) {
                heading = -heading;
                sidestep = 0.5 * radius;
            }
        }
    }
    return tips;
}

std::vector<ToolPose> tilted(const std::vector<glm::dvec3>& tips, double tilt) {
    std::vector<ToolPose> poses;
    poses.reserve(tips.size());
    for (std::size_t i = 0; i < tips.size(); ++i) {
        const double phase = 0.01 * static_cast<double>(i);
        const double polar = tilt * (1.0 + 0.05 * std::sin(phase)), azimuth = 0.05 * std::cos(0.7 * phase);
        poses.push_back(
            {tips[i], {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)}});
    }
    return poses;
}

std::vector<ToolPose> upright(const std::vector<glm::dvec3>& tips) {
    std::vector<ToolPose> poses;
    poses.reserve(tips.size());
    for (const glm::dvec3& tip : tips) poses.push_back({tip, {0.0, 0.0, 1.0}});
    return poses;
}

} // namespace burin::benchmarks
