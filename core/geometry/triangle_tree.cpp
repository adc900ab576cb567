// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace burin {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct FloatBox {
    glm::vec3 low{infinity};
    glm::vec3 high{-infinity};

    void include(const FloatBox& other) noexcept {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    float halfArea() const noexcept {
        const glm::vec3 size = high - low;
        return size.x < 0.0F ? 0.0F : size.x * size.y + size.y * size.z + size.z * size.x;
    }
};

float roundedDown(double value) noexcept {
    const auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest) > value ? std::nextafter(nearest, -infinity) : nearest;
}
float roundedUp(double value) noexcept {
    return -roundedDown(-value);
}

FloatBox boxOf(const Triangle& t, const glm::dvec3& origin) noexcept {
    FloatBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = roundedDown(std::min({t[0][axis], t[1][axis], t[2][axis]}) - origin[axis]);
        box.high[axis] = roundedUp(std::max({t[0][axis], t[1][axis], t[2][axis]}) - origin[axis]);
    }
    return box;
}

/// A run of triangles in the order that is being made.
struct Range {
    std::uint32_t begin = 0, end = 0;
    FloatBox box;
    std::uint32_t count() const noexcept { return end - begin; }
};

class Builder {
public:
    Builder(const std::vector<Triangle>& source, const glm::dvec3& origin, std::vector<std::uint32_t>& order,
            std::vector<TreeNode>& nodes)
        : source_(source), origin_(origin), order_(order), nodes_(nodes) {
        boxes_.reserve(source.size());
        for (const Triangle& triangle : source) boxes_.push_back(boxOf(triangle, origin));
    }

    std::uint32_t build(const Range& range, int depth) {
        std::array<Range, TreeNode::width> parts;
        const std::size_t count = divide(range, depth, parts);
        const auto self = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        for (std::size_t child = 0; child < TreeNode::width; ++child) {
            const bool used = child < count;
            const bool leaf = used && parts[child].count() <= TriangleTree::trianglesPerLeaf;
            const std::uint32_t first = !used || leaf ? parts[child].begin : build(parts[child], depth + 1);
            TreeNode& node = nodes_[self]; // building a child may have moved it
            node.first[child] = first;
            node.count[child] = leaf ? parts[child].count() : 0;
            for (int axis = 0; axis < 3; ++axis) {
                node.low[static_cast<std::size_t>(axis)][child] = parts[child].box.low[axis];
                node.high[static_cast<std::size_t>(axis)][child] = parts[child].box.high[axis];
            }
            setPlate(node, child, parts[child]);
        }
        return self;
    }

    Range whole() const {
        Range range{0, static_cast<std::uint32_t>(order_.size()), {}};
        for (const FloatBox& box : boxes_) range.box.include(box);
        return range;
    }

private:
    static constexpr std::size_t binCount = 16;
    static constexpr int deepest = 40; ///< beyond it ranges are halved, so that the stack of a walk stays bounded

    struct Bin {
        FloatBox box;
        std::uint32_t count = 0;
    };
    struct Cut {
        float cost = infinity;
        int axis = 0;
        std::size_t bin = 0; ///< the last one of the lower half
    };

    glm::vec3 centre(std::uint32_t triangle) const noexcept {
        return 0.5F * (boxes_[triangle].low + boxes_[triangle].high);
    }

    void setPlate(TreeNode& node, std::size_t child, const Range& range) const noexcept {
        glm::dvec3 sum(0.0);
        for (std::uint32_t i = range.begin; i < range.end; ++i) sum += areaNormal(source_[order_[i]]);
        const double length = glm::length(sum);
        const glm::vec3 normal(length > 0.0 ? sum / length : glm::dvec3(0.0, 0.0, 1.0));
        const glm::dvec3 centre = 0.5 * (glm::dvec3(range.box.low) + glm::dvec3(range.box.high));
        double below = 0.0, above = 0.0, squared = 0.0;
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            for (const glm::dvec3& corner : source_[order_[i]]) {
                const glm::dvec3 way = corner - origin_ - centre;
                const double along = glm::dot(glm::dvec3(normal), way);
                below = std::min(below, along);
                above = std::max(above, along);
                squared = std::max(squared, glm::dot(way, way));
            }
        node.below[child] = roundedDown(below);
        node.above[child] = roundedUp(above);
        node.radius[child] = roundedUp(std::sqrt(squared) * (1.0 + 1e-12));
        for (int axis = 0; axis < 3; ++axis) node.normal[static_cast<std::size_t>(axis)][child] = normal[axis];
    }

