// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/triangle_tree.h"

#include "core/base/parallel.h"
#include "core/geometry/four_floats.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>

namespace burin {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// x, y, z and a fourth number that is meaningless here.
struct FloatBox {
    FourFloats low = FourFloats{} + infinity;
    FourFloats high = FourFloats{} - infinity;

    void include(const FloatBox& other) noexcept {
        low = other.low < low ? other.low : low;
        high = greater(other.high, high);
    }
    void include(const FourFloats& point) noexcept {
        low = point < low ? point : low;
        high = greater(point, high);
    }
    FourFloats size() const noexcept { return high - low; }
    float halfArea() const noexcept {
        const FourFloats edge = size();
        return edge[0] < 0.0F ? 0.0F : edge[0] * edge[1] + edge[1] * edge[2] + edge[2] * edge[0];
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

/// Data of a triangle during construction, moved as one unit: its box, and its number in the fourth component, as the
/// bits of a normalised float, because denormals are slow to add.
struct Entry {
    static constexpr std::uint32_t ordinary = 0x40000000U;
    FloatBox box;
    Entry() = default;
    Entry(const FloatBox& around, std::size_t triangle) noexcept : box(around) {
        box.low[3] = 0.0F;
        box.high[3] = std::bit_cast<float>(static_cast<std::uint32_t>(triangle) | ordinary);
    }
    std::uint32_t triangle() const noexcept { return std::bit_cast<std::uint32_t>(float{box.high[3]}) & ~ordinary; }
    FourFloats centre() const noexcept { return 0.5F * (box.low + box.high); }
    float centre(int axis) const noexcept { return 0.5F * (box.low[axis] + box.high[axis]); }
};

/// A range of entries, their bounding box and that of their centres.
struct Range {
    std::uint32_t begin = 0, end = 0;
    FloatBox box, centres;
    std::uint32_t count() const noexcept { return end - begin; }
};

class Builder {
public:
    Builder(const TriangleMesh& mesh, const glm::dvec3& origin, std::vector<Entry>& entries)
        : mesh_(mesh), origin_(origin), entries_(entries) {}

    Range whole() const { return boxed(0, static_cast<std::uint32_t>(entries_.size())); }

    /// Appends the nodes of a range, the node of the range itself first.
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
    static constexpr std::size_t mostBins = 16, fewBins = 8;
    static constexpr int deepest = 40; ///< deeper ranges are halved, so that the stack of a walk stays bounded
    static constexpr std::uint32_t shared = 8192;        ///< larger ranges are worth using another core
    static constexpr std::uint32_t branch = 0xFFFFFFFFU; ///< a child that is a node not yet built
    static constexpr std::uint32_t few =
        32; ///< a larger range is cut across its longest side, without a look at the others
    static constexpr std::uint32_t fewest = 12; ///< smaller ranges use fewer bins
    static constexpr std::uint32_t bent = 512;  ///< larger ranges are not plate-like: their box is sufficient

    struct Bin {
        FloatBox box, centres;
        std::uint32_t count = 0;

        void include(const Entry& entry) noexcept {
            box.include(entry.box);
            centres.include(entry.centre());
            ++count;
        }
        void include(const Bin& other) noexcept {
            box.include(other.box);
            centres.include(other.centres);
            count += other.count;
        }
    };
    struct Cut {
        float cost = infinity;
        int axis = 0;
        std::size_t bins = 0;
        std::size_t bin = 0; ///< the last one of the lower half
        Bin below, above;    ///< the halves
    };

    /// Appends nodes whose indices count from their own first one to the existing nodes.
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
            for (std::uint32_t i = range.begin; i < range.end; ++i) sum += areaNormal(triangle(i));
        const double length = glm::length(sum);
        const glm::vec3 normal(length > 0.0 ? sum / length : glm::dvec3(0.0, 0.0, 1.0));
        const auto point = [](const FourFloats& v) { return glm::dvec3(v[0], v[1], v[2]); };
        const glm::dvec3 low = point(range.box.low), high = point(range.box.high), centre = 0.5 * (low + high);
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
                for (const glm::dvec3& corner : triangle(i)) include(corner - origin_ - centre);
        }
        node.below[child] = roundedDown(below);
        node.above[child] = roundedUp(above);
        node.radius[child] = roundedUp(std::sqrt(squared) * (1.0 + 1e-12));
        for (int axis = 0; axis < 3; ++axis) node.normal[static_cast<std::size_t>(axis)][child] = normal[axis];
    }

    /// Splits the range with the most expensive walk until there are four or only leaves are left.
    std::size_t divide(const Range& range, int depth, std::array<Range, TreeNode::width>& parts) {
        if (range.count() > shared) return divideShared(range, depth, parts);
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
            const std::array<Range, 2> halves = split(parts[worst], depth);
            parts[worst] = halves[0];
            parts[count++] = halves[1];
        }
        return count;
    }

    std::array<Range, 2> split(const Range& range, int depth) {
        return depth < deepest ? splitByArea(range) : splitInHalves(range);
    }

