// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool_solid.h"

#include "core/base/degrees.h"
#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/geometry/mesh_parts.h"
#include "core/tool/hollow_tip.h"
#include "core/tool/tool.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

namespace burin {

namespace {

constexpr NumberRange solidCoordinate{-1000.0, 1000.0}; // mm
constexpr NumberRange sectionCoordinate{0.0, 1000.0};   // mm
constexpr NumberRange solidTurn{-360.0, 360.0};         // degrees
constexpr double solidFit = 1e-3;                       // mm, between a model and the profile around it

Error badSolid(const char* key, std::string value, std::string allowed) {
    return {ErrorCode::argumentInvalid, std::string("cutter.") + key, std::move(value), std::move(allowed)};
}

Result<void> checkMesh(const char* key, const TriangleMesh& mesh) {
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            if (vertex >= mesh.vertices.size())
                return badSolid(key, std::to_string(vertex), "triangles of the vertices that are there");
    if (const std::size_t open = countOpenEdges(weldIdenticalVertices(mesh)); open > 0)
        return badSolid(key, std::to_string(open), "a closed surface; close its holes");
    return {};
}

bool holdsPoint(const RevolvedPiece& piece, const glm::dvec3& point) {
    return signedDistance(piece, std::hypot(point.x, point.y), point.z) <= solidFit;
}

/// Whether what an edge has between the faces of a piece lies in it. The piece is convex, so the ends of that part
/// decide. Closer to a face than `solidFit`, the edge may belong to the adjacent piece.
bool holdsEdge(const RevolvedPiece& piece, const glm::dvec3& one, const glm::dvec3& other) {
    const auto& [low, high] = one.z < other.z ? std::tie(one, other) : std::tie(other, one);
    const double from = std::max(low.z, piece.bottom + solidFit), to = std::min(high.z, piece.top - solidFit);
    if (!(from < to)) return true;
    const auto at = [&](double height) { return glm::mix(low, high, (height - low.z) / (high.z - low.z)); };
    return holdsPoint(piece, at(from)) && holdsPoint(piece, at(to));
}

/// Whether a mesh lies in the pieces, which are stacked: between two faces, a triangle is the hull of its edges' parts.
bool isWithin(const TriangleMesh& mesh, const std::vector<RevolvedPiece>& pieces) {
    const bool corners = std::ranges::all_of(mesh.vertices, [&](const glm::dvec3& vertex) {
        return std::ranges::any_of(pieces, [&](const RevolvedPiece& piece) { return holdsPoint(piece, vertex); });
    });
    return corners && std::ranges::all_of(mesh.triangles, [&](const auto& triangle) {
               return std::ranges::all_of(pieces, [&](const RevolvedPiece& piece) {
                   for (std::size_t i = 0; i < 3; ++i)
                       if (!holdsEdge(piece, mesh.vertices[triangle[i]], mesh.vertices[triangle[(i + 1) % 3]]))
                           return false;
                   return true;
               });
           });
}

/// Checks the section of a tool that turns; it is compared with the profile in a half-plane through the axis.
Result<void> checkSection(const Cutter& cutter) {
    std::size_t count = 0;
    for (const PlanRing& ring : cutter.solid->section.rings) {
        count += ring.size();
        if (ring.size() < 3) return badSolid("section", std::to_string(ring.size()), "3 corners or more in each ring");
    }
    if (count > ToolSolid::mostCorners)
        return badSolid("section", std::to_string(count),
                        "at most " + std::to_string(ToolSolid::mostCorners) + " corners");
    const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
    const auto inHalfPlane = [](const glm::dvec2& corner) { return glm::dvec3(corner.x, 0.0, corner.y); };
    for (const PlanRing& ring : cutter.solid->section.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec3 from = inHalfPlane(ring[i]), to = inHalfPlane(ring[(i + 1) % ring.size()]);
            const auto holdsCorner = [&](const RevolvedPiece& piece) { return holdsPoint(piece, from); };
            const auto holdsSide = [&](const RevolvedPiece& piece) { return holdsEdge(piece, from, to); };
            if (std::ranges::none_of(flutes, holdsCorner) || !std::ranges::all_of(flutes, holdsSide))
                return badSolid("section", formatShortest(ring[i].x) + ", " + formatShortest(ring[i].y),
                                "inside the profile: make the tool from its models again");
        }
    if (cutter.solid->flutes.empty()) return badSolid("section", {}, "an area");
    return {};
}

/// Flat lists of numbers: [x, y, z, x, …] and [a, b, c, a, …].
void readSolidMesh(JsonObject& from, const char* key, TriangleMesh& mesh) {
    from.object(key, [&](JsonObject& model) {
        const std::vector<double> places = model.numbers("vertices_mm", solidCoordinate, 3);
        for (std::size_t i = 0; i + 2 < places.size(); i += 3)
            mesh.vertices.emplace_back(places[i], places[i + 1], places[i + 2]);
        const std::vector<double> corners =
            model.numbers("triangles", {0.0, static_cast<double>(3 * ToolSolid::mostTriangles)}, 3);
        if (std::ranges::any_of(corners, [](double corner) { return corner != std::floor(corner); }))
            model.fail("triangles", "has to be whole numbers");
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            mesh.triangles.push_back({static_cast<std::uint32_t>(corners[i]),
                                      static_cast<std::uint32_t>(corners[i + 1]),
                                      static_cast<std::uint32_t>(corners[i + 2])});
    });
}

nlohmann::ordered_json solidMeshJson(const TriangleMesh& mesh) {
    nlohmann::ordered_json places = nlohmann::ordered_json::array(), corners = nlohmann::ordered_json::array();
    for (const glm::dvec3& vertex : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) places.push_back(vertex[axis]);
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) corners.push_back(corner);
    return {{"vertices_mm", std::move(places)}, {"triangles", std::move(corners)}};
}

} // namespace