    /// Splits the range whose walk costs most until there are four or only leaves are left.
    std::size_t divide(const Range& range, int depth, std::array<Range, TreeNode::width>& parts) {
        parts[0] = range;
        std::size_t count = 1;
        while (count < TreeNode::width) {
            std::size_t worst = count;
            float most = -1.0F;
            for (std::size_t i = 0; i < count; ++i) {
                const float cost = parts[i].box.halfArea() * static_cast<float>(parts[i].count());
                if (parts[i].count() > TriangleTree::trianglesPerLeaf && cost > most) {
                    most = cost;
                    worst = i;
                }
            }
            if (worst == count) break;
            const Range old = parts[worst];
            const std::uint32_t middle = depth < deepest ? splitByArea(old) : splitInHalves(old);
            parts[worst] = boxed(old.begin, middle);
            parts[count++] = boxed(middle, old.end);
        }
        return count;
    }

    Range boxed(std::uint32_t begin, std::uint32_t end) const {
        Range range{begin, end, {}};
        for (std::uint32_t i = begin; i < end; ++i) range.box.include(boxes_[order_[i]]);
        return range;
    }

    std::uint32_t splitInHalves(const Range& range) {
        const glm::vec3 size = range.box.high - range.box.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t middle = range.begin + range.count() / 2;
        const auto at = [this](std::uint32_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(range.begin), at(middle), at(range.end),
                         [&](std::uint32_t a, std::uint32_t b) { return centre(a)[axis] < centre(b)[axis]; });
        return middle;
    }

    std::uint32_t splitByArea(const Range& range) {
        FloatBox centres;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const glm::vec3 c = centre(order_[i]);
            centres.include({c, c});
        }
        const glm::vec3 size = centres.high - centres.low;
        const auto binOf = [&](std::uint32_t triangle, int axis) {
            const float place = (centre(triangle)[axis] - centres.low[axis]) / size[axis];
            return std::min(static_cast<std::size_t>(place * static_cast<float>(binCount)), binCount - 1);
        };
        std::array<std::array<Bin, binCount>, 3> bins;
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                if (!(size[axis] > 0.0F)) continue;
                Bin& bin = bins[static_cast<std::size_t>(axis)][binOf(order_[i], axis)];
                bin.box.include(boxes_[order_[i]]);
                ++bin.count;
            }
        Cut best;
        for (int axis = 0; axis < 3; ++axis)
            if (size[axis] > 0.0F) improve(best, axis, bins[static_cast<std::size_t>(axis)]);
        if (best.cost == infinity) return splitInHalves(range);

        const auto begin = order_.begin();
        const auto middle = std::partition(begin + range.begin, begin + range.end,
                                           [&](std::uint32_t t) { return binOf(t, best.axis) <= best.bin; });
        return static_cast<std::uint32_t>(middle - begin);
    }

    static void improve(Cut& best, int axis, const std::array<Bin, binCount>& bins) {
        std::array<float, binCount> upper{}; // cost of everything above each cut
        Bin swept;
        for (std::size_t i = binCount - 1; i > 0; --i) {
            swept.box.include(bins[i].box);
            swept.count += bins[i].count;
            upper[i - 1] = swept.count == 0 ? infinity : swept.box.halfArea() * static_cast<float>(swept.count);
        }
        swept = {};
        for (std::size_t i = 0; i + 1 < binCount; ++i) {
            swept.box.include(bins[i].box);
            swept.count += bins[i].count;
            if (swept.count == 0) continue;
            const float cost = upper[i] + swept.box.halfArea() * static_cast<float>(swept.count);
            if (cost < best.cost) best = {cost, axis, i};
        }
    }

    const std::vector<Triangle>& source_;
    const glm::dvec3& origin_;
    std::vector<FloatBox> boxes_;
    std::vector<std::uint32_t>& order_;
    std::vector<TreeNode>& nodes_;
};

} // namespace

TriangleTree::TriangleTree(std::vector<Triangle> source) : order_(source.size()) {
    if (source.empty()) return;
    for (const Triangle& triangle : source)
        for (const glm::dvec3& corner : triangle) bounds_.include(corner);
    origin_ = bounds_.centre();
    std::iota(order_.begin(), order_.end(), 0U);

    Builder builder(source, origin_, order_, nodes_);
    builder.build(builder.whole(), 0);

    triangles_.reserve(source.size());
    for (const std::uint32_t place : order_) triangles_.push_back(source[place]);
}

} // namespace burin
