// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/ball_group.h"
#include "core/geometry/piece_minimum.h"
#include "core/geometry/triangle_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// A position of the tool's tip to check.
struct AskedTip {
    glm::dvec3 tip{0.0};
    std::uint32_t number = 0;
};

/// Finds those of many tips for which a point of the mesh is deeper in a piece of the tool than allowed. Tips are
/// subdivided recursively, and so are the parts of the mesh that may concern them: a plane below the (convex) signed
/// distance rules out a part of the mesh for all tips of a group at once, and the remaining parts are passed on to the
/// group's subgroups. Two planes are tried: one in the middle of both, and, for tips that lie in a plane, the one that
/// all tools of the group touch. (Dual-tree search: A. Gray, A. Moore, N-body problems in statistical learning, 2000.)
/// Single-threaded.
class EntrySearch {
public:
    /// @param piece  of a tool that is parallel to `axis`, a unit vector  @param depth  mm, > 0
    EntrySearch(const TriangleTree& tree, const RevolvedPiece& piece, const glm::dvec3& axis, double depth);

    /// Sets entered[number] of the tips that enter and leaves the others unchanged. Reorders the tips.
    void run(std::span<AskedTip> tips, std::span<std::uint8_t> entered);

private:
    /// Tips of a group: they lie in a box, and between two planes within `radius` of its centre.
    struct Group : BallGroup::Spread {
        glm::dvec3 centre{0.0};
        double beneath = 0.0, over = 0.0; ///< mm from the centre along the normal: no tool of the group reaches beyond

        /// Upper bound of how far a tip lies beyond the centre along a slope.
        double rise(const glm::dvec3& slope) const noexcept {
            const double along = glm::dot(slope, normal);
            const double across = std::sqrt(std::max(0.0, glm::dot(slope, slope) - along * along));
            const double overPlate = across * radius + along * (along > 0.0 ? above : below);
            return std::min(glm::dot(glm::abs(slope), half), overPlate);
        }
    };
    /// A part of the mesh that may concern a group: everything below a node of the tree, one leaf, or one triangle.
    struct Part {
        std::uint32_t number = 0;   ///< of the node, or the triangle's slot
        std::uint32_t child = node; ///< of the node, where it is a leaf
        static constexpr std::uint32_t node = TreeNode::width, triangle = node + 1;
    };
    /// The bounds that rule out four children of a node at once.
    struct Bounds {
        std::array<AbovePlane, 2> planes;
        std::optional<BallGroup> balls;
    };
    enum class Verdict : std::uint8_t { open, allEnter };
    enum class Concern : std::uint8_t { none, possible, certain }; ///< of a triangle, for a whole group

    Group groupOf(std::span<const AskedTip> tips, const glm::dvec3& normal) const noexcept;
    void layPlanes(Group& group) const noexcept;
    void judge(std::span<AskedTip> tips, const glm::dvec3& normal, std::size_t first, std::size_t end);
    void divide(std::span<AskedTip> tips, int times, const glm::dvec3& normal, std::size_t first, std::size_t end);
    bool enters(const glm::dvec3& tip, const glm::dvec3& normal, std::size_t first, std::size_t end);
    Verdict consider(const PlacedPiece& placed, const Group& group, std::size_t first, std::size_t end);
    void considerNode(const PlacedPiece& placed, const Group& group, const Bounds& bounds, std::uint32_t number);
    void considerLeaf(const PlacedPiece& placed, const Group& group, const Bounds& bounds, std::uint32_t number,
                      std::uint32_t child);
    void considerChild(const PlacedPiece& placed, const Group& group, std::uint32_t number, std::uint32_t child);
    void takeChild(const Group& group, std::uint32_t number, std::uint32_t child);
    Verdict considerTriangle(const PlacedPiece& placed, const Group& group, Part part);
    Concern concernAt(const glm::dvec3& point, const PlacedPiece& placed, const Triangle& triangle,
                      const Group& group) const noexcept;

    const TriangleTree& tree_;
    RevolvedPiece piece_;
    glm::dvec3 axis_;
    double depth_;
    bool ball_; ///< whether the lower end of the piece is a full ball
    std::span<std::uint8_t> entered_;
    std::vector<Part> parts_;       ///< a stack: the parts that concern a group, and above them those of its half
    std::vector<Part> open_;        ///< still to be examined
    std::uint32_t lastMet_ = none_; ///< slot of the last triangle that was entered
    static constexpr std::uint32_t none_ = std::numeric_limits<std::uint32_t>::max();
};

/// For each of many tips, whether a point of the mesh is deeper than `depth` in a piece of the tool, 0 or 1; uses all
/// cores. Once cancelled, results not known yet are 0.
std::vector<std::uint8_t> enteredTips(const TriangleTree& tree, std::span<const RevolvedPiece> tool,
                                      const glm::dvec3& axis, std::span<const glm::dvec3> tips, double depth,
                                      const Progress& progress);

} // namespace burin
