// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"
#include "core/geometry/piece_minimum.h"
#include "core/geometry/surface_normals.h"
#include "core/geometry/triangle_tree.h"
#include "core/geometry/triangle_walk.h"

#include <array>
#include <cstdint>

namespace burin {

/// A point of the mesh found by a search.
struct Found {
    std::size_t slot = 0;
    glm::dvec3 point{0.0};
    TriangleFeature feature = TriangleFeature::face;
    double distance = 0.0;
    std::size_t piece = 0;
    bool any = false;
    std::uint64_t work = 0; ///< of the whole search so far, in the unit of ClearanceAsker::work

    /// Replaces the point by a better one; the work counter is kept.
    void improve(const Found& better) noexcept {
        const std::uint64_t spent = work;
        *this = better;
        work = spent;
    }
};
/// Cost of a minimum over a triangle, in triangle evaluations.
inline constexpr std::uint64_t workOfMinimum = 8;

/// The value that a clearance has to be below to count as an improvement.
inline double worthwhile(double clearance, const ClearanceTolerance& tolerance) noexcept {
    return clearance - (clearance < tolerance.deepBelow ? tolerance.deep : tolerance.ordinary);
}

/// Searches for the point of a mesh where the signed distance to a piece is least. Improves on a point that was found
/// before, for this piece or another. No allocation.
class PieceSearch {
public:
    /// @param number  of the piece  @param floor  mm above the tip: the result for what lies below is known already
    PieceSearch(const TriangleTree& tree, const SurfaceNormals& normals, const PlacedPiece& piece, std::size_t number,
                double floor, const ClearanceTolerance& tolerance, Found& found) noexcept;

    /// Starts from what this piece found for a nearby position and goes from triangle to triangle as long as the
    /// distance decreases.
    void descend() noexcept;
    /// Searches the whole mesh above the floor. @return mm: except for the point found, nothing is nearer than this
    double run() noexcept;

private:
    struct Candidate {
        double below;
        std::size_t slot;
    };

    double wanted() const noexcept { return worthwhile(found_.distance, tolerance_); }
    const Triangle& triangle(std::size_t slot) const noexcept { return tree_.triangles()[slot]; }
    double atCentroid(std::size_t slot) const noexcept;
    void take(const Found& better) noexcept;
    bool solve(std::size_t slot, double below) noexcept;
    void layPlane() noexcept;
    void meet(std::size_t slot) noexcept;
    double abovePlane(const Triangle& of) const noexcept;

    const TriangleTree& tree_;
    const SurfaceNormals& normals_;
    const PlacedPiece& piece_;
    const std::size_t number_;
    const ClearanceTolerance& tolerance_;
    Found& found_;
    NearPiece near_;
    SupportingPlane plane_;
    bool hasPlane_ = false;
    std::array<Candidate, 64> candidates_;
    std::size_t count_ = 0;
    double passed_ = std::numeric_limits<double>::infinity(); ///< least bound of the triangles that were dropped
};

} // namespace burin
