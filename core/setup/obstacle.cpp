// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/obstacle.h"

#include "core/base/units.h"
#include "core/geometry/frame_along.h"
#include "core/geometry/pose.h"
#include "core/setup/round_sides.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

TriangleMesh meshOf(const Box& box) {
    TriangleMesh mesh;
    for (unsigned i = 0; i < 8; ++i) mesh.vertices.push_back(box.corner(i));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// Returns a prism circumscribed about the cylinder.
TriangleMesh meshOf(const CylinderShape& cylinder) {
    const glm::dvec3 x = anyAcross(cylinder.axis), y = glm::cross(cylinder.axis, x);
    const std::uint32_t sides = sidesAround(cylinder.radius, cylinderChord);
    const double radius = cornerRadius(cylinder.radius, sides);
    TriangleMesh mesh;
    const glm::dvec3 rise = cylinder.height * cylinder.axis;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = 2.0 * pi * i / sides;
        const glm::dvec3 place = cylinder.base + radius * (std::cos(angle) * x + std::sin(angle) * y);
        mesh.vertices.push_back(place);
        mesh.vertices.push_back(place + rise);
    }
    const std::uint32_t bottom = 2 * sides, top = bottom + 1;
    mesh.vertices.push_back(cylinder.base);
    mesh.vertices.push_back(cylinder.base + rise);
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
        mesh.triangles.push_back({a, b, b + 1});
        mesh.triangles.push_back({a, b + 1, a + 1});
        mesh.triangles.push_back({bottom, b, a});
        mesh.triangles.push_back({top, a + 1, b + 1});
    }
    return mesh;
}

TriangleMesh meshOf(const TriangleMesh& mesh) {
    return mesh;
}

Box boundsOf(const Box& box) {
    return box;
}

Box boundsOf(const CylinderShape& cylinder) {
    return boxAround(cylinder);
}

Box boundsOf(const TriangleMesh& mesh) {
    return boundingBox(mesh);
}

bool same(const Box& one, const Box& other) {
    return one.low == other.low && one.high == other.high;
}

bool same(const CylinderShape& one, const CylinderShape& other) {
    return one == other;
}

bool same(const TriangleMesh& one, const TriangleMesh& other) {
    return one.vertices == other.vertices && one.triangles == other.triangles;
}

/// The error in a shape, and what is allowed instead.
struct ShapeFault {
    const char* what = nullptr; ///< null: no error
    const char* allowed = nullptr;
};

ShapeFault faultOf(const Box& box) {
    const glm::dvec3 size = box.size();
    if (isFinite(box.low) && isFinite(box.high) && size.x > 0.0 && size.y > 0.0 && size.z > 0.0) return {};
    return {"box", "two finite corners, each coordinate of the second above the first's"};
}

ShapeFault faultOf(const CylinderShape& cylinder) {
    if (!isFinite(cylinder.base)) return {"base", "a finite position"};
    if (!(std::abs(glm::length(cylinder.axis) - 1.0) < 1e-6)) return {"axis", "a direction of unit length"};
    if (!(std::isfinite(cylinder.radius) && cylinder.radius > 0.0)) return {"radius", "a finite length above 0 mm"};
    if (!(std::isfinite(cylinder.height) && cylinder.height > 0.0)) return {"height", "a finite length above 0 mm"};
    return {};
}

ShapeFault faultOf(const TriangleMesh& mesh) {
    const auto inRange = [&](std::uint32_t corner) { return corner < mesh.vertices.size(); };
    if (mesh.empty() || !std::ranges::all_of(mesh.triangles, [&](const auto& triangle) {
            return std::ranges::all_of(triangle, inRange);
        }))
        return {"mesh", "triangles between vertices that are there"};
    if (!std::ranges::all_of(mesh.vertices, [](const glm::dvec3& place) { return isFinite(place); }))
        return {"mesh", "vertices with finite coordinates"};
    return {};
}

std::string openEdges(std::size_t count) {
    return std::to_string(count) + " open edges";
}

} // namespace

bool operator==(const Obstacle& one, const Obstacle& other) {
    if (one.name != other.name || one.margin != other.margin || one.on != other.on || one.kind != other.kind ||
        one.shape.index() != other.shape.index() || one.design != other.design)
        return false;
    return std::visit(
        [&](const auto& shape) { return same(shape, std::get<std::decay_t<decltype(shape)>>(other.shape)); },
        one.shape);
}

Result<void> checkObstacle(const Obstacle& obstacle) {
    if (!(std::isfinite(obstacle.margin) && obstacle.margin >= 0.0))
        return Error{ErrorCode::argumentInvalid, obstacle.name, "margin", "a finite length of 0 mm or more"};
    const ShapeFault fault = std::visit([](const auto& shape) { return faultOf(shape); }, obstacle.shape);
    if (fault.what != nullptr) return Error{ErrorCode::argumentInvalid, obstacle.name, fault.what, fault.allowed};
    if (const auto* mesh = std::get_if<TriangleMesh>(&obstacle.shape)) {
        const TriangleMesh welded = weldIdenticalVertices(*mesh);
        if (const std::size_t open = countOpenEdges(welded); open > 0)
            return Error{ErrorCode::modelNotWatertight, obstacle.name, openEdges(open), {}};
        if (!(signedVolume(welded) > 0.0))
            return Error{ErrorCode::modelNotWatertight, obstacle.name, "its triangles face inwards", {}};
    }
    return {};
}

Box boundsOf(const Obstacle& obstacle) {
    return std::visit([](const auto& shape) { return boundsOf(shape); }, obstacle.shape);
}

Result<std::vector<Obstacle>> fixturesOf(const Model& model, const std::string& name, double margin) {
    if (model.bodies.empty()) return Error{ErrorCode::modelHasNoSolid, model.sourceFile, "no body", {}};
    std::vector<Obstacle> fixtures;
    for (const Body& body : model.bodies) {
        TriangleMesh mesh = weldIdenticalVertices(body.mesh);
        if (const std::size_t open = countOpenEdges(mesh); open > 0)
            return Error{ErrorCode::modelNotWatertight, model.sourceFile, body.name + ": " + openEdges(open), {}};
        if (signedVolume(mesh) < 0.0)
            for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
        Obstacle fixture;
        fixture.name = model.bodies.size() == 1 ? name : name + ": " + body.name;
        fixture.shape = std::move(mesh);
        fixture.margin = margin;
        if (Result<void> usable = checkObstacle(fixture); !usable) return std::move(usable).error();
        fixtures.push_back(std::move(fixture));
    }
    return fixtures;
}

std::vector<ObstacleSolid> solidsOf(std::span<const Obstacle> obstacles) {
    std::vector<ObstacleSolid> solids;
    solids.reserve(obstacles.size());
    for (const Obstacle& obstacle : obstacles)
        solids.push_back({std::make_shared<const MeshDistance>(meshOf(obstacle)), obstacle.margin, obstacle.on});
    return solids;
}

TriangleMesh meshOf(const Obstacle& obstacle) {
    return std::visit([](const auto& shape) { return meshOf(shape); }, obstacle.shape);
}

} // namespace burin
