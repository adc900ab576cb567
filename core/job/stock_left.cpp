// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/stock_left.h"

#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/geometry/arc.h"
#include "core/geometry/upright.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double placeCount = 20'000.0;
constexpr double apart = 0.1;      // mm between tips of a move
constexpr double square = 1.0;     // mm, cell of the raster in plan view
constexpr double farthest = 10.0;  // mm: largest stock left that is measured
constexpr double touching = 0.01;  // mm: a tip that is this deep in the mesh touches the part
constexpr double flattened = 1e-3; // of a unit normal's length in plan view: below it the face is horizontal
constexpr int aroundAxis = 8;      // tips that are tried on a horizontal face

std::int64_t squareAt(double value) noexcept {
    return static_cast<std::int64_t>(std::floor(value / square));
}

/// Returns the ring of a tool that is farthest in the direction opposite to a normal.
ProfilePoint contactOf(std::span<const RevolvedPiece> flutes, const glm::dvec3& normal) noexcept {
    constexpr double leastUpwards = 1e-6; // a vertical side touches with its lowest ring
    const double sidewards = glm::length(glm::dvec2(normal)), upwards = std::max(normal.z, leastUpwards);
    ProfilePoint farthestRing;
    double most = -std::numeric_limits<double>::infinity();
    for (const RevolvedPiece& piece : flutes) {
        const ProfilePoint ring = farthestIn(piece, sidewards, -upwards);
        const double far = ring.radius * sidewards - ring.height * upwards;
        if (far <= most) continue;
        most = far;
        farthestRing = ring;
    }
    return farthestRing;
}

/// Returns the tip positions at which an upright tool touches a point of a face.
std::vector<glm::dvec3> touchingTips(std::span<const RevolvedPiece> flutes, const glm::dvec3& point,
                                     const glm::dvec3& normal) {
    const double sidewards = glm::length(glm::dvec2(normal));
    const ProfilePoint ring = contactOf(flutes, normal);
    if (sidewards > flattened) return {point + glm::dvec3(ring.radius * glm::dvec2(normal) / sidewards, -ring.height)};
    std::vector<glm::dvec3> tips{point - glm::dvec3(0.0, 0.0, ring.height)};
    for (int i = 0; i < aroundAxis && ring.radius > 0.0; ++i) {
        const double angle = 2.0 * pi * i / aroundAxis;
        tips.push_back(tips.front() + 0.98 * ring.radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
    }
    return tips;
}

} // namespace

StockLeftMeter::StockLeftMeter(const MeshDistance& part, const Box& stock) : part_(part) {
    double area = 0.0;
    const auto upwards = [](const glm::dvec3& normal) { return normal.z > -1e-6 * glm::length(normal); };
    for (const Triangle& triangle : part.triangles())
        if (const glm::dvec3 normal = areaNormal(triangle); upwards(normal)) area += 0.5 * glm::length(normal);
    areaOfPlace_ = area / placeCount;
    if (!(areaOfPlace_ > 0.0)) return;
    double passed = 0.5 * areaOfPlace_; // mm², remaining area until the next point
    std::uint32_t number = 0;
    for (const Triangle& triangle : part.triangles()) {
        const glm::dvec3 normal = areaNormal(triangle);
        const double length = glm::length(normal);
        if (!upwards(normal) || !(length > 0.0)) continue;
        for (passed -= 0.5 * length; passed < 0.0; passed += areaOfPlace_, ++number) {
            // A low-discrepancy sequence (based on the plastic number) in the square, folded onto the triangle.
            glm::dvec2 share =
                glm::fract(static_cast<double>(number) * glm::dvec2(0.7548776662466927, 0.5698402909980532));
            if (share.x + share.y > 1.0) share = 1.0 - share;
            const glm::dvec3 point =
                triangle[0] + share.x * (triangle[1] - triangle[0]) + share.y * (triangle[2] - triangle[0]);
            squares_[squareOf(squareAt(point.x), squareAt(point.y))].push_back(
                static_cast<std::uint32_t>(places_.size()));
            const glm::dvec3 inside = glm::min(point - stock.low, stock.high - point);
            const double depth = std::max(0.0, std::min({inside.x, inside.y, stock.high.z - point.z}));
            places_.push_back({point, normal / length, std::min(depth, farthest)});
        }
    }
}

