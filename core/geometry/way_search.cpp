// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/way_search.h"

#include "core/geometry/convex_minimum.h"
#include "core/geometry/piece_minimum.h"
#include "core/geometry/triangle_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

/// The nearest position of a move and the nearest point of a triangle, found in turn, converge slowly where both are
/// level.
constexpr int mostTurns = 12;

/// Lower bounds of the distance from a straight move to boxes and plates: by its tangent at the middle of each box.
class NearWay {
public:
    /// @param distance  only what is nearer counts, mm
    NearWay(const TriangleTree& tree, const glm::dvec3& from, const glm::dvec3& to, double distance) noexcept
        : distance_(static_cast<float>(distance) * (1.0F + 1e-6F)) {
        const glm::dvec3 start = from - tree.origin(), end = to - tree.origin(), way = end - start;
        const double length = glm::length(way);
        length_ = FourFloats{} + static_cast<float>(length);
        for (int axis = 0; axis < 3; ++axis) {
            const auto place = static_cast<std::size_t>(axis);
            at_[place] = FourFloats{} + static_cast<float>(start[axis]);
            along_[place] = FourFloats{} + static_cast<float>(length > 0.0 ? way[axis] / length : 0.0);
            low_[place] = FourFloats{} + static_cast<float>(std::min(start[axis], end[axis]) - distance);
            high_[place] = FourFloats{} + static_cast<float>(std::max(start[axis], end[axis]) + distance);
        }
        // Single precision represents coordinates to a few units of the seventh digit of the greatest of them.
        const glm::dvec3 far = glm::max(glm::abs(start), glm::abs(end));
        slack_ = 1e-6F * static_cast<float>(std::max({far.x, far.y, far.z}) + length + distance);
    }
    bool stillBelow(float bound) const noexcept { return bound < distance_; }
    /// Ends the search: nothing is near enough any more.
    void stop() noexcept { distance_ = -std::numeric_limits<float>::infinity(); }

    ChildBounds of(const TreeNode& node) const noexcept {
        const FourFloats zero{};
        FourFloats gap = zero - 1.0F, share{};
        std::array<FourFloats, 3> way, half;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const FourFloats low = fourAt(node.low[axis].data()), high = fourAt(node.high[axis].data());
            gap = greater(gap, greater(low - high_[axis], low_[axis] - high));
            half[axis] = 0.5F * (high - low);
            way[axis] = 0.5F * (low + high) - at_[axis];
            share += way[axis] * along_[axis];
        }
        share = greater(share, zero);
        share = share < length_ ? share : length_;
        FourFloats squared{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            way[axis] -= share * along_[axis];
            squared += way[axis] * way[axis];
        }
        const FourFloats one = zero + 1.0F, distance = rootsOf(squared);
        const FourFloats inverse = one / greater(distance, zero + 1e-6F);
        std::array<FourFloats, 3> normal;
        FourFloats overBox{}, along{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            way[axis] *= inverse; // the slope from here on
            normal[axis] = fourAt(node.normal[axis].data());
            overBox += absolute(way[axis]) * half[axis];
            along += way[axis] * normal[axis];
        }
        const FourFloats radius = fourAt(node.radius.data());
        const FourFloats thickness = along > 0.0F ? fourAt(node.below.data()) : fourAt(node.above.data());
        const FourFloats overPlate = partAcross(way, normal, along) * radius - along * thickness;
        // The nearest position of the move is known to `slack_`, and moves no farther than the point.
        const FourFloats bound =
            distance - (overBox < overPlate ? overBox : overPlate) - slack_ * (one + radius * inverse) - 1e-6F * radius;
        const FourFloats infinite = zero + std::numeric_limits<float>::infinity();
        ChildBounds bounds;
        put(gap > slack_ ? infinite : bound, bounds.data());
        return bounds;
    }

private:
    std::array<FourFloats, 3> at_, along_, low_, high_;
    FourFloats length_;
    float distance_, slack_ = 0.0F;
};

/// Whether a whole move keeps this distance from a triangle's plane, on one side of it.
bool keepsFromPlane(const Triangle& triangle, const glm::dvec3& from, const glm::dvec3& to, double distance) noexcept {
    const glm::dvec3 normal = areaNormal(triangle);
    const double start = glm::dot(normal, from - triangle[0]), end = glm::dot(normal, to - triangle[0]);
    const double nearer = start > 0.0 ? std::min(start, end) : -std::max(start, end);
    return nearer > 0.0 && nearer * nearer >= distance * distance * glm::dot(normal, normal);
}

