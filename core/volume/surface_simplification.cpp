// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_simplification.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>

namespace burin {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

} // namespace

void SurfaceSimplifier::simplify(SurfaceMesh& mesh, double tolerance, double cell) {
    if (mesh.triangles.empty()) return;
    chooseMaterials(mesh);
    std::array<bool, 256> there{};
    for (const PropertyIndex material : materialOf_) there[material] = true;
    result_.clear();
    for (std::size_t material = 0; material < there.size(); ++material)
        if (there[material]) addMaterial(mesh, static_cast<PropertyIndex>(material), tolerance);
    std::swap(mesh, result_);
    leanOnFaces(mesh, cell);
}

/// A triangle has one material: that of most of its corners.
void SurfaceSimplifier::chooseMaterials(const SurfaceMesh& mesh) {
    materialOf_.clear();
    for (std::size_t corner = 0; corner < mesh.triangles.size(); corner += 3) {
        const PropertyIndex a = mesh.properties[mesh.triangles[corner]],
                            b = mesh.properties[mesh.triangles[corner + 1]],
                            c = mesh.properties[mesh.triangles[corner + 2]];
        materialOf_.push_back(b == c ? b : a);
    }
}

void SurfaceSimplifier::addMaterial(const SurfaceMesh& mesh, PropertyIndex material, double tolerance) {
    newPoint_.assign(mesh.points.size(), none);
    source_.clear();
    points_.clear();
    indices_.clear();
    for (std::size_t corner = 0; corner < mesh.triangles.size(); ++corner) {
        if (materialOf_[corner / 3] != material) continue;
        std::uint32_t& point = newPoint_[mesh.triangles[corner]];
        if (point == none) {
            point = static_cast<std::uint32_t>(points_.size());
            points_.push_back(mesh.points[mesh.triangles[corner]]);
            source_.push_back(mesh.triangles[corner]);
        }
        indices_.push_back(point);
    }
    const float scale = meshopt_simplifyScale(&points_.front().x, points_.size(), sizeof(glm::vec3));
    simplified_.resize(indices_.size());
    simplified_.resize(meshopt_simplify(simplified_.data(), indices_.data(), indices_.size(), &points_.front().x,
                                        points_.size(), sizeof(glm::vec3), 0, static_cast<float>(tolerance) / scale,
                                        meshopt_SimplifyLockBorder, nullptr));
    newPoint_.assign(points_.size(), none);
    for (const std::uint32_t index : simplified_) {
        std::uint32_t& point = newPoint_[index];
        if (point == none) {
            point = static_cast<std::uint32_t>(result_.points.size());
            result_.points.push_back(points_[index]);
            result_.normals.push_back(mesh.normals[source_[index]]);
            result_.properties.push_back(material);
        }
        result_.triangles.push_back(point);
    }
}

void SurfaceSimplifier::findPlaces(const SurfaceMesh& mesh) {
    if (mesh.points.empty()) return;
    placeOf_.resize(mesh.points.size());
    meshopt_generateVertexRemap(placeOf_.data(), mesh.triangles.data(), mesh.triangles.size(), mesh.points.data(),
                                mesh.points.size(), sizeof(glm::vec3));
}

/// Visits every edge that has a triangle on one side only, by its two points.
template <class Visit>
void SurfaceSimplifier::eachOpenCorner(const SurfaceMesh& mesh, Visit visit) {
    const auto eachEdge = [&](auto use) {
        for (std::size_t corner = 0; corner < mesh.triangles.size(); ++corner) {
            const std::size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
            use(mesh.triangles[corner], mesh.triangles[next]);
        }
    };
    const auto edge = [](std::uint64_t from, std::uint64_t to) { return from << 32 | to; };
    findPlaces(mesh);
    edges_.clear();
    eachEdge([&](std::uint32_t from, std::uint32_t to) { edges_.push_back(edge(placeOf_[from], placeOf_[to])); });
    std::sort(edges_.begin(), edges_.end());
    eachEdge([&](std::uint32_t from, std::uint32_t to) {
        if (!std::binary_search(edges_.begin(), edges_.end(), edge(placeOf_[to], placeOf_[from]))) visit(from, to);
    });
}

std::vector<std::uint32_t> SurfaceSimplifier::rim(const SurfaceMesh& mesh) {
    std::vector<std::uint32_t> points;
    eachOpenCorner(mesh, [&](std::uint32_t from, std::uint32_t to) { points.insert(points.end(), {from, to}); });
    return points;
}

/// Leans the normals towards the large faces around a point. Those on the rim stay: the next tile has them as well.
void SurfaceSimplifier::leanOnFaces(SurfaceMesh& mesh, double cell) {
    open_.assign(mesh.points.size(), false);
    eachOpenCorner(mesh,
                   [&](std::uint32_t from, std::uint32_t to) { open_[placeOf_[from]] = open_[placeOf_[to]] = true; });
    const auto cellArea = static_cast<float>(cell * cell);
    leaning_.assign(mesh.points.size(), glm::vec3(0.0F));
    for (std::size_t corner = 0; corner < mesh.triangles.size(); corner += 3) {
        const std::array at{mesh.triangles[corner], mesh.triangles[corner + 1], mesh.triangles[corner + 2]};
        const glm::vec3& start = mesh.points[at[0]];
        const glm::vec3 twice = glm::cross(mesh.points[at[1]] - start, mesh.points[at[2]] - start);
        const float area = 0.5F * glm::length(twice);
        if (area <= 2.0F * cellArea) continue; // no larger than unsimplified: the field knows better
        for (const std::uint32_t point : at)
            leaning_[placeOf_[point]] += twice * (0.5F * (area - 2.0F * cellArea) / area);
    }
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
        if (!open_[placeOf_[point]])
            mesh.normals[point] = glm::normalize(mesh.normals[point] * cellArea + leaning_[placeOf_[point]]);
}

void SurfaceSimplifier::join(std::span<const SurfaceMesh* const> pieces, SurfaceMesh& whole) {
    result_.clear();
    for (const SurfaceMesh* piece : pieces) {
        const auto first = static_cast<std::uint32_t>(result_.points.size());
        result_.points.insert(result_.points.end(), piece->points.begin(), piece->points.end());
        result_.normals.insert(result_.normals.end(), piece->normals.begin(), piece->normals.end());
        result_.properties.insert(result_.properties.end(), piece->properties.begin(), piece->properties.end());
        for (const std::uint32_t corner : piece->triangles) result_.triangles.push_back(first + corner);
    }
    whole.clear();
    if (result_.points.empty()) return;
    placeOf_.resize(result_.points.size());
    const std::array<meshopt_Stream, 2> keys{
        {{result_.points.data(), sizeof(glm::vec3), sizeof(glm::vec3)},
         {result_.properties.data(), sizeof(PropertyIndex), sizeof(PropertyIndex)}}};
    const std::size_t count =
        meshopt_generateVertexRemapMulti(placeOf_.data(), result_.triangles.data(), result_.triangles.size(),
                                         result_.points.size(), keys.data(), keys.size());
    whole.points.resize(count);
    whole.normals.resize(count);
    whole.properties.resize(count);
    for (std::size_t point = 0; point < placeOf_.size(); ++point) {
        if (placeOf_[point] == none) continue; // beside the border: the next tile's
        whole.points[placeOf_[point]] = result_.points[point];
        whole.normals[placeOf_[point]] = result_.normals[point];
        whole.properties[placeOf_[point]] = result_.properties[point];
    }
    for (const std::uint32_t corner : result_.triangles) whole.triangles.push_back(placeOf_[corner]);
}

} // namespace burin
