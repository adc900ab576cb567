// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace burin {

/// One round of subdividing triangles at the midpoints of their edges. Neighbours share a midpoint, so no gap opens. If
/// an edge is halved, so is the longest edge of its triangles: no triangle degenerates into a needle, and the rounds
/// terminate (M. C. Rivara, 1984).
/// @tparam Wants called once per edge with the indices of its ends; returns whether it is to be halved
/// @tparam AddMiddle adds the midpoint of an edge and returns its index
template <class Wants, class AddMiddle>
class EdgeHalving {
public:
    /// @param points mm; `addMiddle` may add to them
    EdgeHalving(const std::vector<glm::vec3>& points, std::vector<std::uint32_t>& triangles, Wants wants,
                AddMiddle addMiddle)
        : points_(points), triangles_(triangles), wants_(std::move(wants)), addMiddle_(std::move(addMiddle)) {}

    /// @return whether an edge was halved
    bool run() {
        if (!choose()) return false;
        while (chooseLongest()) {
        }
        std::vector<std::uint32_t> whole;
        whole.swap(triangles_);
        triangles_.reserve(2 * whole.size());
        for (std::size_t i = 0; i < whole.size(); i += 3) divide({whole[i], whole[i + 1], whole[i + 2]});
        return true;
    }

private:
    using Corners = std::array<std::uint32_t, 3>;
    struct Edge {
        bool halved = false;
        std::optional<std::uint32_t> middle;
    };

    static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
        return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
    }
    template <class Visit>
    void eachTriangle(Visit visit) const {
        for (std::size_t i = 0; i < triangles_.size(); i += 3)
            visit(Corners{triangles_[i], triangles_[i + 1], triangles_[i + 2]});
    }

    bool choose() {
        bool any = false;
        eachTriangle([&](const Corners& corner) {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = corner[i], b = corner[(i + 1) % 3];
                const auto [edge, isNew] = edges_.try_emplace(keyOf(a, b));
                if (isNew) edge->second.halved = wants_(a, b);
                any = any || edge->second.halved;
            }
        });
        return any;
    }

    /// @return whether an edge was newly chosen
    bool chooseLongest() {
        bool any = false;
        eachTriangle([&](const Corners& corner) {
            std::pair<float, std::uint64_t> longest;
            bool halved = false;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = corner[i], b = corner[(i + 1) % 3];
                halved = halved || edges_[keyOf(a, b)].halved;
                longest = std::max(longest, {glm::distance(points_[a], points_[b]), keyOf(a, b)});
            }
            Edge& edge = edges_[longest.second];
            any = any || (halved && !edge.halved);
            edge.halved = edge.halved || halved;
        });
        return any;
    }

    std::optional<std::uint32_t> middleOf(std::uint32_t a, std::uint32_t b) {
        Edge& edge = edges_[keyOf(a, b)];
        if (edge.halved && !edge.middle) edge.middle = addMiddle_(a, b);
        return edge.middle;
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles_.insert(triangles_.end(), {a, b, c}); }

    void divide(const Corners& corner) {
        std::array<std::optional<std::uint32_t>, 3> middle; // of the edge from each corner to the next
        for (std::size_t i = 0; i < 3; ++i) middle[i] = middleOf(corner[i], corner[(i + 1) % 3]);
        const auto halved = std::ranges::count_if(middle, [](const auto& m) { return m.has_value(); });
        if (halved == 0) return add(corner[0], corner[1], corner[2]);
        if (halved == 3) {
            for (std::size_t i = 0; i < 3; ++i) add(corner[i], *middle[i], *middle[(i + 2) % 3]);
            return add(*middle[0], *middle[1], *middle[2]);
        }
        // Rotate the corners so that the first edge is halved and, if two are halved, the second one as well.
        std::size_t first = 0;
        while (!middle[first] || (halved == 2 && !middle[(first + 1) % 3])) ++first;
        const std::uint32_t a = corner[first], b = corner[(first + 1) % 3], c = corner[(first + 2) % 3];
        const std::uint32_t ab = *middle[first];
        add(a, ab, c);
        if (halved == 1) return add(ab, b, c);
        const std::uint32_t bc = *middle[(first + 1) % 3];
        add(ab, b, bc);
        add(ab, bc, c);
    }

    const std::vector<glm::vec3>& points_;
    std::vector<std::uint32_t>& triangles_;
    Wants wants_;
    AddMiddle addMiddle_;
    std::unordered_map<std::uint64_t, Edge> edges_;
};

/// The normal halfway between two unit ones; the first where they are opposite.
template <class Vector>
Vector middleNormal(const Vector& a, const Vector& b) {
    const Vector sum = a + b;
    const auto length = glm::length(sum);
    return length > 0 ? sum / length : a;
}

} // namespace burin