/// The distance of a triangle from a point on a straight move is convex along the move: returns the least one, or some
/// value that is not below `cutoff`.
double distanceOfWay(const Triangle& triangle, const glm::dvec3& from, const glm::dvec3& to, double cutoff) noexcept {
    if (keepsFromPlane(triangle, from, to, cutoff)) return cutoff; // most do, and the test is fast
    const glm::dvec3 way = to - from;
    const auto at = [&](double share) noexcept -> LineValue {
        const glm::dvec3 place = from + share * way;
        const glm::dvec3 apart = place - closestOnTriangle(triangle, place).point;
        const double distance = glm::length(apart);
        return {distance, distance > 0.0 ? glm::dot(apart, way) / distance : 0.0};
    };
    return minimumOnLine(at, 0.0, 1.0, cutoff, 2e-9).value;
}

bool ballKeepsFromMesh(const TriangleTree& tree, const glm::dvec3& from, const glm::dvec3& to,
                       double distance) noexcept {
    if (!(distance > 0.0)) return true;
    NearWay near(tree, from, to, distance);
    bool keeps = true;
    walk(tree, near, [&](std::size_t slot) noexcept {
        if (!keeps || distanceOfWay(tree.triangles()[slot], from, to, distance) >= distance) return;
        keeps = false;
        near.stop();
    });
    return keeps;
}

/// A piece during its move. Evaluated only for what lies above a height over the tip.
class MovingPiece {
public:
    MovingPiece(const RevolvedPiece& piece, const glm::dvec3& axis, const glm::dvec3& from, const glm::dvec3& to,
                double floor) noexcept
        : piece_(piece)
        , axis_(axis)
        , from_(from)
        , way_(to - from)
        , square_(glm::dot(way_, way_))
        , floor_(floor > piece.bottom ? floor + std::min(0.0, glm::dot(way_, axis))
                                      : -std::numeric_limits<double>::infinity())
        , lowest_(piece.bulges() ? std::clamp(piece.bulgeCentreHeight, piece.bottom, piece.top)
                                 : piece.bottom + piece.cornerRadius) {}

    PlacedPiece at(double share) const noexcept { return PlacedPiece(piece_, {from_ + share * way_, axis_}); }
    /// The share of the move at which the piece comes nearest to a point, to 1e-9 mm of distance.
    double nearestShare(const glm::dvec3& point) const noexcept {
        const auto along = [&](double share) noexcept -> LineValue {
            const PlacedPiece::Value there = at(share).at(point);
            return {there.distance, -glm::dot(there.gradient, way_)};
        };
        return minimumOnLine(along, 0.0, 1.0, std::numeric_limits<double>::infinity(), 1e-9).place;
    }
    /// A plane that the signed distance at all positions of the move stays above. Any share is valid; the plane is
    /// highest for the share at which the piece is nearest.
    PlacedPiece::Value tangentAt(const glm::dvec3& point, double share) const noexcept {
        PlacedPiece::Value value = at(share).at(point);
        const double slope = glm::dot(value.gradient, way_);
        value.distance -= std::max((1.0 - share) * slope, -share * slope);
        return value;
    }
    /// The same with a share that is fast to compute.
    PlacedPiece::Value tangentAt(const glm::dvec3& point) const noexcept { return tangentAt(point, shareNear(point)); }

    bool isBelowFloor(const glm::dvec3& point, double up) const noexcept {
        return glm::dot(point - from_, axis_) + up < floor_;
    }
    const glm::dvec3& axis() const noexcept { return axis_; }

    /// The box of everything that the piece's part above the floor passes through.
    Box bounds(double floor) const noexcept {
        Box box;
        const double radius = piece_.widestRadius();
        for (const double share : {0.0, 1.0})
            for (const double height : {std::max(floor, piece_.bottom), piece_.top}) {
                const glm::dvec3 centre = from_ + share * way_ + height * axis_;
                const glm::dvec3 across = radius * glm::sqrt(glm::max(glm::dvec3(0.0), 1.0 - axis_ * axis_));
                box.include(centre - across);
                box.include(centre + across);
            }
        return box;
    }

private:
    /// As if the piece were the sphere about the point of its axis that is level with the given point.
    double shareNear(const glm::dvec3& point) const noexcept {
        if (!(square_ > 0.0)) return 0.0;
        const double height =
            std::clamp(glm::dot(point - from_ - 0.5 * way_, axis_), std::min(lowest_, piece_.top), piece_.top);
        return std::clamp(glm::dot(point - from_ - height * axis_, way_) / square_, 0.0, 1.0);
    }
    const RevolvedPiece& piece_;
    glm::dvec3 axis_, from_, way_;
    double square_, floor_, lowest_;
};

/// Lower bounds of a moving piece's signed distance over boxes and plates.
class NearMovingPiece {
public:
    NearMovingPiece(const TriangleTree& tree, const MovingPiece& piece, double floor, double clearance) noexcept
        : piece_(piece), origin_(tree.origin()), clearance_(clearance) {
        const Box box = piece.bounds(floor);
        const double reach = std::max(clearance, 0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const double low = box.low[axis] - origin_[axis] - reach, high = box.high[axis] - origin_[axis] + reach;
            const double slack = 1e-9 + 2.4e-7 * std::max(std::abs(low), std::abs(high));
            low_[static_cast<std::size_t>(axis)] = FourFloats{} + static_cast<float>(low - slack);
            high_[static_cast<std::size_t>(axis)] = FourFloats{} + static_cast<float>(high + slack);
        }
    }
    bool stillBelow(float bound) const noexcept { return static_cast<double>(bound) < clearance_; }
    void stop() noexcept { clearance_ = -std::numeric_limits<double>::infinity(); }

