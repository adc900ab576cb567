// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/part_faces.h"

#include "core/cad/face_neighbours.h"
#include "core/cad/worker_process.h"
#include "core/geometry/mesh_parts.h"
#include "core/geometry/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <variant>

namespace burin {

namespace {

using Kind = MeasuredFace::Kind;

constexpr double flatRegion = 1e-3; // mm: the single precision of STL files distorts a plane by no more
constexpr std::uint32_t noRegion = std::numeric_limits<std::uint32_t>::max();

/// The region of each triangle; `noRegion` for triangles without area, and for those not reached before a cancellation.
struct MeshRegions {
    std::vector<std::uint32_t> regionOf;
    std::uint32_t count = 0;

    MeshRegions(const TriangleMesh& mesh, const Progress& progress) : regionOf(mesh.triangles.size(), noRegion) {
        const FaceNeighbours neighbours(mesh);
        std::vector<std::size_t> open;
        for (std::size_t first = 0; first < regionOf.size() && !progress.cancelled(); ++first) {
            if (regionOf[first] != noRegion || neighbours.normal(first) == glm::dvec3(0.0)) continue;
            const std::uint32_t region = count++;
            regionOf[first] = region;
            open.push_back(first);
            while (!open.empty()) {
                const std::size_t triangle = open.back();
                open.pop_back();
                for (int side = 0; side < 3; ++side) {
                    const auto next = neighbours.beside(triangle, side);
                    if (!next || regionOf[*next] != noRegion) continue;
                    regionOf[*next] = region;
                    open.push_back(*next);
                }
            }
        }
    }
};

bool isFlat(const TriangleMesh& mesh) {
    glm::dvec3 sum(0.0);
    for (const auto& [a, b, c] : mesh.triangles)
        sum += areaNormal({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    const double length = glm::length(sum);
    if (!(length > 0.0)) return false;
    const glm::dvec3 normal = sum / length, place = mesh.vertices.front();
    return std::ranges::all_of(mesh.vertices, [&](const glm::dvec3& vertex) {
        return std::abs(glm::dot(vertex - place, normal)) <= flatRegion;
    });
}

Result<std::vector<PartFacePatch>> regionsOf(const Model& model, Progress& progress) {
    std::vector<PartFacePatch> patches;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const TriangleMesh& mesh = model.bodies[i].mesh;
        const MeshRegions regions(mesh, progress);
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "faces", {}, {}};
        for (TriangleMesh& part : partsOf(mesh, regions.regionOf, regions.count)) {
            const Kind kind = isFlat(part) ? Kind::plane : Kind::other;
            const double area = surfaceArea(part);
            patches.push_back({kind, 0.0, area, std::move(part)});
        }
        progress.report(static_cast<double>(i + 1) / static_cast<double>(model.bodies.size()));
    }
    return patches;
}

} // namespace

Result<std::vector<PartFacePatch>> partFaces(const Model& model, const ImportOptions& options, Progress& progress) try {
    const std::string subject = "B-rep";
    if (model.bodies.empty()) return Error{ErrorCode::argumentInvalid, "part", {}, "a model with at least one body"};
    if (model.brep.empty()) return regionsOf(model, progress);
    const bool meshed = std::isfinite(model.meshChord) && model.meshChord > 0.0;
    PatchRequest request{model.brep, model.brepSolids, meshed ? model.meshChord : options.meshChord};
    auto answers = runWorkers({request}, options, subject, progress);
    if (!answers && answers.error().code == ErrorCode::importCrashed) {
        request.careful = true;
        answers = runWorkers({request}, options, subject, progress);
    }
    if (!answers) return std::move(answers).error();
    auto* patches = std::get_if<std::vector<PartFacePatch>>(&answers->front());
    if (!patches) return Error{ErrorCode::importCrashed, subject, {}, "it answered something else"};
    for (PartFacePatch& patch : *patches) place(patch.mesh, model.brepPlacement);
    return std::move(*patches);
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "faces", {}, {}};
}

} // namespace burin
