// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/four_floats.h"
#include "core/geometry/supporting_plane.h"
#include "core/geometry/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace burin {

/// Lower bound of a walk for each child of a node; infinity if the child needs no visit.
using ChildBounds = std::array<float, TreeNode::width>;

/// Prefetches what a child refers to while others are processed: the trees of large meshes do not fit into the caches.
inline void bringNear(const TriangleTree& tree, std::uint32_t first, std::uint32_t count) noexcept {
    const void* const there = count > 0 ? static_cast<const void*>(tree.triangles().data() + first)
                                        : static_cast<const void*>(tree.nodes().data() + first);
    for (int line = 0; line < 4; ++line) __builtin_prefetch(static_cast<const char*>(there) + 64 * line);
}

/// Depth-first traversal, nearest child first. @param bounds  has `of(node)` and `stillBelow(bound)`, and may become
/// stricter while triangles are visited. @param meet  called with the slot of a triangle. No allocation. @return the
/// least bound of what was not visited
template <class Bounds, class Meet>
float walk(const TriangleTree& tree, const Bounds& bounds, const Meet& meet) noexcept {
    struct Open {
        float bound;
        std::uint32_t first, count;
    };
    float passed = std::numeric_limits<float>::infinity();
    if (tree.empty()) return passed;
    std::array<Open, TriangleTree::stackSize> stack;
    std::size_t open = 0;
    stack[open++] = {-std::numeric_limits<float>::infinity(), 0, 0};
    while (open > 0) {
        const Open top = stack[--open];
        if (!bounds.stillBelow(top.bound)) {
            passed = std::min(passed, top.bound);
            continue;
        }
        if (top.count > 0) {
            for (std::uint32_t slot = top.first; slot < top.first + top.count; ++slot) meet(slot);
            continue;
        }
        const TreeNode& node = tree.nodes()[top.first];
        const ChildBounds of = bounds.of(node);
        const std::size_t base = open;
        for (std::size_t child = 0; child < TreeNode::width; ++child) {
            if (!bounds.stillBelow(of[child])) {
                passed = std::min(passed, of[child]);
                continue;
            }
            std::size_t place = open++;
            for (; place > base && stack[place - 1].bound < of[child]; --place) stack[place] = stack[place - 1];
            stack[place] = {of[child], node.first[child], node.count[child]};
            bringNear(tree, node.first[child], node.count[child]);
        }
    }
    return passed;
}

/// Middle of a child's box, relative to the tree's origin.
inline glm::dvec3 boxCentre(const TreeNode& node, std::size_t child) noexcept {
    glm::dvec3 centre;
    for (std::size_t axis = 0; axis < 3; ++axis)
        centre[static_cast<int>(axis)] =
            0.5 * (static_cast<double>(node.low[axis][child]) + static_cast<double>(node.high[axis][child]));
    return centre;
}

/// Largest decrease of a linear function with this slope between the middle of a child's box and a point of its plate.
inline double fallOverPlate(const TreeNode& node, std::size_t child, const glm::dvec3& slope) noexcept {
    const glm::dvec3 normal(node.normal[0][child], node.normal[1][child], node.normal[2][child]);
    const double along = glm::dot(slope, normal);
    const double across = glm::length(slope - along * normal);
    const double thickness = along > 0.0 ? node.below[child] : node.above[child];
    return across * node.radius[child] - along * thickness;
}