void StockLeftMeter::sweepTo(const glm::dvec3& tip, std::span<const RevolvedPiece> flutes, double widest,
                             const HollowSpace& hollow) {
    const double reach = widest + square;
    for (std::int64_t row = squareAt(tip.y - reach); row <= squareAt(tip.y + reach); ++row)
        for (std::int64_t column = squareAt(tip.x - reach); column <= squareAt(tip.x + reach); ++column) {
            const auto found = squares_.find(squareOf(column, row));
            if (found == squares_.end()) continue;
            for (const std::uint32_t i : found->second) {
                Place& place = places_[i];
                const double radius = glm::distance(glm::dvec2(place.point), glm::dvec2(tip));
                const double height = place.point.z - tip.z;
                if (radius > widest + place.left || height < -place.left) continue;
                if (radius < hollow.radius && height < hollow.height) continue;
                for (const RevolvedPiece& piece : flutes)
                    place.left = std::min(place.left, std::max(0.0, signedDistance(piece, radius, height)));
            }
        }
}

void StockLeftMeter::sweep(std::span<const PathPoint> points, std::size_t from, std::size_t to, const Tool& tool,
                           const Progress& progress) {
    if (!tool.cutter.turns()) return; // it clears less than its profile
    const std::vector<RevolvedPiece> flutes = flutePieces(tool.cutter);
    const HollowSpace hollow = tool.cutter.hollow();
    double widest = 0.0;
    for (const RevolvedPiece& piece : flutes) widest = std::max(widest, piece.widestRadius());
    for (std::size_t i = from; i <= to && i < points.size() && !progress.cancelled(); ++i) {
        const PathPoint& point = points[i];
        if (point.kind == MoveKind::rapid) continue;
        const glm::dvec3 start = points[i - 1].pose.tip, end = point.pose.tip;
        const int steps = std::max(1, static_cast<int>(std::ceil(lengthOf(start, point) / apart)));
        if (point.arc) {
            const Arc arc{start, end, point.arc->centre, point.arc->axis, point.arc->clockwise};
            const ArcTurn turn = turnOf(arc);
            for (int k = 0; k <= steps; ++k)
                sweepTo(placeOn(arc, turn, static_cast<double>(k) / steps), flutes, widest, hollow);
        } else {
            for (int k = 0; k <= steps; ++k)
                sweepTo(glm::mix(start, end, static_cast<double>(k) / steps), flutes, widest, hollow);
        }
    }
}

StockLeft StockLeftMeter::leftBy(const PassRequest& request, const Tool& tool, const Progress& progress) const {
    const std::vector<RevolvedPiece> flutes = flutePieces(tool.cutter), whole = pieces(tool.cutter);
    const Box part = part_.bounds();
    const double lowest = request.bottom.value_or(request.kind == PassKind::face ? part.high.z : part.low.z) - touching;
    std::vector<char> counts(places_.size(), 0);
    parallelFor(std::size_t{0}, places_.size(), [&](std::size_t i) {
        const Place& place = places_[i];
        if (progress.cancelled() || !request.allowsSlope(place.normal)) return;
        for (const glm::dvec3& tip : touchingTips(flutes, place.point, place.normal)) {
            const glm::dvec2 meant(request.areaOnPart ? place.point : tip);
            if (tip.z < lowest || (!request.area.empty() && !holds(request.area, meant))) continue;
            if (part_.clearance(whole, {tip, uprightAxis}, 1.0, touching).clearance < -touching) continue;
            counts[i] = 1;
            return;
        }
    });
    std::vector<double> left;
    for (std::size_t i = 0; i < places_.size(); ++i)
        if (counts[i]) left.push_back(places_[i].left);
    if (left.empty()) return {};
    std::ranges::sort(left);
    const auto at99 = static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(left.size()))) - 1;
    return {static_cast<double>(left.size()) * areaOfPlace_, left[at99], left.back()};
}

} // namespace burin