    /// Halves a large range, and then both halves at the same time.
    std::size_t divideShared(const Range& range, int depth, std::array<Range, TreeNode::width>& parts) {
        const std::array<Range, 2> halves = split(range, depth);
        std::array<std::array<Range, 2>, 2> quarters;
        parallelFor(std::size_t{0}, halves.size(), [&](std::size_t i) {
            if (halves[i].count() > TriangleTree::trianglesPerLeaf)
                quarters[i] = split(halves[i], depth);
            else
                quarters[i][0] = halves[i];
        });
        std::size_t count = 0;
        for (const auto& [low, high] : quarters)
            for (const Range& part : {low, high})
                if (part.count() > 0) parts[count++] = part;
        return count;
    }

    Range boxed(std::uint32_t begin, std::uint32_t end) const {
        Range range{begin, end, {}, {}};
        for (std::uint32_t i = begin; i < end; ++i) {
            range.box.include(entries_[i].box);
            range.centres.include(entries_[i].centre());
        }
        return range;
    }

    auto at(std::uint32_t i) noexcept { return entries_.begin() + static_cast<std::ptrdiff_t>(i); }

    std::array<Range, 2> splitInHalves(const Range& range) {
        const FourFloats size = range.box.size();
        const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
        const std::uint32_t middle = range.begin + range.count() / 2;
        std::nth_element(at(range.begin), at(middle), at(range.end),
                         [axis](const Entry& a, const Entry& b) { return a.centre(axis) < b.centre(axis); });
        return {boxed(range.begin, middle), boxed(middle, range.end)};
    }

    static std::size_t binOf(const Entry& entry, const Range& range, int axis, std::size_t bins) noexcept {
        const float low = range.centres.low[axis], size = range.centres.high[axis] - low;
        const float place = (entry.centre(axis) - low) / size;
        return std::min(static_cast<std::size_t>(place * static_cast<float>(bins)), bins - 1);
    }

    std::array<Range, 2> splitByArea(const Range& range) {
        const FourFloats size = range.centres.size();
        const float longest = std::max({size[0], size[1], size[2]});
        Cut best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(size[axis] > 0.0F) || (range.count() > few && size[axis] != longest)) continue;
            if (range.count() < fewest)
                improve<fewBins>(best, range, axis);
            else
                improve<mostBins>(best, range, axis);
        }
        if (best.cost == infinity) return splitInHalves(range);
        std::partition(at(range.begin), at(range.end),
                       [&](const Entry& entry) { return binOf(entry, range, best.axis, best.bins) <= best.bin; });
        const std::uint32_t middle = range.begin + best.below.count;
        return {Range{range.begin, middle, best.below.box, best.below.centres},
                Range{middle, range.end, best.above.box, best.above.centres}};
    }

    template <std::size_t binCount>
    void improve(Cut& best, const Range& range, int axis) const {
        std::array<Bin, binCount> bins;
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            bins[binOf(entries_[i], range, axis, binCount)].include(entries_[i]);
        std::array<float, binCount> upper{}; // cost of everything above each cut
        FloatBox box;
        std::uint32_t count = 0;
        for (std::size_t i = binCount - 1; i > 0; --i) {
            box.include(bins[i].box);
            count += bins[i].count;
            upper[i - 1] = count == 0 ? infinity : box.halfArea() * static_cast<float>(count);
        }
        box = {};
        count = 0;
        const float before = best.cost;
        for (std::size_t i = 0; i + 1 < binCount; ++i) {
            box.include(bins[i].box);
            count += bins[i].count;
            if (count == 0) continue;
            const float cost = upper[i] + box.halfArea() * static_cast<float>(count);
            if (!(cost < best.cost)) continue;
            best.cost = cost;
            best.axis = axis;
            best.bins = binCount;
            best.bin = i;
        }
        if (!(best.cost < before)) return;
        best.below = best.above = {};
        for (std::size_t i = 0; i < binCount; ++i) (i <= best.bin ? best.below : best.above).include(bins[i]);
    }

    Triangle triangle(std::uint32_t entry) const noexcept { return cornersOf(mesh_, entries_[entry].triangle()); }

    const TriangleMesh& mesh_;
    const glm::dvec3& origin_;
    std::vector<Entry>& entries_;
};

} // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh, std::span<const std::uint32_t> places) : order_(places.size()) {
    if (places.empty()) return;
    constexpr std::size_t grain = 4096;
    std::mutex mutex;
    parallelIntervals(std::size_t{0}, places.size(), grain, [&](std::size_t from, std::size_t to) {
        Box box;
        for (std::size_t i = from; i < to; ++i)
            for (const glm::dvec3& corner : cornersOf(mesh, places[i])) box.include(corner);
        const std::lock_guard lock(mutex);
        bounds_.include(box);
    });
    origin_ = bounds_.centre();
    std::vector<Entry> entries(places.size());
    parallelIntervals(std::size_t{0}, places.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) entries[i] = {boxOf(cornersOf(mesh, places[i]), origin_), places[i]};
    });
    Builder builder(mesh, origin_, entries);
    builder.build(builder.whole(), 0, nodes_);

    triangles_ = std::make_unique_for_overwrite<Triangle[]>(places.size());
    parallelIntervals(std::size_t{0}, places.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            order_[i] = entries[i].triangle();
            triangles_[i] = cornersOf(mesh, order_[i]);
        }
    });
}

} // namespace burin
