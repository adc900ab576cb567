// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/mesh_model.h"

#include "core/base/numbers.h"
#include "core/cad/import_notes.h"
#include "core/cad/reader/mesh_repair.h"

#include <cmath>
#include <utility>

namespace burin {

using import_notes::fill;

namespace {

/// If more than this share of its edges are open, a mesh is a loose set of triangles and not the surface of a solid.
constexpr double mostOpen = 1.0 / 3.0;
/// Relative to the area to the power of 1.5: a smaller volume of a plate is only rounding error. A foil of 1 m and 1 µm
/// has 400 times as much.
constexpr double flat = 1e-9;

std::string title(const Body& body) {
    return "\"" + body.name + "\"";
}

void notePieces(Model& model, const Body& body, std::size_t pieces) {
    if (pieces > 1)
        addNote(model, ImportNote::Kind::warning,
                fill(import_notes::piecesApart, {title(body), std::to_string(pieces)}));
}

Body makeBody(Model& model, MeshSolid solid, MeshConnection& connection) {
    Body body;
    body.name =
        solid.name.empty() ? fill(import_notes::unnamedBody, {std::to_string(model.bodies.size() + 1)}) : solid.name;
    body.colour = solid.colour;
    body.mesh = std::move(solid.mesh);
    for (glm::dvec3& vertex : body.mesh.vertices) vertex *= model.unitScale;
    connection = separatePieces(body.mesh);
    if (const std::size_t turned = orientConsistently(body.mesh); turned > 0)
        addNote(model, ImportNote::Kind::healing,
                fill(import_notes::trianglesTurned, {title(body), std::to_string(turned)}));
    body.volume = signedVolume(body.mesh);
    body.area = surfaceArea(body.mesh);
    body.box = boundingBox(body.mesh);
    body.openEdges = countOpenEdges(body.mesh);
    if (body.openEdges > 0)
        addNote(model, ImportNote::Kind::warning,
                fill(import_notes::stlOpen, {title(body), std::to_string(body.openEdges)}));
    if (!(std::abs(body.volume) > flat * std::pow(body.area, 1.5)))
        addNote(model, ImportNote::Kind::warning, fill(import_notes::noVolume, {title(body)}));
    notePieces(model, body, connection.pieces);
    return body;
}

} // namespace

void addNote(Model& model, ImportNote::Kind kind, std::string text) {
    model.notes.push_back({kind, std::move(text)});
}

Result<Model> withBodies(Model model, std::vector<MeshSolid> solids) {
    std::size_t triangles = 0, edges = 0, boundary = 0;
    for (MeshSolid& solid : solids) {
        MeshConnection connection;
        triangles += solid.mesh.triangles.size();
        model.bodies.push_back(makeBody(model, std::move(solid), connection));
        edges += connection.edges;
        boundary += connection.boundaryEdges;
    }
    if (triangles == 0) return Error{ErrorCode::modelHasNoSolid, {}, "no triangles", {}};
    if (static_cast<double>(boundary) > mostOpen * static_cast<double>(edges))
        return Error{ErrorCode::modelHasNoSolid,
                     {},
                     std::to_string(triangles) + " triangles with " + std::to_string(boundary) + " open edges",
                     {}};
    return model;
}

void takeUnit(Model& model, double millimetres) {
    const bool isStl = model.format.starts_with("STL");
    model.lengthUnit = "none";
    model.unitScale = millimetres;
    addNote(model, ImportNote::Kind::unit,
            fill(isStl ? import_notes::stlWithoutUnit : import_notes::fileWithoutUnit, {formatShortest(millimetres)}));
}

} // namespace burin
