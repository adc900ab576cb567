// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/face_area.h"

#include "core/base/numbers.h"
#include "core/cad/face_neighbours.h"
#include "core/geometry/triangle.h"

#include <limits>
#include <string>
#include <unordered_map>

namespace burin {

namespace {

constexpr double reach = 1.0;         // mm from a point to its face
constexpr double leastUpwards = 1e-3; // z of a normal: steeper triangles have no area from above

/// A triangle of one of a model's bodies.
struct Spot {
    const TriangleMesh* mesh = nullptr;
    std::size_t triangle = 0;
    double distance = std::numeric_limits<double>::infinity(); ///< mm
};

Spot nearestSpot(const Model& model, const glm::dvec3& place) {
    Spot nearest;
    for (const Body& body : model.bodies)
        for (std::size_t i = 0; i < body.mesh.triangles.size(); ++i) {
            const double distance = glm::distance(closestOnTriangle(cornersOf(body.mesh, i), place).point, place);
            if (distance < nearest.distance) nearest = {&body.mesh, i, distance};
        }
    return nearest;
}

/// The face of a mesh that contains a triangle.
class Face {
public:
    explicit Face(const TriangleMesh& mesh) : mesh_(mesh), neighbours_(mesh) {}

    /// Returns its outlines, with the material of the face to the left.
    std::vector<PlanRing> outlines(std::size_t from) {
        std::vector<char> on(mesh_.triangles.size(), 0);
        std::vector<std::size_t> open;
        const auto reachTo = [&](std::size_t triangle) {
            if (on[triangle] || neighbours_.normal(triangle).z < leastUpwards) return;
            on[triangle] = 1;
            open.push_back(triangle);
        };
        std::unordered_multimap<std::uint32_t, std::uint32_t> border; // from one corner to the next
        reachTo(from);
        while (!open.empty()) {
            const std::size_t triangle = open.back();
            open.pop_back();
            for (int side = 0; side < 3; ++side)
                if (const auto next = neighbours_.beside(triangle, side)) reachTo(*next);
        }
        for (std::size_t i = 0; i < on.size(); ++i)
            for (int side = 0; on[i] && side < 3; ++side) {
                const auto next = neighbours_.beside(i, side);
                if (!next || !on[*next]) border.emplace(neighbours_.corner(i, side), neighbours_.corner(i, side + 1));
            }
        return chained(std::move(border));
    }

private:
    std::vector<PlanRing> chained(std::unordered_multimap<std::uint32_t, std::uint32_t> border) const {
        std::vector<PlanRing> rings;
        while (!border.empty()) {
            PlanRing ring;
            const std::uint32_t first = border.begin()->first;
            for (auto step = border.begin(); step != border.end();) {
                const auto [from, to] = *step;
                ring.emplace_back(mesh_.vertices[from]);
                border.erase(step);
                step = to == first ? border.end() : border.find(to);
            }
            rings.push_back(std::move(ring));
        }
        return rings;
    }

    const TriangleMesh& mesh_;
    FaceNeighbours neighbours_;
};

} // namespace

Result<PlanRegion> faceArea(const Model& model, const glm::dvec3& place) {
    const std::string asked = formatShortest(place.x) + ", " + formatShortest(place.y) + ", " + formatShortest(place.z);
    const Spot spot = nearestSpot(model, place);
    if (!(spot.distance <= reach))
        return Error{ErrorCode::argumentInvalid, "face", asked, "a point on the part, within 1 mm"};
    PlanRegion region = filledBy(Face(*spot.mesh).outlines(spot.triangle));
    if (region.empty()) return Error{ErrorCode::argumentInvalid, "face", asked, "a face that is visible from above"};
    return region;
}

} // namespace burin
