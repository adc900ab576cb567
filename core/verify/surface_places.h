// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace burin {

/// Points spread evenly over surfaces and numbered consecutively, about one for every `spacing`²: each triangle in turn
/// has as many as its share of the area. The points are the same in every run, and any of them is found without those
/// before it.
class SurfacePlaces {
public:
    /// @param spacing mm
    explicit SurfacePlaces(double spacing) : share_(spacing * spacing) {}

    /// Appends the points of a mesh, which must outlive this object and must not move its vertices.
    void add(const TriangleMesh& mesh) {
        double due = 0.0;
        for (const auto& [a, b, c] : mesh.triangles) {
            const glm::dvec3 &pa = mesh.vertices[a], &pb = mesh.vertices[b], &pc = mesh.vertices[c];
            const glm::dvec3 twice = glm::cross(pb - pa, pc - pa);
            const double length = glm::length(twice);
            if (!(length > 0.0)) continue;
            due += 0.5 * length / share_;
            const auto places = static_cast<std::size_t>(due);
            if (places == 0) continue;
            due -= static_cast<double>(places);
            faces_.push_back({&pa, &pb, &pc, twice / length, count_});
            count_ += places;
        }
    }

    std::size_t count() const noexcept { return count_; }

    /// Calls `visit(number, point, unit normal)` for points `first` … `end` - 1.
    template <class Visit>
    void forEach(std::size_t first, std::size_t end, const Visit& visit) const {
        if (first >= end) return;
        auto face = std::upper_bound(faces_.begin(), faces_.end(), first,
                                     [](std::size_t number, const Face& f) { return number < f.first; }) -
                    1;
        for (std::size_t i = first; i < end; ++i) {
            if (face + 1 != faces_.end() && i >= (face + 1)->first) ++face;
            visit(i, place(*face, i - face->first), face->normal);
        }
    }

private:
    struct Face {
        const glm::dvec3 *a, *b, *c;
        glm::dvec3 normal;
        std::size_t first; ///< number of its first point
    };

    /// Additive recurrence over the triangle (M. Roberts, The unreasonable effectiveness of quasirandom sequences,
    /// 2018: "R2 sequence").
    static glm::dvec3 place(const Face& face, std::size_t i) noexcept {
        const double turn = static_cast<double>(i + 1);
        double s = 0.5 + 0.7548776662466927 * turn, t = 0.5 + 0.5698402909980532 * turn;
        s -= std::floor(s);
        t -= std::floor(t);
        if (s + t > 1.0) {
            s = 1.0 - s;
            t = 1.0 - t;
        }
        return *face.a + s * (*face.b - *face.a) + t * (*face.c - *face.a);
    }

    double share_; ///< mm² per point
    std::size_t count_ = 0;
    std::vector<Face> faces_; ///< those that have points
};

} // namespace burin
