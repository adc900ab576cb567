// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "path_fixture.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

/// A block of stock, tools with short flutes, and checks that represent the stock as a height map.
namespace burin::test {

inline constexpr double voxel = 0.25; // mm
/// mm, a voxel plus the enlargement of the tool by the check: neither its grid nor the oracle's resolves a surface
/// better.
inline constexpr double blur = 0.3;
inline const Box block{{-10, -10, -16}, {10, 10, 0}};

inline Result<void> lendBlock(const StockUse& use, Progress&) {
    PropertyList list;
    Property property;
    property.id = "block";
    if (!list.add(property)) return Error{ErrorCode::internalFault, "block", "", ""};
    Result<RunVolume> volume = RunVolume::make(*Grid::make(block.low, voxel, {80, 80, 64}), list);
    if (!volume) return volume.error();
    volume->fillBlock({0, 0}, {80, 80}, 0, volume->grid().lineEnd(), 1);
    return use(*volume);
}

/// The flutes are short, the shank is wider than the flutes, the holder is near.
inline Tool stubbyTool(CutterType type) {
    Tool tool = type == CutterType::ball ? ballTool(4.0) : flatTool(4.0);
    tool.cutter.fluteLength = 6.0;
    tool.cutter.shankDiameter = 5.0;
    tool.cutter.stickOut = 9.0;
    tool.cutter.holder = {{10.0, 10.0, 20.0}};
    return tool;
}

inline PathContext blockContext(const Tool& tool) {
    static const MeshDistance nothing{TriangleMesh{}};
    PathContext context = contextOf(nothing, tool, block);
    context.lendStock = lendBlock;
    return context;
}

/// The stock as the lowest heights left by the flutes, open from above, at points a short distance apart.
class Heights {
public:
    static constexpr double apart = 0.25, walked = 0.1; // mm, between points and between poses
    Heights() : heights_(side * side, block.high.z) {}
    void cut(const Cutter& cutter, const glm::dvec3& tip) {
        forEachWithin(tip, cutter.radius(), [&](double& height, double across) {
            // The stock stays above the flutes: this height map has no overhangs, so that it is too high there. The
            // flutes have been higher by one step of the sampling.
            if (height > tip.z + cutter.fluteLength + walked) return;
            const double rise =
                cutter.type == CutterType::ball
                    ? cutter.radius() - std::sqrt(std::max(0.0, cutter.radius() * cutter.radius() - across * across))
                    : 0.0;
            height = std::min(height, tip.z + rise);
        });
    }
    double highestWithin(const glm::dvec3& tip, double radius) {
        double highest = -1e9;
        forEachWithin(tip, radius, [&](double& height, double) { highest = std::max(highest, height); });
        return highest;
    }

private:
    static constexpr int side = 80;
    void forEachWithin(const glm::dvec3& tip, double radius, const std::function<void(double&, double)>& visit) {
        const auto cell = [](double along, double low) {
            return std::clamp(static_cast<int>(std::floor((along - low) / apart)), 0, side - 1);
        };
        for (int y = cell(tip.y - radius, block.low.y); y <= cell(tip.y + radius, block.low.y); ++y)
            for (int x = cell(tip.x - radius, block.low.x); x <= cell(tip.x + radius, block.low.x); ++x) {
                const glm::dvec2 at = glm::dvec2(block.low) + apart * glm::dvec2(x + 0.5, y + 0.5);
                const double across = glm::distance(at, glm::dvec2(tip));
                if (across < radius) visit(heights_[static_cast<std::size_t>(y * side + x)], across);
            }
    }
    std::vector<double> heights_;
};

/// The greatest depth of shank or holder in the remaining stock along all moves, mm; a depth within the blur of a wall
/// does not count.
inline double deepestGuard(const std::vector<PathPoint>& points, const Cutter& cutter) {
    Heights left;
    double deepest = 0.0;
    walk(points, Heights::walked, [&](const PathPoint& end, const glm::dvec3& tip) {
        if (tip.z + cutter.fluteLength < block.high.z)
            deepest = std::max(deepest,
                               left.highestWithin(tip, 0.5 * cutter.shankDiameter - blur) - tip.z - cutter.fluteLength);
        if (tip.z + cutter.stickOut < block.high.z)
            deepest = std::max(deepest, left.highestWithin(tip, 0.5 * cutter.holder.front().lowerDiameter - blur) -
                                            tip.z - cutter.stickOut);
        if (end.kind != MoveKind::rapid) left.cut(cutter, tip);
    });
    return deepest;
}

inline const EditReport& reportOf(const EvaluatedPath& path, std::string_view edit) {
    return *std::ranges::find(path.reports, edit, &EditReport::edit);
}

inline TriangleMesh meshOf(const std::vector<Box>& boxes) {
    TriangleMesh all;
    for (const Box& box : boxes) {
        const TriangleMesh mesh = boxMesh(box);
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (const auto& [a, b, c] : mesh.triangles) all.triangles.push_back({a + first, b + first, c + first});
    }
    return all;
}

} // namespace burin::test
