// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/face_mesh.h"

#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <cmath>
#include <limits>
#include <unordered_map>
#include <unordered_set>

namespace burin {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr int mostPasses = 8;
constexpr std::size_t mostTriangles = 4'000'000; // of one face
/// Only midpoints and centres are checked; between them the deviation may be slightly larger.
constexpr double strictness = 0.8;

std::uint64_t edgeKey(std::uint64_t a, std::uint64_t b) {
    return a < b ? (a << 32) | b : (b << 32) | a;
}

/// The point of the surface nearest to a point in space.
struct Foot {
    glm::dvec3 point{0.0};
    glm::dvec2 parameters{0.0};
    double distance = 0.0; // from the given point, mm
};

class Refinement {
public:
    Refinement(const BRepAdaptor_Surface& surface, double limit, FaceMesh& face, std::vector<glm::dvec3>& points)
        : surface_(surface), limit_(limit), face_(face), points_(points) {}

    /// Splits triangles once where needed; returns false if no split is needed.
    bool pass() {
        countEdges();
        middles_.clear();
        for (const auto& [edge, count] : uses_)
            if (count == 2 && !good_.contains(edge)) examineEdge(edge);
        std::vector<std::array<std::uint32_t, 3>> triangles;
        triangles.reserve(face_.triangles.size() * 2);
        for (const auto& triangle : face_.triangles) markCentre(triangle);
        if (middles_.empty()) return false;
        for (const auto& triangle : face_.triangles) split(triangle, triangles);
        face_.triangles = std::move(triangles);
        return true;
    }

private:
    const glm::dvec3& place(std::uint32_t node) const { return points_[face_.nodes[node]]; }

    void countEdges() {
        uses_.clear();
        for (const auto& triangle : face_.triangles)
            for (std::size_t i = 0; i < 3; ++i) ++uses_[edgeKey(triangle[i], triangle[(i + 1) % 3])];
    }

    /// Newton iteration to the foot of the perpendicular, from nearby parameters.
    Foot footOf(const glm::dvec3& from, glm::dvec2 parameters) const {
        Foot best;
        best.distance = std::numeric_limits<double>::infinity();
        for (int step = 0; step < 4; ++step) {
            gp_Pnt p;
            gp_Vec du, dv;
            surface_.D1(parameters.x, parameters.y, p, du, dv);
            const glm::dvec3 point(p.X(), p.Y(), p.Z()), u(du.X(), du.Y(), du.Z()), v(dv.X(), dv.Y(), dv.Z());
            const double distance = glm::distance(point, from);
            if (!(distance < best.distance)) break;
            best = {point, parameters, distance};
            const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), determinant = uu * vv - uv * uv;
            if (!(determinant > 1e-12 * uu * vv)) break; // at a pole the parameters are undefined
            const double alongU = glm::dot(u, from - point), alongV = glm::dot(v, from - point);
            parameters += glm::dvec2(vv * alongU - uv * alongV, uu * alongV - uv * alongU) / determinant;
        }
        return best;
    }

    void examineEdge(std::uint64_t edge) {
        const auto a = static_cast<std::uint32_t>(edge >> 32), b = static_cast<std::uint32_t>(edge);
        const Foot foot = footOf(0.5 * (place(a) + place(b)), 0.5 * (face_.parameters[a] + face_.parameters[b]));
        if (foot.distance > limit_)
            splitAt(edge, foot);
        else
            good_.insert(edge);
    }

    void splitAt(std::uint64_t edge, const Foot& foot) {
        const auto a = static_cast<std::uint32_t>(edge >> 32), b = static_cast<std::uint32_t>(edge);
        // A foot far from the middle belongs to another sheet of the surface.
        if (!(foot.distance < 0.5 * glm::distance(place(a), place(b)))) return;
        middles_[edge] = static_cast<std::uint32_t>(face_.nodes.size());
        face_.nodes.push_back(static_cast<std::uint32_t>(points_.size()));
        face_.parameters.push_back(foot.parameters);
        points_.push_back(foot.point);
    }

    std::uint32_t middleOf(std::uint32_t a, std::uint32_t b) const {
        const auto middle = middles_.find(edgeKey(a, b));
        return middle == middles_.end() ? none : middle->second;
    }

    /// Marks the longest inner edge of a triangle for splitting, if it bulges between good edges.
    void markCentre(const std::array<std::uint32_t, 3>& t) {
        std::uint64_t longest = 0;
        double length = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            if (middleOf(a, b) != none) return;
            if (const double l = glm::distance(place(a), place(b)); uses_[edgeKey(a, b)] == 2 && l > length) {
                length = l;
                longest = edgeKey(a, b);
            }
        }
        const auto& uv = face_.parameters;
        const Foot foot =
            footOf((place(t[0]) + place(t[1]) + place(t[2])) / 3.0, (uv[t[0]] + uv[t[1]] + uv[t[2]]) / 3.0);
        if (foot.distance <= limit_ || length < limit_) return;
        const auto a = static_cast<std::uint32_t>(longest >> 32), b = static_cast<std::uint32_t>(longest);
        splitAt(longest, footOf(0.5 * (place(a) + place(b)), 0.5 * (uv[a] + uv[b])));
    }

    void split(const std::array<std::uint32_t, 3>& t, std::vector<std::array<std::uint32_t, 3>>& into) const {
        std::array<std::uint32_t, 3> m{middleOf(t[0], t[1]), middleOf(t[1], t[2]), middleOf(t[2], t[0])};
        std::size_t count = 0, first = 0;
        for (std::size_t i = 0; i < 3; ++i)
            if (m[i] != none) ++count;
        // Rotated so that a single split lies on edge 0, and two splits on edges 0 and 1.
        while (count > 0 && count < 3 && !(m[first] != none && (count == 1 || m[(first + 1) % 3] != none))) ++first;
        const std::uint32_t a = t[first], b = t[(first + 1) % 3], c = t[(first + 2) % 3];
        const std::uint32_t ab = m[first], bc = m[(first + 1) % 3], ca = m[(first + 2) % 3];
        switch (count) {
        case 0:
            into.push_back(t);
            break;
        case 1:
            into.insert(into.end(), {{a, ab, c}, {ab, b, c}});
            break;
        case 2:
            into.push_back({ab, b, bc});
            if (glm::distance(place(a), place(bc)) < glm::distance(place(ab), place(c)))
                into.insert(into.end(), {{a, ab, bc}, {a, bc, c}});
            else
                into.insert(into.end(), {{a, ab, c}, {ab, bc, c}});
            break;
        default:
            into.insert(into.end(), {{a, ab, ca}, {ab, b, bc}, {bc, c, ca}, {ab, bc, ca}});
        }
    }

    const BRepAdaptor_Surface& surface_;
    double limit_;
    FaceMesh& face_;
    std::vector<glm::dvec3>& points_;
    std::unordered_map<std::uint64_t, int> uses_;
    std::unordered_map<std::uint64_t, std::uint32_t> middles_; // node in the middle of each edge to split
    std::unordered_set<std::uint64_t> good_;
};

} // namespace

void refineFace(const BRepAdaptor_Surface& surface, double chord, FaceMesh& face, std::vector<glm::dvec3>& points) {
    if (surface.GetType() == GeomAbs_Plane || face.parameters.size() != face.nodes.size()) return;
    Refinement refinement(surface, strictness * chord, face, points);
    for (int pass = 0; pass < mostPasses && face.triangles.size() < mostTriangles; ++pass)
        if (!refinement.pass()) break;
}

} // namespace burin
