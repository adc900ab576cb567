// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/entry_search.h"

#include "core/base/parallel.h"
#include "core/geometry/triangle_walk.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr std::size_t smallGroup = 2; // tips that are checked one by one
constexpr double wideNode = 2.0;      // in radii of a group: wider nodes are descended into

/// Tips sorted by cells of space, with one search for each cell.
class TipCells {
public:
    explicit TipCells(std::span<const glm::dvec3> tips) {
        Box box;
        for (const glm::dvec3& tip : tips)
            if (isFinite(tip)) box.include(tip);
        if (box.empty()) return;
        const glm::dvec3 size = box.size();
        const double longest = std::max({size.x, size.y, size.z, 1e-9});
        const double along = std::clamp(std::sqrt(static_cast<double>(tips.size()) / tipsPerCell), 1.0, mostAlong);
        const glm::ivec3 cells = glm::ivec3(size / longest * along) + 1;
        const auto cellOf = [&](const glm::dvec3& tip) {
            const glm::ivec3 at = glm::min(glm::ivec3((tip - box.low) / longest * along), cells - 1);
            return static_cast<std::size_t>((at.z * cells.y + at.y) * cells.x + at.x);
        };
        first_.resize(static_cast<std::size_t>(cells.x * cells.y * cells.z) + 1);
        for (const glm::dvec3& tip : tips)
            if (isFinite(tip)) ++first_[cellOf(tip) + 1];
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        tips_.resize(first_.back());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t i = 0; i < tips.size(); ++i)
            if (isFinite(tips[i])) tips_[next[cellOf(tips[i])]++] = {tips[i], static_cast<std::uint32_t>(i)};
    }

    std::size_t count() const noexcept { return first_.empty() ? 0 : first_.size() - 1; }
    std::span<AskedTip> of(std::size_t cell) noexcept {
        return std::span(tips_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
    }

private:
    static constexpr double tipsPerCell = 2000.0, mostAlong = 64.0; // tips of a surface
    std::vector<AskedTip> tips_;
    std::vector<std::uint32_t> first_; ///< by cell
};

} // namespace

EntrySearch::EntrySearch(const TriangleTree& tree, const RevolvedPiece& piece, const glm::dvec3& axis, double depth)
    : tree_(tree)
    , piece_(piece)
    , axis_(axis)
    , depth_(depth)
    , ball_(PlacedPiece(piece, {glm::dvec3(0.0), axis}).ballEnd() &&
            piece.top >= piece.bottom + 2.0 * piece.cornerRadius) {}

void EntrySearch::run(std::span<AskedTip> tips, std::span<std::uint8_t> entered) {
    if (tips.empty() || tree_.empty()) return;
    entered_ = entered;
    parts_.clear();
    parts_.push_back({0, Part::node});
    judge(tips, {0.0, 0.0, 1.0}, 0, 1);
}

/// The plate is laid through three tips that are far apart: the tips of a smooth surface are thin across it.
EntrySearch::Group EntrySearch::groupOf(std::span<const AskedTip> tips, const glm::dvec3& normal) const noexcept {
    Group group;
    group.normal = normal;
    glm::dvec3 low = tips[0].tip, high = low;
    for (const AskedTip& asked : tips) {
        low = glm::min(low, asked.tip);
        high = glm::max(high, asked.tip);
    }
    group.centre = 0.5 * (low + high);
    group.half = glm::max(high - group.centre, group.centre - low);
    glm::dvec3 farthest(0.0);
    double farthestSquared = 0.0, widestSquared = 0.0;
    for (const AskedTip& asked : tips) {
        const glm::dvec3 way = asked.tip - group.centre;
        const double squared = glm::dot(way, way);
        if (squared <= farthestSquared) continue;
        farthestSquared = squared;
        farthest = way;
    }
    glm::dvec3 across(0.0);
    for (const AskedTip& asked : tips) {
        const glm::dvec3 wide = glm::cross(farthest, asked.tip - group.centre);
        const double squared = glm::dot(wide, wide);
        if (squared <= widestSquared) continue;
        widestSquared = squared;
        across = wide;
    }
    group.radius = std::sqrt(farthestSquared);
    if (widestSquared > 0.0) group.normal = across / std::sqrt(widestSquared);
    for (const AskedTip& asked : tips) {
        const double along = glm::dot(asked.tip - group.centre, group.normal);
        group.below = std::min(group.below, along);
        group.above = std::max(group.above, along);
    }
    layPlanes(group);
    return group;
}

/// Perpendicular to the normal, where the tools of a group end.
void EntrySearch::layPlanes(Group& group) const noexcept {
    const double axial = glm::dot(group.normal, axis_), radial = std::sqrt(std::max(0.0, 1.0 - axial * axial));
    const auto reach = [&](double sign) {
        const ProfilePoint ring = farthestIn(piece_, radial, sign * axial);
        return ring.radius * radial + ring.height * sign * axial;
    };
    group.over = group.above + reach(1.0);
    group.beneath = group.below - reach(-1.0);
}