/// Squared distances from a point to boxes and plates; a plate is a disc of the child's radius between two planes.
class NearPoint {
public:
    NearPoint(const TriangleTree& tree, const glm::dvec3& point) noexcept {
        const glm::vec3 at(point - tree.origin());
        const glm::vec3 size = glm::abs(at);
        const float slack = 2.4e-7F * std::max({size.x, size.y, size.z}); // what rounding the point may hide
        slack_ = FourFloats{} + slack;
        for (int axis = 0; axis < 3; ++axis) at_[static_cast<std::size_t>(axis)] = FourFloats{} + at[axis];
    }
    /// Limits the walk to what is nearer than this, mm².
    void limit(double squared) noexcept {
        limit_ = squared < 1e38 ? static_cast<float>(squared * (1.0 + 4e-6)) + std::numeric_limits<float>::min()
                                : std::numeric_limits<float>::max();
    }
    bool stillBelow(float bound) const noexcept { return bound < limit_; }
    ChildBounds of(const TreeNode& node) const noexcept {
        const FourFloats zero{};
        FourFloats box{}, squared{}, along{}, spread{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const FourFloats low = fourAt(node.low[axis].data()), high = fourAt(node.high[axis].data());
            const FourFloats gap = greater(greater(low - at_[axis], at_[axis] - high) - slack_, zero);
            box += gap * gap;
            const FourFloats way = at_[axis] - 0.5F * (low + high);
            squared += way * way;
            along += way * fourAt(node.normal[axis].data());
            spread += absolute(way);
        }
        // Single precision represents lengths to a few units of the seventh digit.
        const FourFloats slack = slack_ + 1e-6F * spread;
        const FourFloats beyond =
            greater(greater(along - fourAt(node.above.data()), fourAt(node.below.data()) - along) - slack, zero);
        const FourFloats across = rootsOf(greater(squared * (1.0F - 2e-6F) - along * along, zero));
        const FourFloats beside = greater(across - fourAt(node.radius.data()) - slack, zero);
        const FourFloats bound = greater(box, beyond * beyond + beside * beside);
        ChildBounds bounds;
        put(bound, bounds.data());
        return bounds;
    }

private:
    std::array<FourFloats, 3> at_;
    FourFloats slack_;
    float limit_ = 0.0F;
};

/// Lower bounds, over boxes and plates, of a function that stays above a plane.
class AbovePlane {
public:
    AbovePlane(const TriangleTree& tree, const SupportingPlane& plane) noexcept {
        const glm::vec3 at(plane.at - tree.origin()), slope(plane.slope), size = glm::abs(at);
        value_ = FourFloats{} + static_cast<float>(plane.value);
        // What rounding of the point, the slope and the value may hide.
        slack_ = FourFloats{} + 2.4e-7F * std::max({size.x, size.y, size.z}) +
                 1.2e-7F * std::abs(static_cast<float>(plane.value));
        for (int axis = 0; axis < 3; ++axis) {
            at_[static_cast<std::size_t>(axis)] = FourFloats{} + at[axis];
            slope_[static_cast<std::size_t>(axis)] = FourFloats{} + slope[axis];
        }
        square_ = FourFloats{} + glm::dot(slope, slope) * (1.0F + 1e-6F);
    }
    FourFloats of(const TreeNode& node) const noexcept {
        FourFloats bound = value_, spread{}, along{}, overBox{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const FourFloats low = fourAt(node.low[axis].data()), high = fourAt(node.high[axis].data());
            const FourFloats way = 0.5F * (low + high) - at_[axis];
            bound += slope_[axis] * way;
            overBox += 0.5F * absolute(slope_[axis]) * (high - low);
            spread += absolute(way);
            along += slope_[axis] * fourAt(node.normal[axis].data());
        }
        const FourFloats across = rootsOf(greater(square_ - along * along, FourFloats{}) + 1e-6F);
        const FourFloats thickness = along > 0.0F ? fourAt(node.below.data()) : fourAt(node.above.data());
        const FourFloats radius = fourAt(node.radius.data());
        const FourFloats overPlate = across * radius - along * thickness;
        return bound - (overBox < overPlate ? overBox : overPlate) - slack_ - 1e-6F * (spread + radius);
    }

private:
    std::array<FourFloats, 3> at_, slope_;
    FourFloats value_, slack_, square_;
};

