// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/face_patches.h"

#include "core/cad/reader/face_measure.h"
#include "core/cad/reader/measure.h"
#include "core/cad/reader/nearest_face.h"
#include "core/cad/reader/occt_vectors.h"
#include "core/cad/reader/shape_mesh.h"
#include "core/geometry/mesh_parts.h"
#include "core/geometry/triangle.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace burin {

namespace {

std::vector<TopoDS_Solid> solidsOf(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Solid> solids;
    for (TopExp_Explorer parts(shape, TopAbs_SOLID); parts.More(); parts.Next())
        solids.push_back(TopoDS::Solid(parts.Current()));
    return solids;
}

/// Sets only properties that hold for the entire face: a cone has no single radius.
PartFacePatch measuredPatch(const TopoDS_Face& face, TriangleMesh mesh) {
    MeasuredFace measured;
    const gp_Pnt on = mesh.vertices.empty() ? gp_Pnt() : toPoint(mesh.vertices.front());
    describeShape(measured, face, on);
    PartFacePatch patch;
    patch.kind = measured.kind;
    patch.radius = measured.kind == MeasuredFace::Kind::cone ? 0.0 : measured.radius;
    patch.area = std::abs(exactArea(face));
    patch.mesh = std::move(mesh);
    return patch;
}

/// Returns the centroid of the largest triangle of each face number; the origin for a number without triangles.
std::vector<glm::dvec3> largestMiddles(const SolidMesh& mesh, std::size_t count) {
    std::vector<LargestTriangle> largest(count);
    for (std::size_t i = 0; i < mesh.faceOf.size(); ++i) largest[mesh.faceOf[i]].add(cornersOf(mesh.mesh, i));
    std::vector<glm::dvec3> middles;
    for (const LargestTriangle& each : largest) middles.push_back(each.centroid());
    return middles;
}

} // namespace

std::vector<std::uint32_t> ownersOf(const TopoDS_Shape& solid, const SolidMesh& mesh) {
    const std::vector<TopoDS_Face> faces = meshedFaces(solid);
    if (!mesh.divided) {
        std::vector<std::uint32_t> same(faces.size());
        std::iota(same.begin(), same.end(), 0U);
        return same;
    }
    const auto last = std::ranges::max_element(mesh.faceOf);
    const std::size_t count = last == mesh.faceOf.end() ? 0 : std::size_t{*last} + 1;
    std::vector<std::uint32_t> owners;
    for (const glm::dvec3& middle : largestMiddles(mesh, count)) {
        const TopoDS_Face nearest = nearestFace(solid, toPoint(middle)).face;
        const auto owner = std::ranges::find_if(faces, [&](const TopoDS_Face& face) { return face.IsSame(nearest); });
        owners.push_back(static_cast<std::uint32_t>(owner - faces.begin()));
    }
    return owners;
}

Result<std::vector<PartFacePatch>> facePatches(const TopoDS_Shape& shape, double chord, bool careful,
                                               const ReportFraction& report) {
    const std::vector<TopoDS_Solid> solids = solidsOf(shape);
    std::vector<PartFacePatch> patches;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const auto part = [&](double fraction) {
            report((static_cast<double>(i) + fraction) / static_cast<double>(solids.size()));
        };
        SolidMesh mesh = meshSolid(solids[i], chord, part, careful);
        const std::vector<TopoDS_Face> faces = meshedFaces(solids[i]);
        if (mesh.facesWithoutTriangles > 0)
            return Error{ErrorCode::meshIncomplete,
                         {},
                         std::to_string(mesh.facesWithoutTriangles) + " of " + std::to_string(faces.size()) +
                             " faces of \"B-rep\"",
                         {}};
        const std::vector<std::uint32_t> owners = ownersOf(solids[i], mesh);
        for (std::uint32_t& face : mesh.faceOf) face = owners[face];
        std::vector<TriangleMesh> parts = partsOf(mesh.mesh, mesh.faceOf, faces.size());
        for (std::size_t face = 0; face < faces.size(); ++face)
            patches.push_back(measuredPatch(faces[face], std::move(parts[face])));
    }
    return patches;
}

} // namespace burin
