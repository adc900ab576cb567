// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/cutting/calibration.h"

#include <cmath>
#include <random>

namespace burin::tests {

/// Noise that is identical with every standard library.
class Noise {
public:
    explicit Noise(std::uint64_t seed) : generator_(seed) {}
    double uniform() { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1.0p-53; }
    double normal() { return std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * pi * uniform()); }
    glm::dvec3 vector(double deviation) { return deviation * glm::dvec3(normal(), normal(), normal()); }

private:
    std::mt19937_64 generator_;
};

/// Conditions of the i-th of a series of cuts: three depths, four feeds, slots; 6 mm, two teeth, 12,000 1/min.
inline ForceRecord conditions(std::size_t i) {
    ForceRecord record;
    record.line = i + 2;
    record.material = "test";
    record.spindleSpeed = 12'000.0;
    record.diameter = record.radialDepth = 6.0;
    record.teeth = 2;
    record.axialDepth = 1.0 + static_cast<double>(i % 3);
    record.feed = 500.0 * std::pow(2.0, static_cast<double>(i / 3 % 4));
    record.immersion = Immersion::slot;
    return record;
}

/// N: Ft = K MRR / v by hand, K in J/mm³ (W = 1000 N·mm/s).
inline double tangentialForce(const ForceRecord& record, double specificEnergy) {
    const double rate = record.axialDepth * record.radialDepth * record.feed / 60.0; // mm³/s
    const double edgeSpeed = pi * record.diameter * record.spindleSpeed / 60.0;      // mm/s
    return specificEnergy * rate / (edgeSpeed / 1000.0);
}

/// A material with edge forces: N/mm², N/mm (shear and edge coefficients as defined by Altintas).
struct ShearAndEdge {
    double tangentialShear = 0.0, tangentialEdge = 0.0, radialShear = 0.0, radialEdge = 0.0;
};

/// Mean force on the tool over a revolution, tooth by tooth in small steps of time: straight teeth, clockwise spindle.
inline glm::dvec3 forceOfTurningTeeth(const ForceRecord& record, const ShearAndEdge& of) {
    const int steps = 20'000;
    const glm::dvec3 feed = record.feedDirection, axis = record.axis;
    const double fz = record.feed / (record.spindleSpeed * record.teeth), radius = 0.5 * record.diameter;
    glm::dvec3 sum(0.0);
    for (int step = 0; step < steps; ++step)
        for (int tooth = 0; tooth < record.teeth; ++tooth) {
            const double angle = -2.0 * pi * ((step + 0.5) / steps + static_cast<double>(tooth) / record.teeth);
            // Rotated about the axis; a negative angle is clockwise, seen from the holder.
            const glm::dvec3 out = std::cos(angle) * feed + std::sin(angle) * glm::cross(axis, feed);
            const glm::dvec3 velocity = -glm::cross(axis, out);
            const double ahead = glm::dot(out, feed), side = glm::dot(out, glm::cross(axis, feed)) * radius;
            // There is material ahead of the axis: over the whole width, or in a band on the left (up) or the right
            // (down).
            const double depthFromLeft = radius - side, depthFromRight = radius + side;
            const bool inBand = record.immersion == Immersion::down ? depthFromRight <= record.radialDepth
                                                                    : depthFromLeft <= record.radialDepth;
            if (ahead <= 0.0 || !inBand) continue;
            const double chip = fz * ahead;
            sum -= record.axialDepth * ((of.tangentialShear * chip + of.tangentialEdge) * velocity +
                                        (of.radialShear * chip + of.radialEdge) * out);
        }
    return sum / static_cast<double>(steps);
}

} // namespace burin::tests
