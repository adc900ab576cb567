// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_simplification.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};
constexpr std::size_t mostBetween = 64; ///< maximum number of points that one straight piece of a rim replaces
constexpr float sameFace = 0.7F;        ///< cosine: normals of one point that are farther apart mean a sharp edge

// Flags of the faces that meet at a position, in addition to the number of a known face.
constexpr std::uint16_t several = 0x100; ///< several known faces
constexpr std::uint16_t unknown = 0x200; ///< a triangle on no known face

void addPoint(SurfaceMesh& mesh, const SurfaceMesh& from, std::size_t point) {
    mesh.points.push_back(from.points[point]);
    mesh.normals.push_back(from.normals[point]);
    mesh.properties.push_back(from.properties[point]);
}

} // namespace

void SurfaceSimplifier::simplify(SurfaceMesh& mesh, double tolerance, double cell, const KnownFaces* faces) {
    if (mesh.triangles.empty()) return mesh.clear();
    chooseRegions(mesh, faces);
    weldByPlace(mesh);
    weldNormals(mesh);
    collapse_.run(mesh.points, leaning_, corners_, regions_, static_cast<float>(tolerance));
    findFacesAtPlaces(mesh.points.size());
    standByRegion(mesh);
    std::swap(mesh, work_);
    leanOnFaces(mesh, cell);
    if (faces == nullptr) return;
    shadeBesideEdges(mesh);
    takeKnownNormals(mesh, *faces);
}

/// A triangle gets one material: that of most of its corners.
void SurfaceSimplifier::chooseRegions(const SurfaceMesh& mesh, const KnownFaces* faces) {
    regions_.clear();
    for (std::size_t corner = 0; corner < mesh.triangles.size(); corner += 3) {
        const std::uint32_t* at = &mesh.triangles[corner];
        const PropertyIndex a = mesh.properties[at[0]], b = mesh.properties[at[1]], c = mesh.properties[at[2]];
        SurfaceRegion region{b == c ? b : a, KnownFaces::none};
        if (faces != nullptr) region.face = faces->faceOf({mesh.points[at[0]], mesh.points[at[1]], mesh.points[at[2]]});
        regions_.push_back(region);
    }
}

/// `leaning_`: the mean normal of the points at a position, where there is one for each face of a sharp edge.
void SurfaceSimplifier::weldNormals(const SurfaceMesh& mesh) {
    leaning_ = mesh.normals;
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
        if (placeOf_[point] != point) leaning_[placeOf_[point]] += mesh.normals[point];
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
        if (placeOf_[point] != point) leaning_[placeOf_[point]] = glm::normalize(leaning_[placeOf_[point]]);
}

/// Triangles by the position of their corners, whatever the material.
void SurfaceSimplifier::weldByPlace(const SurfaceMesh& mesh) {
    table_.weld(mesh.points, placeOf_);
    corners_.resize(mesh.triangles.size());
    for (std::size_t i = 0; i < corners_.size(); ++i) corners_[i] = placeOf_[mesh.triangles[i]];
}

/// Finds which known faces meet at each position.
void SurfaceSimplifier::findFacesAtPlaces(std::size_t points) {
    facesAt_.assign(points, 0);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        std::uint16_t& at = facesAt_[corners_[i]];
        const std::uint16_t face = regions_[i / 3].face, before = at & 0xff;
        if (face == KnownFaces::none)
            at |= unknown;
        else if (before == KnownFaces::none)
            at |= face;
        else if (before != face)
            at |= several;
    }
}

/// A point is duplicated for every material that meets in it, and on a sharp edge for every known face.
SurfaceRegion SurfaceSimplifier::regionOfCorner(std::size_t corner) const {
    SurfaceRegion region = regions_[corner / 3];
    if ((facesAt_[corners_[corner]] & several) == 0) region.face = KnownFaces::none;
    return region;
}

/// Makes `work_` from the remaining triangles.
void SurfaceSimplifier::standByRegion(const SurfaceMesh& mesh) {
    work_.clear();
    knownFaces_.clear();
    besideEdges_.clear();
    std::vector<SurfaceRegion> there;
    for (std::size_t i = 0; i < corners_.size(); ++i)
        if (std::find(there.begin(), there.end(), regionOfCorner(i)) == there.end()) there.push_back(regionOfCorner(i));
    work_.triangles.resize(corners_.size());
    for (const SurfaceRegion region : there) {
        newPoint_.assign(mesh.points.size(), none);
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            if (regionOfCorner(i) != region) continue;
            std::uint32_t& point = newPoint_[corners_[i]];
            if (point == none) {
                point = static_cast<std::uint32_t>(work_.points.size());
                addPoint(work_, mesh, corners_[i]);
                work_.properties.back() = region.material;
                const std::uint16_t faces = facesAt_[corners_[i]];
                besideEdges_.push_back((faces & several) != 0 && region.face == KnownFaces::none ? 1 : 0);
                const bool mixed = (faces & (several | unknown)) != 0;
                knownFaces_.push_back(mixed ? region.face : static_cast<KnownFaces::Number>(faces));
            }
            work_.triangles[i] = point;
        }
    }
}

/// Parts without a known face that meet a sharp edge: their normals must not be influenced by the edge's other sides.
void SurfaceSimplifier::shadeBesideEdges(SurfaceMesh& mesh) {
    leaning_.assign(mesh.points.size(), glm::vec3(0.0F));
    for (std::size_t corner = 0; corner < mesh.triangles.size(); corner += 3) {
        const std::uint32_t* at = &mesh.triangles[corner];
        const glm::vec3 twice =
            glm::cross(mesh.points[at[1]] - mesh.points[at[0]], mesh.points[at[2]] - mesh.points[at[0]]);
        for (std::size_t i = 0; i < 3; ++i) leaning_[at[i]] += twice;
    }
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
        if (besideEdges_[point] != 0 && glm::length(leaning_[point]) > 0.0F)
            mesh.normals[point] = glm::normalize(leaning_[point]);
}

