// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/calibration_fit.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double leastAcross = 0.17; // share of the feed perpendicular to the axis: 10 degrees from the axis

/// The engaged arc of the teeth: angles from the left of the feed, clockwise like the rotation of the teeth; the feed
/// direction is at pi / 2.
struct Arc {
    double from = 0.0, to = 0.0;
};

Arc engagedArc(const ForceRecord& record) {
    const double arc = std::acos(std::clamp(1.0 - 2.0 * record.radialDepth / record.diameter, -1.0, 1.0));
    return record.immersion == Immersion::down ? Arc{pi - arc, pi} : Arc{0.0, arc};
}

/// A tooth at angle a is at r = cos a · left + sin a · feed, moves along t = cos a · feed - sin a · left, has a chip of
/// fz sin a, and feels -Kt h t - Kr h r. Over the arc, with S and C the integrals of sin² and sin cos, the mean force
/// has -(Kt C + Kr S) along the feed and Kt S - Kr C to the left, times teeth · depth · fz / 2 pi: two equations for
/// two unknowns, never singular as S > 0.
void resolveTeeth(const ForceRecord& record, const glm::dvec3& force, const glm::dvec3& feed,
                  ForceObservation& observation) {
    const Arc arc = engagedArc(record);
    const double sineSine = 0.5 * (arc.to - arc.from) - 0.25 * (std::sin(2.0 * arc.to) - std::sin(2.0 * arc.from));
    const double sineCosine = 0.25 * (std::cos(2.0 * arc.from) - std::cos(2.0 * arc.to));
    const double sine = std::cos(arc.from) - std::cos(arc.to);
    const glm::dvec3 left = glm::cross(record.axis, feed);
    const double againstFeed = -glm::dot(force, feed), toTheRight = -glm::dot(force, left);
    const double size = sineSine * sineSine + sineCosine * sineCosine;
    // For the sum of the teeth's forces, the integral of sin replaces the two.
    observation.tangential = (sineCosine * againstFeed - sineSine * toTheRight) / size * sine;
    observation.radial = (sineSine * againstFeed + sineCosine * toTheRight) / size * sine;
    observation.gain = sine / std::sqrt(size);
    const double cosine = std::sin(arc.to) - std::sin(arc.from);
    const double perTurn = record.teeth * record.axialDepth / (2.0 * pi);
    observation.force = {againstFeed, toTheRight};
    observation.ofChip = perTurn * record.feedPerTooth() * std::complex(sineCosine, -sineSine);
    observation.ofEdge = perTurn * std::complex(cosine, -sine);
}

} // namespace

std::string observe(const ForceRecord& record, const CalibrationOptions& options, ForceObservation& observation) {
    const double rate = record.removalRate();
    if (!(rate > 0.0) || !(record.radialDepth > 0.0) || !(record.feed > 0.0)) return "nothing was removed";
    const glm::dvec3 across = record.feedDirection - glm::dot(record.feedDirection, record.axis) * record.axis;
    if (glm::length(across) < leastAcross) return "the feed is along the tool axis";
    const glm::dvec3 force = options.forcesOnWorkpiece ? -record.force : record.force;
    const glm::dvec3 feed = glm::normalize(across);
    observation.line = record.line;
    observation.drive = newtonMillimetresPerJoule * rate / record.toolEdgeSpeed();
    observation.chip = record.meanChipThickness();
    if (options.projection == ForceProjection::feedAndAxis) {
        observation.tangential = -glm::dot(force, feed);
        observation.radial = glm::dot(force, record.axis);
        observation.gain = 1.0;
        observation.force = {observation.tangential, observation.radial};
        observation.ofChip = observation.drive / newtonMillimetresPerJoule;
        const Arc arc = engagedArc(record);
        observation.ofEdge = record.teeth * record.axialDepth * (arc.to - arc.from) / (2.0 * pi);
        return {};
    }
    if (record.immersion == Immersion::unknown) return "the column immersion does not say up or down";
    resolveTeeth(record, force, feed, observation);
    return {};
}

} // namespace burin
