// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/touched_face.h"

#include "core/geometry/frame_along.h"

#include <cmath>

namespace burin {

namespace {

constexpr double leastPush = 0.02;       // mm that the hand is beyond the tool: much more than the loop's rounding
constexpr double leastAlignment = 0.999; // of a unit normal: 2.6 degrees, the error of a plane in a field of voxels

/// mm above the tip: where a ball or a rounded edge reaches the radius of the cutter.
double heightOfRadius(const Cutter& cutter) {
    switch (cutter.type) {
    case CutterType::ball:
    case CutterType::lollipop:
        return cutter.radius();
    case CutterType::bullNose:
        return cutter.cornerRadius;
    default:
        return 0.0;
    }
}

} // namespace

TouchedFace touchedFace(const Sample& sample, const Tool& tool, double allowance) {
    const glm::dvec3 push = sample.proxy.tip - sample.stylusTip;
    const double depth = glm::length(push);
    if (!(depth > leastPush)) return {};
    TouchedFace face;
    face.outcome = TouchedFace::Outcome::aslant;
    face.axis = nearestAxis(push);
    const double along = push[face.axis] / depth;
    const bool upright = sample.proxy.axis.z > leastAlignment;
    if (!upright || std::abs(along) < leastAlignment || (face.axis == 2 && along < 0.0)) return face;
    face.outcome = TouchedFace::Outcome::found;
    face.high = along > 0.0;
    face.tip = face.place = sample.proxy.tip;
    const double reach = (face.axis == 2 ? 0.0 : tool.cutter.radius()) + allowance;
    if (face.axis != 2) face.place.z += heightOfRadius(tool.cutter);
    face.place[face.axis] -= std::copysign(reach, along);
    return face;
}

} // namespace burin
