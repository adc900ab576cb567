// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/touched_stock.h"

#include "core/base/numbers.h"
#include "core/exchange/volume_surface.h"
#include "core/geometry/upright.h"
#include "core/haptics/boundary/mesh_boundary.h"
#include "core/haptics/boundary/proxy.h"
#include "core/setup/obstacle.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {

namespace {

constexpr double pressed = 1.0;                          // mm that the hand goes on after the contact
constexpr double leastStride = 0.1, largestStride = 1.0; // mm of the hand between two positions

/// mm: how far from the side of the stock a tool that touches it may be found, at most. Anything farther is another
/// body, as a fixture that the tool is pushed against while it stands on the stock.
constexpr double besidePlane = 0.02;
/// Of the radius of a round side: how far a face within the alignment of touchedFace lies below its outermost line.
constexpr double besideRound = 0.001;

constexpr double surfaceTolerance = 0.1; // voxels by which the surface of a stock from a file is simplified
constexpr int flankLevels = 32;          // heights at which a side is looked for along the flutes
constexpr double squareWithin = 1e-9;    // of 1 - cos: a plane side; any other is curved, or leans
constexpr double squareTouch = 0.99;     // cos between the side's axis and the direction in which the stock holds
constexpr double contactWithin = 0.01;   // mm of clearance, at most
constexpr double atPoint = 1e-6;         // mm from a point of the surface to the triangles that contain it

std::string textOf(const glm::dvec3& place) {
    return formatShortest(place.x) + "," + formatShortest(place.y) + "," + formatShortest(place.z);
}

Error refused(const glm::dvec3& tip, const char* needed) {
    return {ErrorCode::argumentInvalid, "touch", textOf(tip), needed};
}

glm::dvec3 outwardOf(const TouchedFace& face) noexcept {
    glm::dvec3 outward(0.0);
    outward[face.axis] = face.high ? 1.0 : -1.0;
    return outward;
}

/// Whether a point of a surface is on a plane square to an axis. On an edge any of the faces that meet there may be it.
bool isOnPlaneSide(const MeshDistance& surface, const glm::dvec3& point, int axis) {
    std::vector<std::uint32_t> numbers;
    surface.trianglesNear(point, atPoint, numbers);
    return std::ranges::any_of(numbers, [&](std::uint32_t number) {
        return std::abs(unitNormal(surface.triangles()[number])[axis]) > 1.0 - squareWithin;
    });
}

} // namespace

Result<TouchableStock> TouchableStock::of(const Model& model, const Setup& setup, Progress& progress) {
    TouchableStock stock;
    stock.form_ = setup.form;
    stock.box_ = setup.stock;
    stock.voxel_ = setup.voxel;
    if (setup.form == StockForm::box || setup.form == StockForm::cylinder) {
        stock.radius_ = setup.cylinder.radius;
        const Obstacle shape =
            setup.form == StockForm::box ? Obstacle{"stock", setup.stock} : Obstacle{"stock", setup.cylinder};
        stock.surface_ = std::make_shared<const MeshDistance>(meshOf(shape));
        return stock;
    }
    Result<StockSolid> solid = StockSolid::of(model, setup, progress);
    if (!solid) return std::move(solid).error();
    stock.solid_ = *std::move(solid);
    stock.surface_ = stock.solid_.surface();
    stock.chord_ = model.meshChord;
    if (stock.solid_.runs()) {
        stock.voxel_ = stock.solid_.runs()->grid().edge();
        const Result<VolumeSurface> surface =
            surfaceOf(*stock.solid_.runs(), surfaceTolerance * stock.voxel_, progress);
        if (!surface) return surface.error();
        stock.surface_ = std::make_shared<const MeshDistance>(surface->mesh);
    }
    if (!stock.surface_) return Error{ErrorCode::notSupported, "touch", "a stock with a surface", {}};
    return stock;
}

/// mm from the contact of a tool to the side that it touches, at most.
double TouchableStock::slack(const Tool& tool) const noexcept {
    if (form_ == StockForm::cylinder) return cylinderChord + besideRound * radius_;
    if (form_ == StockForm::file) return voxel_;
    return form_ == StockForm::solids ? besidePlane + besideRound * tool.cutter.radius() : besidePlane;
}

std::optional<TouchedSide> TouchableStock::sideOfBox(const TouchedFace& face, double slack) const {
    const double side = (face.high ? box_.high : box_.low)[face.axis];
    if (!(std::abs(face.place[face.axis] - side) <= slack)) return std::nullopt;
    return TouchedSide{side, 0.0};
}

/// By the voxels that are opposite the contact, or on the line along which the flank touches a side.
std::optional<double> TouchableStock::sideOfVoxels(const TouchedFace& face, const Tool& tool,
                                                   const glm::dvec3& contact) const {
    const glm::dvec3 outward = outwardOf(face);
    const double flank = face.axis == 2 ? 0.0 : tool.cutter.fluteLength;
    std::optional<double> outermost; // mm along `outward`
    const auto look = [&](glm::dvec3 from) {
        from[face.axis] = face.place[face.axis];
        const std::optional<glm::dvec3> hit = solid_.hit(from + 2.0 * voxel_ * outward, -outward);
        if (hit) outermost = std::max(outermost.value_or(-1e300), glm::dot(*hit, outward));
    };
    look(contact);
    for (int level = 0; level <= flankLevels; ++level)
        look(face.place + glm::dvec3(0.0, 0.0, flank * level / flankLevels));
    return outermost ? std::optional(face.high ? *outermost : -*outermost) : std::nullopt;
}

std::optional<TouchedSide> TouchableStock::sideTouched(const TouchedFace& face, const Tool& tool) const {
    if (face.outcome != TouchedFace::Outcome::found) return std::nullopt;
    const double near = slack(tool);
    if (form_ == StockForm::box || form_ == StockForm::cylinder) return sideOfBox(face, near);
    const ToolClearance contact = surface_->clearance(pieces(tool.cutter), {face.tip, uprightAxis}, near);
    if (!(contact.clearance < std::min(near, contactWithin)) || glm::dot(contact.away, outwardOf(face)) < squareTouch)
        return std::nullopt;
    const std::optional<double> side = form_ == StockForm::file ? sideOfVoxels(face, tool, contact.meshPoint)
                                                                : std::optional(contact.meshPoint[face.axis]);
    if (!side || !(std::abs(*side - face.place[face.axis]) <= near)) return std::nullopt;
    if (form_ == StockForm::file) return TouchedSide{*side, 0.5 * voxel_};
    return TouchedSide{*side, isOnPlaneSide(*surface_, contact.meshPoint, face.axis) ? 0.0 : chord_};
}

Result<TouchedFace> touchStock(const TouchableStock& stock, const Tool& tool, const glm::dvec3& tip,
                               const glm::dvec3& towards) {
    MeshBoundary boundary(stock.surface(), pieces(tool.cutter), stock.voxel());
    const Proxy proxy(boundary);
    ToolPose pose{tip, uprightAxis};
    if (!proxy.feasible(pose)) return refused(tip, "a tip from which the tool is clear of the stock");
    const double end = glm::distance(tip, stock.box().centre()) + glm::length(stock.box().size()) +
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
