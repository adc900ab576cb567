// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace burin::test {

/// Surface nets of a whole volume at full detail on a dense grid of doubles, node by node: slow and obvious.
class DenseSurfaceNet {
public:
    /// Identified by its lowest node; counts along u, v and the runs.
    using Cube = std::array<int, 3>;
    struct Point {
        glm::dvec3 place;    ///< voxels from the grid's low corner, along u, v and the runs
        glm::dvec3 gradient; ///< direction of steepest descent, along u, v and the runs
    };

    explicit DenseSurfaceNet(const VolumeSnapshot& volume) : grid_(volume.grid()) {
        size_ = glm::ivec3(grid_.lineCountU(), grid_.lineCountV(), grid_.voxelsPerLine()) + 2 * border;
        std::vector<double> seen(static_cast<std::size_t>(size_.x * size_.y * size_.z), 0.0);
        each(glm::ivec3(0), size_, [&](glm::ivec3 node) {
            const LineIndex line{node.x - border, node.y - border};
            if (grid_.contains(line)) seen[index(node)] = solidAround(volume.line(line), node.z - border);
        });
        values_ = averaged(averaged(seen, {1, 0, 0}), {0, 1, 0});
        smooth_ = averaged(averaged(averaged(values_, {1, 0, 0}), {0, 1, 0}), {0, 0, 1});
        each(glm::ivec3(2), size_ - 3, [&](glm::ivec3 node) {
            addPoint(node);
            for (int axis = 0; axis < 3; ++axis) addFace(node, axis);
        });
    }

    const std::map<Cube, Point>& points() const { return points_; }
    /// Cubes whose points lie within a given distance of a point, in rising order. More than one where points of
    /// adjacent cubes coincide.
    std::vector<Cube> cubesAt(const glm::dvec3& place, double distance) const {
        std::vector<Cube> found;
        each(glm::ivec3(-1), glm::ivec3(2), [&](glm::ivec3 side) { // it may lie on a face of its cube
            const glm::ivec3 lowest(glm::floor(place - 0.5 + distance * glm::dvec3(side)));
            const auto at = points_.find({lowest.x, lowest.y, lowest.z});
            if (at != points_.end() && glm::length(at->second.place - place) <= distance) found.push_back(at->first);
        });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }
    /// The four cubes around each crossed edge, each list sorted.
    const std::multiset<std::array<Cube, 4>>& faces() const { return faces_; }

private:
    static constexpr int border = 5; ///< nodes around the grid

    std::size_t index(glm::ivec3 node) const {
        return static_cast<std::size_t>((node.x * size_.y + node.y) * size_.z + node.z);
    }
    template <class Visit>
    static void each(glm::ivec3 low, glm::ivec3 high, Visit visit) {
        for (int u = low.x; u < high.x; ++u)
            for (int v = low.y; v < high.y; ++v)
                for (int n = low.z; n < high.z; ++n) visit(glm::ivec3(u, v, n));
    }
    /// Share of solid within one voxel on either side of a voxel's centre, minus a half.
    static double solidAround(std::span<const Segment> line, int voxel) {
        const double low = (voxel - 0.5) * unitsPerVoxel, high = (voxel + 1.5) * unitsPerVoxel;
        double solid = 0.0, begin = 0.0;
        for (const Segment segment : line) {
            const double end = segment.end();
            if (segment.property() != airProperty) solid += std::max(std::min(end, high) - std::max(begin, low), 0.0);
            begin = end;
        }
        return solid / (high - low);
    }
    std::vector<double> averaged(const std::vector<double>& values, glm::ivec3 step) const {
        std::vector<double> result(values.size(), 0.0);
        each(glm::ivec3(1), size_ - 1, [&](glm::ivec3 node) {
            result[index(node)] =
                0.25 * (values[index(node - step)] + 2.0 * values[index(node)] + values[index(node + step)]);
        });
        return result;
    }
    bool inside(glm::ivec3 node) const { return values_[index(node)] >= 0.5; }
    static glm::ivec3 along(int axis) { return {axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0}; }
    static Cube cube(glm::ivec3 node) { return {node.x - border, node.y - border, node.z - border}; }

    void addPoint(glm::ivec3 node) {
        glm::dvec3 sum(0.0);
        int crossings = 0;
        each(glm::ivec3(0), glm::ivec3(2), [&](glm::ivec3 corner) {
            for (int axis = 0; axis < 3; ++axis) {
                if (corner[axis] != 0) continue;
                const glm::ivec3 from = node + corner, to = from + along(axis);
                if (inside(from) == inside(to)) continue;
                const double share = (0.5 - values_[index(from)]) / (values_[index(to)] - values_[index(from)]);
                sum += glm::dvec3(corner) + share * glm::dvec3(along(axis));
                ++crossings;
            }
        });
        if (crossings == 0) return;
        const glm::dvec3 within = sum / static_cast<double>(crossings);
        glm::dvec3 gradient(0.0);
        each(glm::ivec3(0), glm::ivec3(2), [&](glm::ivec3 corner) {
            for (int axis = 0; axis < 3; ++axis) {
                double weight = corner[axis] == 0 ? 1.0 : -1.0; // downhill
                for (int other = 0; other < 3; ++other)
                    if (other != axis) weight *= corner[other] == 0 ? 1.0 - within[other] : within[other];
                gradient[axis] += weight * smooth_[index(node + corner)];
            }
        });
        points_[cube(node)] = {glm::dvec3(node - border) + 0.5 + within, gradient};
    }
    void addFace(glm::ivec3 node, int axis) {
        if (inside(node) == inside(node + along(axis))) return;
        const glm::ivec3 a = along((axis + 1) % 3), b = along((axis + 2) % 3);
        std::array<Cube, 4> around{cube(node - a - b), cube(node - a), cube(node - b), cube(node)};
        std::sort(around.begin(), around.end());
        faces_.insert(around);
    }

    Grid grid_;
    glm::ivec3 size_{0};
    std::vector<double> values_, smooth_;
    std::map<Cube, Point> points_;
    std::multiset<std::array<Cube, 4>> faces_;
};

} // namespace burin::test
