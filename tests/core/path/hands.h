// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "path_fixture.h"

#include <random>

/// Simulated hands for the tests of smoothing, and the references that their strokes are compared with.
namespace burin::test {

/// Tremor in the frequency band of hands: twenty waves per coordinate of 8 to 12 Hz, with a given total (root mean
/// square of the distance).
inline void tremble(std::vector<Tick>& ticks, double rms, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> frequency(8.0, 12.0), phase(0.0, 2.0 * pi);
    for (int axis = 0; axis < 3; ++axis) {
        for (int wave = 0; wave < 20; ++wave) {
            const double f = frequency(random), start = phase(random), height = rms * std::sqrt(2.0 / 60.0);
            for (std::size_t i = 0; i < ticks.size(); ++i)
                ticks[i].tip[axis] += height * std::sin(2.0 * pi * f * 0.001 * static_cast<double>(i) + start);
        }
    }
}

inline std::vector<Tick> circle(double radius, double speed, double turns) {
    std::vector<Tick> ticks;
    const double angle = 0.001 * speed / radius;
    for (int i = 0; i * angle < turns * 2.0 * pi; ++i)
        ticks.push_back({{radius * std::cos(i * angle), radius * std::sin(i * angle), -2.0}});
    return ticks;
}

inline double offCircle(const glm::dvec3& tip, double radius) {
    return std::hypot(std::hypot(tip.x, tip.y) - radius, tip.z + 2.0);
}

inline double rmsOffCircle(const std::vector<glm::dvec3>& tips, double radius) {
    double sum = 0.0;
    for (const glm::dvec3& tip : tips) sum += offCircle(tip, radius) * offCircle(tip, radius);
    return std::sqrt(sum / static_cast<double>(tips.size()));
}

/// A hand that draws a smooth random curve without turning back, stops and continues at random, like a mouse whose
/// pointer moves in jumps: it slows down towards each stop.
inline std::vector<Tick> steadyHand(std::mt19937& random) {
    std::uniform_real_distribution<double> one(-1.0, 1.0);
    double heading = 3.0 * one(random), bend = 0.0, speed = 0.0, wanted = 40.0;
    glm::dvec3 at(0.0, 0.0, -2.0);
    std::vector<Tick> ticks{{at}};
    for (int tick = 0; tick < 3000; ++tick) {
        if (tick % 200 == 0) bend = 0.25 * one(random); // 1/mm: radii of 4 mm and more
        if (tick % 150 == 0) wanted = one(random) < -0.2 ? 0.0 : 60.0 * std::abs(one(random)); // mm/s
        speed += (wanted - speed) * 0.04;
        const double way = 0.001 * speed;
        heading += bend * way;
        at += way * glm::dvec3(std::cos(heading), std::sin(heading), 0.1 * std::sin(0.7 * heading));
        ticks.push_back({at});
    }
    return ticks;
}

/// A hand that moves straight from corner to corner, some of them sharp and some bevelled, and slows down towards each,
/// like the tool of a mouse that follows the pointer's trail.
inline std::vector<Tick> corneredHand(std::mt19937& random) {
    std::uniform_real_distribution<double> one(-1.0, 1.0);
    std::vector<glm::dvec3> corners{{0.0, 0.0, -2.0}};
    for (int leg = 0; leg < 6; ++leg) {
        const glm::dvec3 way(20.0 * one(random), 20.0 * one(random), one(random));
        if (glm::length(way) < 3.0) continue;
        corners.push_back(corners.back() + way);
        const glm::dvec3 bevel = 0.25 * glm::normalize(glm::dvec3(one(random), one(random), 0.0));
        if (one(random) > 0.0) corners.push_back(corners.back() + bevel);
    }
    std::vector<Tick> ticks{{corners.front()}};
    for (std::size_t i = 1; i < corners.size(); ++i) {
        double left = glm::distance(corners[i - 1], corners[i]);
        for (const glm::dvec3 way = (corners[i] - corners[i - 1]) / left; left > 1e-4;) {
            left -= std::min(0.06, 0.04 * left);
            ticks.push_back({corners[i] - left * way});
        }
    }
    return ticks;
}

/// A hand that shakes at every tick and changes its direction every 60: not smooth at all.
inline std::vector<Tick> jitteryHand(std::mt19937& random, int count) {
    std::uniform_real_distribution<double> one(-1.0, 1.0);
    std::vector<Tick> ticks;
    glm::dvec3 at(0.0), speed(0.0);
    for (int i = 0; i < count; ++i) {
        if (i % 60 == 0) speed = 0.1 * glm::dvec3(one(random), one(random), one(random));
        at += speed + 0.01 * glm::dvec3(one(random), one(random), one(random));
        ticks.push_back({at});
    }
    return ticks;
}

/// Turns of more than 155° with a leg of less than `longest` (mm), which make a machine stutter. Points closer than a
/// control's resolution count as one.
inline std::size_t backSteps(const std::vector<glm::dvec3>& line, double longest = 0.1) {
    std::vector<glm::dvec3> apart;
    for (const glm::dvec3& point : line)
        if (apart.empty() || glm::distance(point, apart.back()) > 1e-6) apart.push_back(point);
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < apart.size(); ++i) {
        const glm::dvec3 in = apart[i] - apart[i - 1], out = apart[i + 1] - apart[i];
        const double turn = std::acos(glm::clamp(glm::dot(in, out) / (glm::length(in) * glm::length(out)), -1.0, 1.0));
        if (turn > 155.0 * pi / 180.0 && std::min(glm::length(in), glm::length(out)) < longest) ++count;
    }
    return count;
}

/// Points of a path's cutting moves, with arcs as chords.
inline std::vector<glm::dvec3> cutsOf(const std::vector<PathPoint>& points) {
    std::vector<glm::dvec3> places;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].kind != MoveKind::cut) continue;
        const std::vector<glm::dvec3> move = placesOf(points[i - 1].pose.tip, points[i], points[i].arc ? 0.05 : 1e9);
        places.insert(places.end(), move.begin(), move.end());
    }
    return places;
}

} // namespace burin::test