TriangleMesh turnedAboutAxis(const TriangleMesh& mesh, double angle) {
    TriangleMesh turned = mesh;
    place(turned, turnedAbout({0.0, 0.0, 1.0}, angle, glm::dvec3(0.0)));
    return turned;
}

Result<void> validateSolid(const Cutter& cutter) {
    const ToolSolid& solid = *cutter.solid;
    const std::size_t triangles = solid.flutes.triangles.size() + solid.shank.triangles.size();
    if (cutter.type != CutterType::profile)
        return badSolid("type", std::string(cutterTypeName(cutter.type)),
                        solid.turns() ? "profile: the tip is hollow" : "profile: the tool doesn't turn");
    if (solid.turns()) return checkSection(cutter);
    if (solid.flutes.empty() || triangles > ToolSolid::mostTriangles)
        return badSolid("flutes_mesh", std::to_string(triangles),
                        "1 to " + std::to_string(ToolSolid::mostTriangles) + " triangles");
    // As it is written, so that it can be read again.
    if (const double angle = roundedDegrees(solid.angle); !(std::abs(angle) <= solidTurn.high))
        return badSolid("angle_deg", formatShortest(angle), "a number from -360 to 360");
    if (Result<void> flutes = checkMesh("flutes_mesh", solid.flutes); !flutes) return flutes;
    if (Result<void> shank = checkMesh("shank_mesh", solid.shank); !shank) return shank;
    const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
    if (!isWithin(solid.flutes, flutes))
        return badSolid("flutes_mesh", {}, "inside the profile: make the tool from its models again");
    if (!isWithin(solid.shank, pieces(cutter)))
        return badSolid("shank_mesh", {}, "inside the shank: make the tool from its models again");
    if (!solid.shank.empty() && std::abs(boundingBox(solid.shank).high.z - cutter.stickOut) > solidFit)
        return badSolid("stick_out_mm", formatShortest(cutter.stickOut), "the height of the model of the shank");
    return {};
}

ToolSolid readSolid(JsonObject& from) {
    ToolSolid solid;
    solid.angle = from.number("angle_deg", solidTurn) * pi / 180.0;
    readSolidMesh(from, "flutes_mesh", solid.flutes);
    if (from.has("shank_mesh")) readSolidMesh(from, "shank_mesh", solid.shank);
    return solid;
}

ToolSolid readTurningSolid(JsonObject& from, std::span<const ProfileElement> profile) {
    PlanRegion section;
    from.objects("section", [&](JsonObject& ring) {
        const std::vector<double> places = ring.numbers("corners_mm", sectionCoordinate, 2);
        PlanRing& corners = section.rings.emplace_back();
        for (std::size_t i = 0; i + 1 < places.size(); i += 2) corners.emplace_back(places[i], places[i + 1]);
    });
    if (section.empty()) from.fail("section", "has to hold a ring at least");
    return turningSolid(std::move(section), profile);
}

void writeSolid(const ToolSolid& solid, nlohmann::ordered_json& cutter) {
    if (solid.turns()) {
        cutter["section"] = nlohmann::ordered_json::array();
        for (const PlanRing& ring : solid.section.rings) {
            nlohmann::ordered_json corners = nlohmann::ordered_json::array();
            for (const glm::dvec2& corner : ring) {
                corners.push_back(corner.x);
                corners.push_back(corner.y);
            }
            cutter["section"].push_back({{"corners_mm", std::move(corners)}});
        }
        return;
    }
    cutter["turns"] = false;
    cutter["angle_deg"] = roundedDegrees(solid.angle);
    cutter["flutes_mesh"] = solidMeshJson(solid.flutes);
    if (!solid.shank.empty()) cutter["shank_mesh"] = solidMeshJson(solid.shank);
}

} // namespace burin