    ChildBounds of(const TreeNode& node) const noexcept {
        FourFloats gap = FourFloats{} - 1.0F;
        for (std::size_t axis = 0; axis < 3; ++axis)
            gap = greater(
                gap, greater(fourAt(node.low[axis].data()) - high_[axis], low_[axis] - fourAt(node.high[axis].data())));
        ChildBounds bounds, gaps;
        put(gap, gaps.data());
        bounds.fill(std::numeric_limits<float>::infinity());
        for (std::size_t child = 0; child < TreeNode::width; ++child)
            if (!(gaps[child] > 0.0F)) bounds[child] = tangentBound(node, child);
        return bounds;
    }

private:
    float tangentBound(const TreeNode& node, std::size_t child) const noexcept {
        const glm::dvec3 centre = boxCentre(node, child), point = centre + origin_;
        const glm::dvec3 half = glm::dvec3(node.high[0][child], node.high[1][child], node.high[2][child]) - centre;
        if (piece_.isBelowFloor(point, glm::dot(glm::abs(piece_.axis()), half)))
            return std::numeric_limits<float>::infinity();
        const PlacedPiece::Value tangent = piece_.tangentAt(point);
        const double bound = tangent.distance - std::min(glm::dot(glm::abs(tangent.gradient), half),
                                                         fallOverPlate(node, child, tangent.gradient));
        return static_cast<float>(bound - 1e-9 - 1.2e-7 * std::abs(bound));
    }

    const MovingPiece& piece_;
    glm::dvec3 origin_;
    double clearance_;
    std::array<FourFloats, 3> low_, high_;
};

/// By the tangent at the triangle's middle, otherwise by those where piece and triangle are nearest to each other.
bool keepsFromTriangle(const MovingPiece& piece, const Triangle& triangle, double clearance) noexcept {
    const auto isShown = [&](const glm::dvec3& point, const PlacedPiece::Value& tangent) {
        const double fall =
            std::min({glm::dot(tangent.gradient, triangle[0] - point), glm::dot(tangent.gradient, triangle[1] - point),
                      glm::dot(tangent.gradient, triangle[2] - point)});
        return tangent.distance + fall >= clearance;
    };
    glm::dvec3 point = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    if (isShown(point, piece.tangentAt(point))) return true;
    double share = piece.nearestShare(point);
    for (int turn = 0; turn < mostTurns; ++turn) {
        const std::optional<PieceMinimum> least =
            minimumOverTriangle(piece.at(share), triangle, std::numeric_limits<double>::infinity());
        if (!least || least->distance < clearance) return false;
        point = least->point;
        share = piece.nearestShare(point);
        if (isShown(point, piece.tangentAt(point, share))) return true;
    }
    return false;
}

} // namespace

bool keepsFromMesh(const TriangleTree& tree, const RevolvedPiece& piece, const glm::dvec3& axis, const glm::dvec3& from,
                   const glm::dvec3& to, double clearance) noexcept {
    double floor = piece.bottom;
    if (PlacedPiece(piece, {from, axis}).ballEnd() && piece.top >= floor + 2.0 * piece.cornerRadius) {
        floor += piece.cornerRadius; // what lies below is as near to the ball, which is faster to evaluate, as to the
                                     // piece
        if (!ballKeepsFromMesh(tree, from + floor * axis, to + floor * axis, piece.cornerRadius + clearance))
            return false;
    }
    const MovingPiece moving(piece, axis, from, to, floor);
    NearMovingPiece near(tree, moving, floor, clearance);
    bool keeps = true;
    walk(tree, near, [&](std::size_t slot) noexcept {
        if (!keeps || keepsFromTriangle(moving, tree.triangles()[slot], clearance)) return;
        keeps = false;
        near.stop();
    });
    return keeps;
}

EndSpheres endSpheres(const RevolvedPiece& piece) noexcept {
    const double most = std::min(piece.widestRadius(), 0.5 * (piece.top - piece.bottom));
    const auto radiusFrom = [&](double end, double sign) {
        for (double radius = most; radius > most / 300.0; radius *= 0.5)
            if (-signedDistance(piece, 0.0, end + sign * radius) >= radius * (1.0 - 1e-12)) return radius;
        return 0.0;
    };
    const double below = radiusFrom(piece.bottom, 1.0), above = radiusFrom(piece.top, -1.0);
    return {piece.bottom + below, std::min(below, above)};
}

} // namespace burin
