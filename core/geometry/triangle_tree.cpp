// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/triangle_tree.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// What building looks at of a triangle, moved about as one.
struct Entry {
    FloatBox box;
    std::uint32_t triangle = 0;
    float centre(int axis) const noexcept { return 0.5F * (box.low[axis] + box.high[axis]); }
};

/// A run of entries.
struct Range {
    std::uint32_t begin = 0, end = 0;
    FloatBox box;
    std::uint32_t count() const noexcept { return end - begin; }
};

class Builder {
public:
    Builder(const std::vector<Triangle>& source, const glm::dvec3& origin, std::vector<Entry>& entries)
        : source_(source), origin_(origin), entries_(entries) {}

    Range whole() const {
        Range range{0, static_cast<std::uint32_t>(entries_.size()), {}};
        for (const Entry& entry : entries_) range.box.include(entry.box);
        return range;
    }

    /// Appends the nodes of a range, its own first.
    void build(const Range& range, int depth, std::vector<TreeNode>& nodes) {
        std::array<Range, TreeNode::width> parts;
        const std::size_t count = divide(range, depth, parts);
        const std::size_t self = nodes.size();
        nodes.emplace_back();
        for (std::size_t child = 0; child < TreeNode::width; ++child) {
            const bool leaf = parts[child].count() <= TriangleTree::trianglesPerLeaf; // or unused
            setChild(nodes[self], child, parts[child]);
            nodes[self].first[child] = leaf ? parts[child].begin : branch;
            nodes[self].count[child] = leaf ? parts[child].count() : 0;
        }
        std::array<std::vector<TreeNode>, TreeNode::width> below;
        const bool share = range.count() > shared;
        if (share)
            parallelFor(std::size_t{0}, count, [&](std::size_t child) {
                if (nodes[self].first[child] == branch) build(parts[child], depth + 1, below[child]);
            });
        for (std::size_t child = 0; child < count; ++child) {
            if (nodes[self].first[child] != branch) continue;
            nodes[self].first[child] = static_cast<std::uint32_t>(nodes.size());
            if (share)
                adopt(nodes, below[child]);
            else
                build(parts[child], depth + 1, nodes);
        }
    }

private:
    static constexpr std::size_t binCount = 16;
    static constexpr int deepest = 40; ///< beyond it ranges are halved, so that the stack of a walk stays bounded
    static constexpr std::uint32_t shared = 8192;        ///< larger ranges are worth another core
    static constexpr std::uint32_t branch = 0xFFFFFFFFU; ///< a child that is a node yet to come
    static constexpr std::uint32_t few =
        32; ///< a larger range is cut across its longest side, without a look at the others
    static constexpr std::uint32_t bent = 512; ///< the surface of larger ranges is no plate: their box will do

    struct Bin {
        FloatBox box;
        std::uint32_t count = 0;
    };
    struct Cut {
        float cost = infinity;
        int axis = 0;
        std::size_t bin = 0; ///< the last one of the lower half
    };

    /// Nodes that count from their own first are moved behind those that there are.
    static void adopt(std::vector<TreeNode>& nodes, const std::vector<TreeNode>& below) {
        const auto offset = static_cast<std::uint32_t>(nodes.size());
        nodes.insert(nodes.end(), below.begin(), below.end());
        for (std::size_t i = offset; i < nodes.size(); ++i)
            for (std::size_t child = 0; child < TreeNode::width; ++child)
                if (nodes[i].count[child] == 0 && nodes[i].first[child] != 0) nodes[i].first[child] += offset;
    }

    void setChild(TreeNode& node, std::size_t child, const Range& range) const noexcept {
        for (int axis = 0; axis < 3; ++axis) {
            node.low[static_cast<std::size_t>(axis)][child] = range.box.low[axis];
            node.high[static_cast<std::size_t>(axis)][child] = range.box.high[axis];
        }
        setPlate(node, child, range);
    }