/// Lower bounds of the signed distance from a piece to the points of boxes, for points above `floor` (height above the
/// tip, mm): from the piece's bottom up, or from a ball's centre if the result for what is below is known already.
class NearPiece {
public:
    NearPiece(const TriangleTree& tree, const PlacedPiece& placed, double floor) noexcept
        : placed_(&placed)
        , origin_(tree.origin())
        , floor_(floor > placed.piece().bottom ? floor : -std::numeric_limits<double>::infinity()) {
        const auto& [tip, axis] = placed.pose();
        const RevolvedPiece& piece = placed.piece();
        const glm::dvec3 bottom = tip + floor * axis - origin_, top = tip + piece.top * axis - origin_;
        const double lower = piece.bulges() ? piece.widestRadius() : piece.bottomRadius;
        const double upper = piece.bulges() ? piece.widestRadius() : piece.topRadius;
        for (int i = 0; i < 3; ++i) {
            const double across = std::sqrt(std::max(0.0, 1.0 - axis[i] * axis[i]));
            const double low = std::min(bottom[i] - lower * across, top[i] - upper * across);
            const double high = std::max(bottom[i] + lower * across, top[i] + upper * across);
            const double slack = 1e-9 + 2.4e-7 * std::max(std::abs(low), std::abs(high));
            low_[static_cast<std::size_t>(i)] = FourFloats{} + static_cast<float>(low - slack);
            high_[static_cast<std::size_t>(i)] = FourFloats{} + static_cast<float>(high + slack);
        }
    }
    /// Limits the walk to what is nearer than this, mm; negative: deeper inside.
    void limit(double distance) noexcept {
        distance_ = distance;
        const double outside = std::max(distance, 0.0);
        squared_ = outside < 1e18
                       ? static_cast<float>(outside * outside * (1.0 + 4e-6)) + std::numeric_limits<float>::min()
                       : std::numeric_limits<float>::max();
    }
    bool stillBelow(float bound) const noexcept { return static_cast<double>(bound) < distance_; }

    /// Adds a plane that the signed distance stays above.
    void stayAbove(const AbovePlane& plane) noexcept { plane_ = plane; }

    ChildBounds of(const TreeNode& node) const noexcept {
        const FourFloats zero{};
        FourFloats squared{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const FourFloats gap = greater(
                greater(fourAt(node.low[axis].data()) - high_[axis], low_[axis] - fourAt(node.high[axis].data())),
                zero);
            squared += gap * gap;
        }
        ChildBounds bounds, boxes;
        put(squared, boxes.data());
        if (plane_)
            put(plane_->of(node), bounds.data());
        else
            bounds.fill(-std::numeric_limits<float>::infinity());
        for (std::size_t child = 0; child < TreeNode::width; ++child) {
            if (!(boxes[child] < squared_))
                bounds[child] = std::max(bounds[child], std::sqrt(boxes[child]) * (1.0F - 1e-6F));
            else if (stillBelow(bounds[child]))
                bounds[child] = std::max(bounds[child], tangentBound(node, child));
        }
        return bounds;
    }

private:
    /// The signed distance is convex: over a box it stays above its tangent at the box's centre.
    float tangentBound(const TreeNode& node, std::size_t child) const noexcept {
        const glm::dvec3 centre = boxCentre(node, child);
        const glm::dvec3 half = glm::dvec3(node.high[0][child], node.high[1][child], node.high[2][child]) - centre;
        const glm::dvec3& axis = placed_->pose().axis;
        const glm::dvec3 point = centre + origin_;
        const double highest = glm::dot(point - placed_->pose().tip, axis) + glm::dot(glm::abs(axis), half);
        if (highest < floor_) return std::numeric_limits<float>::infinity();
        const PlacedPiece::Value value = placed_->at(point);
        const double fall =
            std::min(glm::dot(glm::abs(value.gradient), half), fallOverPlate(node, child, value.gradient));
        const double bound = value.distance - fall;
        return static_cast<float>(bound - 1e-9 - 1.2e-7 * std::abs(bound));
    }

    const PlacedPiece* placed_;
    glm::dvec3 origin_;
    double floor_;
    std::array<FourFloats, 3> low_, high_;
    std::optional<AbovePlane> plane_;
    double distance_ = 0.0;
    float squared_ = 0.0F;
};

} // namespace burin