void SurfaceSimplifier::takeKnownNormals(SurfaceMesh& mesh, const KnownFaces& faces) {
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
        if (knownFaces_[point] != KnownFaces::none)
            mesh.normals[point] = faces.normal(knownFaces_[point], mesh.points[point]);
}

/// Visits every edge with a triangle on one side only, by its two points.
template <class Visit>
void SurfaceSimplifier::eachOpenCorner(const SurfaceMesh& mesh, Visit visit) {
    weldByPlace(mesh);
    const auto eachEdge = [&](auto use) {
        for (std::size_t corner = 0; corner < mesh.triangles.size(); ++corner)
            use(corner, corner % 3 == 2 ? corner - 2 : corner + 1);
    };
    const auto edge = [](std::uint64_t from, std::uint64_t to) { return from << 32 | to; };
    edges_.clear();
    eachEdge([&](std::size_t from, std::size_t to) { edges_.push_back(edge(corners_[from], corners_[to])); });
    std::sort(edges_.begin(), edges_.end());
    eachEdge([&](std::size_t from, std::size_t to) {
        if (!std::binary_search(edges_.begin(), edges_.end(), edge(corners_[to], corners_[from])))
            visit(mesh.triangles[from], mesh.triangles[to]);
    });
}

std::vector<std::uint32_t> SurfaceSimplifier::rim(const SurfaceMesh& mesh, double tolerance) {
    std::vector<std::uint32_t> points;
    eachOpenCorner(mesh, [&](std::uint32_t from, std::uint32_t to) { points.insert(points.end(), {from, to}); });
    return tolerance > 0.0 ? straightened(mesh, points, static_cast<float>(tolerance)) : points;
}

std::vector<std::uint32_t> SurfaceSimplifier::straightened(const SurfaceMesh& mesh,
                                                           const std::vector<std::uint32_t>& edges, float tolerance) {
    newPoint_.assign(mesh.points.size(), none); // here: the edge that starts at a position
    for (std::uint32_t edge = 0; edge < edges.size(); edge += 2) newPoint_[placeOf_[edges[edge]]] = edge;
    std::vector<bool> done(edges.size(), false);
    std::vector<std::uint32_t> result, between;
    for (std::uint32_t start = 0; start < edges.size(); start += 2) {
        if (done[start]) continue;
        done[start] = true;
        const std::uint32_t from = edges[start];
        std::uint32_t to = edges[start + 1];
        between.clear();
        for (std::uint32_t next = newPoint_[placeOf_[to]]; next != none && !done[next];
             next = newPoint_[placeOf_[to]]) {
            between.push_back(to);
            const bool straight = std::all_of(between.begin(), between.end(), [&](std::uint32_t point) {
                return distanceToSegment(mesh.points[point], mesh.points[from], mesh.points[edges[next + 1]]) <=
                       tolerance;
            });
            const bool oneMaterial = mesh.properties[edges[next]] == mesh.properties[from];
            if (!straight || !oneMaterial || between.size() > mostBetween) break;
            done[next] = true;
            to = edges[next + 1];
        }
        result.insert(result.end(), {from, to});
    }
    return result;
}

/// Shifts the normals towards those of the large faces around a point.
void SurfaceSimplifier::leanOnFaces(SurfaceMesh& mesh, double cell) {
    weldByPlace(mesh);
    const auto cellArea = static_cast<float>(cell * cell);
    leaning_.assign(mesh.points.size(), glm::vec3(0.0F));
    for (std::size_t corner = 0; corner < mesh.triangles.size(); corner += 3) {
        const std::array at{corners_[corner], corners_[corner + 1], corners_[corner + 2]};
        const glm::vec3& start = mesh.points[at[0]];
        const glm::vec3 twice = glm::cross(mesh.points[at[1]] - start, mesh.points[at[2]] - start);
        const float area = 0.5F * glm::length(twice);
        if (area <= 2.0F * cellArea) continue; // no larger than unsimplified: the field's normal is more accurate
        for (const std::uint32_t point : at) leaning_[point] += twice * (0.5F * (area - 2.0F * cellArea) / area);
    }
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
        mesh.normals[point] = glm::normalize(mesh.normals[point] * cellArea + leaning_[placeOf_[point]]);
}

void SurfaceSimplifier::join(std::span<const SurfaceMesh* const> pieces, SurfaceMesh& whole) {
    work_.clear();
    for (const SurfaceMesh* piece : pieces) {
        const auto first = static_cast<std::uint32_t>(work_.points.size());
        work_.points.insert(work_.points.end(), piece->points.begin(), piece->points.end());
        work_.normals.insert(work_.normals.end(), piece->normals.begin(), piece->normals.end());
        work_.properties.insert(work_.properties.end(), piece->properties.begin(), piece->properties.end());
        for (const std::uint32_t corner : piece->triangles) work_.triangles.push_back(first + corner);
    }
    whole.clear();
    table_.open(work_.points.size());
    newPoint_.assign(work_.points.size(), none);
    for (const std::uint32_t corner : work_.triangles) {
        const std::uint32_t same = table_.entry(work_.points, corner, [&](std::uint32_t other) {
            return work_.points[other] == work_.points[corner] && work_.properties[other] == work_.properties[corner] &&
                   glm::dot(work_.normals[other], work_.normals[corner]) > sameFace;
        });
        if (newPoint_[same] == none) {
            newPoint_[same] = static_cast<std::uint32_t>(whole.points.size());
            addPoint(whole, work_, same);
        }
        whole.triangles.push_back(newPoint_[same]);
    }
}

} // namespace burin