/// @param normal  of the plane that the tips of the enclosing group fit best
/// @param first @param end  range of the parts of the mesh that may concern these tips
void EntrySearch::judge(std::span<AskedTip> tips, const glm::dvec3& normal, std::size_t first, std::size_t end) {
    if (tips.size() <= smallGroup) {
        for (const AskedTip& asked : tips)
            if (enters(asked.tip, normal, first, end)) entered_[asked.number] = 1;
        return;
    }
    const Group group = groupOf(tips, normal);
    const PlacedPiece placed(piece_, ToolPose{group.centre, axis_});
    if (consider(placed, group, first, end) == Verdict::allEnter)
        for (const AskedTip& asked : tips) entered_[asked.number] = 1;
    else if (parts_.size() > end)
        divide(tips, 2, group.normal, end, parts_.size());
    parts_.resize(end);
}

/// Halves a group across its longest side, and each half again, `times` times in all.
void EntrySearch::divide(std::span<AskedTip> tips, int times, const glm::dvec3& normal, std::size_t first,
                         std::size_t end) {
    if (times == 0 || tips.size() <= smallGroup) {
        judge(tips, normal, first, end);
        return;
    }
    glm::dvec3 low = tips[0].tip, high = low;
    for (const AskedTip& asked : tips) {
        low = glm::min(low, asked.tip);
        high = glm::max(high, asked.tip);
    }
    const glm::dvec3 size = high - low;
    const int along = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = tips.size() / 2;
    std::nth_element(tips.begin(), tips.begin() + static_cast<std::ptrdiff_t>(half), tips.end(),
                     [along](const AskedTip& a, const AskedTip& b) { return a.tip[along] < b.tip[along]; });
    divide(tips.first(half), times - 1, normal, first, end);
    divide(tips.subspan(half), times - 1, normal, first, end);
}

bool EntrySearch::enters(const glm::dvec3& tip, const glm::dvec3& normal, std::size_t first, std::size_t end) {
    const PlacedPiece placed(piece_, ToolPose{tip, axis_});
    const auto isMet = [&](std::uint32_t slot) {
        const bool met = minimumOverTriangle(placed, tree_.triangles()[slot], -depth_).has_value();
        if (met) lastMet_ = slot;
        return met;
    };
    if (lastMet_ != none_ && isMet(lastMet_)) return true; // what stopped a neighbour is likely to stop this one
    Group one;
    one.centre = tip;
    one.normal = normal;
    layPlanes(one);
    bool met = consider(placed, one, first, end) == Verdict::allEnter;
    for (std::size_t i = end; i < parts_.size() && !met; ++i) met = isMet(parts_[i].number);
    parts_.resize(end);
    return met;
}

/// Appends what may concern a group to the parts: nodes no wider than the group, and triangles.
/// @param first @param end  range of the parts that are examined
EntrySearch::Verdict EntrySearch::consider(const PlacedPiece& placed, const Group& group, std::size_t first,
                                           std::size_t end) {
    Bounds bounds{{AbovePlane(tree_, {group.centre, -group.over, group.normal}),
                   AbovePlane(tree_, {group.centre, group.beneath, -group.normal})},
                  std::nullopt};
    if (ball_)
        bounds.balls.emplace(tree_, group.centre + (piece_.bottom + piece_.cornerRadius) * axis_, piece_.cornerRadius,
                             group, axis_, -group.rise(-axis_));
    for (std::size_t i = first; i != end; ++i) {
        open_.assign(1, parts_[i]);
        while (!open_.empty()) {
            const Part part = open_.back();
            open_.pop_back();
            if (part.child == Part::node)
                considerNode(placed, group, bounds, part.number);
            else if (part.child != Part::triangle)
                considerLeaf(placed, group, bounds, part.number, part.child);
            else if (considerTriangle(placed, group, part) == Verdict::allEnter)
                return Verdict::allEnter;
        }
    }
    return Verdict::open;
}

void EntrySearch::considerNode(const PlacedPiece& placed, const Group& group, const Bounds& bounds,
                               std::uint32_t number) {
    const TreeNode& node = tree_.nodes()[number];
    FourFloats bound = greater(bounds.planes[0].of(node), bounds.planes[1].of(node));
    const float unknown = -std::numeric_limits<float>::infinity();
    const FourFloats balls = bounds.balls ? bounds.balls->of(node) : FourFloats{} + unknown;
    bound = greater(bound, balls);
    for (std::uint32_t child = 0; child < TreeNode::width; ++child) {
        const bool used = node.low[0][child] <= node.high[0][child];
        if (!used || !(static_cast<double>(bound[child]) < -depth_)) continue;
        if (balls[child] == unknown)
            considerChild(placed, group, number, child);
        else
            takeChild(group, number, child);
    }
}

