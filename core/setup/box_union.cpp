// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/box_union.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace burin {

namespace {

constexpr double sameCoordinate = 1e-9; // mm

/// The planes of all faces cut space into cells; each is solid or not as a whole.
class CellGrid {
public:
    CellGrid(std::span<const Box> boxes, std::span<const Box> cutAway) : boxes_(boxes), cutAway_(cutAway) {
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double>& planes = planes_[static_cast<std::size_t>(axis)];
            for (const std::span<const Box> group : {boxes, cutAway})
                for (const Box& box : group) planes.insert(planes.end(), {box.low[axis], box.high[axis]});
            std::ranges::sort(planes);
            const auto [first, last] =
                std::ranges::unique(planes, [](double one, double other) { return other - one < sameCoordinate; });
            planes.erase(first, last);
        }
    }

    TriangleMesh surface() {
        glm::ivec3 cell;
        for (cell.x = 0; cell.x < cells(0); ++cell.x)
            for (cell.y = 0; cell.y < cells(1); ++cell.y)
                for (cell.z = 0; cell.z < cells(2); ++cell.z)
                    if (isSolid(cell)) addFaces(cell);
        return std::move(mesh_);
    }

private:
    int cells(int axis) const { return static_cast<int>(planes_[static_cast<std::size_t>(axis)].size()) - 1; }
    double plane(int axis, int number) const {
        return planes_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(number)];
    }

    bool isSolid(const glm::ivec3& cell) const {
        glm::dvec3 middle;
        for (int axis = 0; axis < 3; ++axis) {
            if (cell[axis] < 0 || cell[axis] >= cells(axis)) return false;
            middle[axis] = 0.5 * (plane(axis, cell[axis]) + plane(axis, cell[axis] + 1));
        }
        const auto holds = [&](const Box& box) { return box.contains(middle); };
        return std::ranges::any_of(boxes_, holds) && std::ranges::none_of(cutAway_, holds);
    }

    void addFaces(const glm::ivec3& cell) {
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
                glm::ivec3 neighbour = cell;
                neighbour[axis] += side == 0 ? -1 : 1;
                if (!isSolid(neighbour)) addFace(cell, axis, side);
            }
    }

    void addFace(const glm::ivec3& cell, int axis, int side) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<std::uint32_t, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i) {
            glm::ivec3 corner = cell;
            corner[axis] += side;
            corner[u] += i == 1 || i == 2 ? 1 : 0;
            corner[v] += i >= 2 ? 1 : 0;
            corners[i] = vertexAt(corner);
        }
        if (side == 0) std::swap(corners[1], corners[3]);
        mesh_.triangles.push_back({corners[0], corners[1], corners[2]});
        mesh_.triangles.push_back({corners[0], corners[2], corners[3]});
    }

    std::uint32_t vertexAt(const glm::ivec3& corner) {
        const auto [found, isNew] =
            vertices_.try_emplace({corner.x, corner.y, corner.z}, static_cast<std::uint32_t>(mesh_.vertices.size()));
        if (isNew) mesh_.vertices.emplace_back(plane(0, corner.x), plane(1, corner.y), plane(2, corner.z));
        return found->second;
    }

    std::span<const Box> boxes_, cutAway_;
    std::array<std::vector<double>, 3> planes_; ///< of each axis, ascending
    std::map<std::array<int, 3>, std::uint32_t> vertices_;
    TriangleMesh mesh_;
};

} // namespace

TriangleMesh boxUnion(std::span<const Box> boxes, std::span<const Box> cutAway) {
    return boxes.empty() ? TriangleMesh{} : CellGrid(boxes, cutAway).surface();
}

} // namespace burin