    void setPlate(TreeNode& node, std::size_t child, const Range& range) const noexcept {
        glm::dvec3 sum(0.0);
        if (range.count() <= bent)
            for (std::uint32_t i = range.begin; i < range.end; ++i) sum += areaNormal(source_[entries_[i].triangle]);
        const double length = glm::length(sum);
        const glm::vec3 normal(length > 0.0 ? sum / length : glm::dvec3(0.0, 0.0, 1.0));
        const glm::dvec3 low(range.box.low), high(range.box.high), centre = 0.5 * (low + high);
        double below = 0.0, above = 0.0, squared = 0.0;
        const auto include = [&](const glm::dvec3& way) noexcept {
            const double along = glm::dot(glm::dvec3(normal), way);
            below = std::min(below, along);
            above = std::max(above, along);
            squared = std::max(squared, glm::dot(way, way));
        };
        if (range.count() > bent) {
            include(low - centre);
            include(high - centre);
        } else {
            for (std::uint32_t i = range.begin; i < range.end; ++i)
                for (const glm::dvec3& corner : source_[entries_[i].triangle]) include(corner - origin_ - centre);
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
        for (std::uint32_t i = begin; i < end; ++i) range.box.include(entries_[i].box);
        return range;
    }

    auto at(std::uint32_t i) noexcept { return entries_.begin() + static_cast<std::ptrdiff_t>(i); }

    std::uint32_t splitInHalves(const Range& range) {
        const glm::vec3 size = range.box.high - range.box.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t middle = range.begin + range.count() / 2;
        std::nth_element(at(range.begin), at(middle), at(range.end),
                         [axis](const Entry& a, const Entry& b) { return a.centre(axis) < b.centre(axis); });
        return middle;
    }

    std::uint32_t splitByArea(const Range& range) {
        FloatBox centres;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const glm::vec3 c = 0.5F * (entries_[i].box.low + entries_[i].box.high);
            centres.include({c, c});
        }
        const glm::vec3 size = centres.high - centres.low;
        const auto binOf = [&](const Entry& entry, int axis) {
            const float place = (entry.centre(axis) - centres.low[axis]) / size[axis];
            return std::min(static_cast<std::size_t>(place * static_cast<float>(binCount)), binCount - 1);
        };
        std::array<std::array<Bin, binCount>, 3> bins;
        const float longest = std::max({size.x, size.y, size.z});
        const auto counts = [&](int axis) noexcept {
            return size[axis] > 0.0F && (range.count() <= few || size[axis] == longest);
        };
        for (int axis = 0; axis < 3; ++axis) {
            if (!counts(axis)) continue;
            for (std::uint32_t i = range.begin; i < range.end; ++i) {
                Bin& bin = bins[static_cast<std::size_t>(axis)][binOf(entries_[i], axis)];
                bin.box.include(entries_[i].box);
                ++bin.count;
            }
        }
        Cut best;
        for (int axis = 0; axis < 3; ++axis)
            if (counts(axis)) improve(best, axis, bins[static_cast<std::size_t>(axis)]);
        if (best.cost == infinity) return splitInHalves(range);

        const auto middle = std::partition(at(range.begin), at(range.end),
                                           [&](const Entry& entry) { return binOf(entry, best.axis) <= best.bin; });
        return static_cast<std::uint32_t>(middle - entries_.begin());
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
    std::vector<Entry>& entries_;
};

} // namespace

TriangleTree::TriangleTree(std::vector<Triangle> source) : order_(source.size()) {
    if (source.empty()) return;
    for (const Triangle& triangle : source)
        for (const glm::dvec3& corner : triangle) bounds_.include(corner);
    origin_ = bounds_.centre();
    constexpr std::size_t grain = 4096;
    std::vector<Entry> entries(source.size());
    parallelStretches(std::size_t{0}, source.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) entries[i] = {boxOf(source[i], origin_), static_cast<std::uint32_t>(i)};
    });
    Builder builder(source, origin_, entries);
    builder.build(builder.whole(), 0, nodes_);

    triangles_.resize(source.size());
    parallelStretches(std::size_t{0}, source.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            order_[i] = entries[i].triangle;
            triangles_[i] = source[entries[i].triangle];
        }
    });
}

} // namespace burin
