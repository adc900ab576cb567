// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/touched_stock.h"

#include "core/base/numbers.h"
#include "core/geometry/upright.h"
#include "core/haptics/boundary/mesh_boundary.h"
#include "core/haptics/boundary/proxy.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double pressed = 1.0;                          // mm that the hand goes on after the contact
constexpr double leastStride = 0.1, largestStride = 1.0; // mm of the hand between two positions

/// mm: how far from the side of the stock a tool that touches it may be found, at most; of a round bar, how far a face
/// within the alignment of touchedFace lies below its outermost line. Anything farther is another body, as a fixture
/// that the tool is pushed against while it stands on the stock.
double besideSide(const Setup& setup) {
    constexpr double found = 0.02;
    return setup.form == StockForm::cylinder ? cylinderChord + 0.001 * setup.cylinder.radius : found;
}

std::string textOf(const glm::dvec3& place) {
    return formatShortest(place.x) + "," + formatShortest(place.y) + "," + formatShortest(place.z);
}

Error refused(const glm::dvec3& tip, const char* needed) {
    return {ErrorCode::argumentInvalid, "touch", textOf(tip), needed};
}

} // namespace

std::optional<Obstacle> touchableStock(const Setup& setup) {
    if (setup.form == StockForm::box) return Obstacle{"stock", setup.stock};
    if (setup.form == StockForm::cylinder) return Obstacle{"stock", setup.cylinder};
    return std::nullopt;
}

std::optional<double> sideTouched(const Setup& setup, const TouchedFace& face) {
    const double side = (face.high ? setup.stock.high : setup.stock.low)[face.axis];
    if (!(std::abs(face.place[face.axis] - side) <= besideSide(setup))) return std::nullopt;
    return side;
}

Result<TouchedFace> touchStock(const Setup& setup, const Tool& tool, const glm::dvec3& tip, const glm::dvec3& towards) {
    const std::optional<Obstacle> stock = touchableStock(setup);
    if (!stock) return Error{ErrorCode::notSupported, "touch", "a stock that is a box or a cylinder", {}};
    MeshBoundary boundary(std::make_shared<const MeshDistance>(meshOf(*stock)), pieces(tool.cutter), setup.voxel);
    const Proxy proxy(boundary);
    ToolPose pose{tip, uprightAxis};
    if (!proxy.feasible(pose)) return refused(tip, "a tip from which the tool is clear of the stock");
    const double end = glm::distance(tip, setup.stock.centre()) + glm::length(setup.stock.size()) +
                       tool.cutter.length() + tool.cutter.diameter;
    glm::dvec3 hand = tip;
    for (double travel = 0.0; travel < end;) {
        ProxyStride stride;
        stride.travel = std::clamp(boundary.at(pose, largestStride).clearance, leastStride, largestStride);
        travel += stride.travel;
        hand += stride.travel * towards;
        const ProxyStep step = proxy.advance(pose, {hand, uprightAxis}, stride);
        pose = step.pose;
        if (!step.onBoundary || glm::distance(hand, pose.tip) < pressed) continue;
        Sample sample;
        sample.proxy = pose;
        sample.stylusTip = hand;
        return touchedFace(sample, tool, 0.0);
    }
    return refused(tip, "a tip from which the tool meets the stock in this direction");
}

} // namespace burin