/// Examines a leaf that was left over for the enclosing group.
void EntrySearch::considerLeaf(const PlacedPiece& placed, const Group& group, const Bounds& bounds,
                               std::uint32_t number, std::uint32_t child) {
    const float unknown = -std::numeric_limits<float>::infinity();
    const float bound = bounds.balls ? bounds.balls->of(tree_.nodes()[number])[child] : unknown;
    if (bound == unknown)
        considerChild(placed, group, number, child);
    else if (static_cast<double>(bound) < -depth_)
        takeChild(group, number, child);
}

void EntrySearch::considerChild(const PlacedPiece& placed, const Group& group, std::uint32_t number,
                                std::uint32_t child) {
    const TreeNode& node = tree_.nodes()[number];
    const glm::dvec3 centre = boxCentre(node, child);
    const glm::dvec3 half = glm::dvec3(node.high[0][child], node.high[1][child], node.high[2][child]) - centre;
    const PlacedPiece::Value value = placed.at(centre + tree_.origin());
    const double fall = std::min(glm::dot(glm::abs(value.gradient), half), fallOverPlate(node, child, value.gradient));
    const double least = value.distance - fall - group.rise(value.gradient);
    if (least - 1e-9 - 1.2e-7 * std::abs(least) < -depth_) takeChild(group, number, child);
}

void EntrySearch::takeChild(const Group& group, std::uint32_t number, std::uint32_t child) {
    const TreeNode& node = tree_.nodes()[number];
    const std::uint32_t first = node.first[child], count = node.count[child];
    if (static_cast<double>(node.radius[child]) <= wideNode * group.radius)
        parts_.push_back(count == 0 ? Part{first, Part::node} : Part{number, child});
    else if (count == 0)
        open_.push_back({first, Part::node});
    else
        for (std::uint32_t slot = first; slot < first + count; ++slot) open_.push_back({slot, Part::triangle});
}

EntrySearch::Verdict EntrySearch::considerTriangle(const PlacedPiece& placed, const Group& group, Part part) {
    const Triangle& triangle = tree_.triangles()[part.number];
    const glm::dvec3 along(glm::dot(group.normal, triangle[0] - group.centre),
                           glm::dot(group.normal, triangle[1] - group.centre),
                           glm::dot(group.normal, triangle[2] - group.centre));
    if (std::min({along.x, along.y, along.z}) - group.over >= -depth_ ||
        group.beneath - std::max({along.x, along.y, along.z}) >= -depth_)
        return Verdict::open;
    // The centroid is fastest to evaluate; at the point where the piece is nearest, a plane lies better below a long
    // triangle.
    const glm::dvec3 centroid = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    Concern concern = concernAt(centroid, placed, triangle, group);
    if (concern == Concern::possible && group.radius > 0.0) {
        const std::optional<PieceMinimum> least =
            minimumOverTriangle(placed, triangle, std::numeric_limits<double>::infinity());
        if (least) concern = concernAt(least->point, placed, triangle, group);
    }
    if (concern == Concern::possible) parts_.push_back(part);
    if (concern != Concern::certain) return Verdict::open;
    lastMet_ = part.number;
    return Verdict::allEnter;
}

/// The relevance of a triangle to a group, judged from one of its points.
EntrySearch::Concern EntrySearch::concernAt(const glm::dvec3& point, const PlacedPiece& placed,
                                            const Triangle& triangle, const Group& group) const noexcept {
    const PlacedPiece::Value value = placed.at(point);
    // No tip is farther from the centre than the radius, and the signed distance changes no faster than the tip moves.
    if (value.distance + group.radius < -depth_) return Concern::certain;
    const double fall =
        std::min({glm::dot(value.gradient, triangle[0] - point), glm::dot(value.gradient, triangle[1] - point),
                  glm::dot(value.gradient, triangle[2] - point)});
    return value.distance + fall - group.rise(value.gradient) < -depth_ ? Concern::possible : Concern::none;
}

std::vector<std::uint8_t> enteredTips(const TriangleTree& tree, std::span<const RevolvedPiece> tool,
                                      const glm::dvec3& axis, std::span<const glm::dvec3> tips, double depth,
                                      const Progress& progress) {
    std::vector<std::uint8_t> entered(tips.size());
    if (tips.empty() || tree.empty()) return entered;
    TipCells cells(tips);
    parallelFor(std::size_t{0}, cells.count(), [&](std::size_t cell) {
        std::span<AskedTip> asked = cells.of(cell);
        for (const RevolvedPiece& piece : tool) {
            if (asked.empty() || progress.cancelled()) return;
            EntrySearch(tree, piece, axis, depth).run(asked, entered);
            const auto free = std::partition(asked.begin(), asked.end(),
                                             [&](const AskedTip& one) { return entered[one.number] == 0; });
            asked = asked.first(static_cast<std::size_t>(free - asked.begin()));
        }
    });
    return entered;
}

} // namespace burin
