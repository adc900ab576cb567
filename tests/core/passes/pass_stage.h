// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/plan_pass.h"
#include "tests/core/passes/plan_stage.h"

#include <functional>
#include <memory>
#include <utility>

namespace burin::test {

inline Tool endMill(double diameter, double cornerRadius) {
    Tool tool = shankedBallTool(diameter, 40.0);
    tool.cutter.type = cornerRadius == 0.0              ? CutterType::flat
                       : cornerRadius == 0.5 * diameter ? CutterType::ball
                                                        : CutterType::bullNose;
    tool.cutter.cornerRadius = cornerRadius;
    tool.cutter.stickOut = 60.0;
    return tool;
}

/// A closed block from z = 0 up to a surface over a square grid.
inline TriangleMesh blockUnder(const std::function<double(double, double)>& top, double half, int cells) {
    TriangleMesh mesh;
    const auto corner = [&](int i) { return -half + 2.0 * half * i / cells; };
    const auto index = [&](int i, int j, bool above) {
        return static_cast<std::uint32_t>(2 * (j * (cells + 1) + i) + (above ? 1 : 0));
    };
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            mesh.vertices.emplace_back(corner(i), corner(j), 0.0);
            mesh.vertices.emplace_back(corner(i), corner(j), top(corner(i), corner(j)));
        }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            quad(index(i, j, true), index(i + 1, j, true), index(i + 1, j + 1, true), index(i, j + 1, true));
            quad(index(i, j, false), index(i, j + 1, false), index(i + 1, j + 1, false), index(i + 1, j, false));
        }
    for (int i = 0; i < cells; ++i) {
        quad(index(i, 0, false), index(i + 1, 0, false), index(i + 1, 0, true), index(i, 0, true));
        quad(index(i + 1, cells, false), index(i, cells, false), index(i, cells, true), index(i + 1, cells, true));
        quad(index(0, i + 1, false), index(0, i, false), index(0, i, true), index(0, i + 1, true));
        quad(index(cells, i, false), index(cells, i + 1, false), index(cells, i + 1, true), index(cells, i, true));
    }
    return mesh;
}

/// A part with everything that planning needs.
struct Ground {
    MeshDistance part;
    Tool tool;
    Box stock;
    std::unique_ptr<const ClearanceField> field;
    PassGround ground;

    /// @param standing what is left of the stock; empty: all of it @param fieldVoxel mm
    Ground(const TriangleMesh& mesh, const Tool& withTool, const Box& of, double allowance, StandingStock standing = {},
           double fieldVoxel = 0.5)
        : part(mesh)
        , tool(withTool)
        , stock(of)
        , field(fieldOf(allowance, fieldVoxel))
        , ground{part, field.get(), tool, stock, {}, std::move(standing), 4.0, 40.0} {}
    Ground(const Ground&) = delete; // it refers to its own members
    Ground& operator=(const Ground&) = delete;

    Result<PlannedPass> plan(const PassRequest& request) const {
        Progress progress;
        return planPass(request, ground, progress);
    }

private:
    std::unique_ptr<const ClearanceField> fieldOf(double allowance, double fieldVoxel) const {
        ToolFieldRequest request;
        request.tool = pieces(tool.cutter);
        request.tips = stock.grown(tool.cutter.diameter);
        request.tips.high.z += 20.0;
        request.voxel = fieldVoxel;
        request.maximumAllowance = std::max(allowance, 0.5);
        Progress progress;
        return std::make_unique<ToolField>(std::move(*ToolField::build(part, request, progress)));
    }
};

/// Visits points of a pass, at most 0.1 mm apart.
inline void follow(const PlannedPass& pass, const std::function<void(const glm::dvec3&)>& visit) {
    for (const TipLine& line : pass.strokes)
        for (std::size_t i = 1; i < line.size(); ++i) {
            const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(line[i - 1], line[i]) / 0.1)));
            for (int k = 0; k <= steps; ++k) visit(glm::mix(line[i - 1], line[i], static_cast<double>(k) / steps));
        }
}

} // namespace burin::test
