// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/pose.h"
#include "core/geometry/revolved_piece.h"
#include "core/geometry/triangle.h"
#include "core/geometry/triangle_mesh.h"
#include "core/geometry/triangle_ray.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

class Progress;

/// The point of a mesh that is nearest to a given point.
struct ClosestPoint {
    glm::dvec3 point{0.0};       ///< on the mesh, mm
    double distance = 0.0;       ///< mm, >= 0
    double signedDistance = 0.0; ///< mm, negative inside a closed, outward mesh (angle-weighted pseudo-normals)
    std::size_t triangle = 0;
    glm::dvec3 outward{0.0}; ///< pseudo-normal there, not of unit length; zero when nothing was found
};

/// The clearance of a tool from a mesh.
struct ToolClearance {
    double clearance = 0.0;         ///< mm; negative: the tool enters the solid this deep (its gouge is -clearance)
    glm::dvec3 meshPoint{0.0};      ///< mm, the nearest or deepest point of the mesh, same frame as the mesh
    glm::dvec3 away{0.0, 0.0, 1.0}; ///< unit vector along which the tool has to move to gain clearance fastest
    std::size_t piece = 0;          ///< index of the piece of the tool
    glm::dvec3 outward{0.0}; ///< the mesh's pseudo-normal at meshPoint, not of unit length; zero if the result is the
                             ///< depth of a point of the tool, or there is none
};

/// How much greater than the true value a clearance may be returned, mm; a larger tolerance is faster where much of the
/// mesh is equally near or deep.
struct ClearanceTolerance {
    double ordinary = 1e-8;
    double deepBelow = -std::numeric_limits<double>::infinity(); ///< for clearances below this
    double deep = 1e-8;                                          ///< the tolerance for them
};

/// What a ClearanceAsker keeps of its previous results.
struct ClearanceMemory;

/// Distance queries against one triangle mesh, mm, in the mesh's frame, exact for its triangles (Burin's reference for
/// gouges; the mesh is made with a chord of 0.005 mm or finer). Copies what it needs; immutable after construction, so
/// any number of threads may query it.
class MeshDistance {
public:
    /// Cost: O(n log n) for n triangles. An empty mesh has infinite distance. Triangles with a corner that is not
    /// finite are ignored. Vertices that are bit-identical count as one.
    explicit MeshDistance(const TriangleMesh& mesh);
    ~MeshDistance();
    MeshDistance(MeshDistance&&) noexcept;
    MeshDistance& operator=(MeshDistance&&) noexcept;

    /// @param within  stops searching beyond this distance, mm. If nothing is nearer, distance and signedDistance are
    ///        `within` (the sign is then unknown) and the point is the given one; likewise for a point that is not
    ///        finite.
    ClosestPoint closest(const glm::dvec3& point, double within = 1e300) const;

    /// Numbers in `triangles`, for use with `closestOf`, of all triangles that are no farther than `within` mm from a
    /// point. Replaces the content of `numbers`.
    void trianglesNear(const glm::dvec3& point, double within, std::vector<std::uint32_t>& numbers) const;
    /// As `closest`, restricted to the given triangles, at least one. No allocation. Cost: some 15 ns per triangle.
    ClosestPoint closestOf(std::span<const std::uint32_t> numbers, const glm::dvec3& point) const noexcept;

    /// Clearance of a tool, given as a stack of pieces, at a pose with any axis. If they are apart or touch: the
    /// distance between tool and mesh. Otherwise minus the greater of two depths: that of the mesh's deepest point in a
    /// piece, and that of the deepest of the axis' points (ends of the pieces, centres of their roundings) in the
    /// solid. So it changes no faster than the tool moves. Exact to 1e-6 mm for every piece.
    /// Clearances above `within` are returned as `within`; meshPoint is then the tip and away the axis. A pose that is
    /// not finite touches nothing.
    /// @param tolerance  mm: how much too great the result may be; a larger tolerance is faster where much of the mesh
    ///        is equally near or deep
    ToolClearance clearance(std::span<const RevolvedPiece> tool, const ToolPose& pose, double within = 1e300,
                            double tolerance = 1e-8) const;

    /// For each of many tips of a tool parallel to `axis`, whether the tool is in the solid by more than `depth`, mm, >
    /// 0: a point of the mesh lies deeper in one of its pieces, or the whole tool is in the solid; 1 or 0. Neighbours
    /// share the search, so that a million tips near a surface take some tenths of a second. Uses all cores. Tips that
    /// are not finite enter nothing; once cancelled, results not known yet are 0.
    std::vector<std::uint8_t> entered(std::span<const RevolvedPiece> tool, const glm::dvec3& axis,
                                      std::span<const glm::dvec3> tips, double depth, const Progress& progress) const;

    /// The first hit of a ray; empty if there is none.
    std::optional<TriangleHit> hit(const Ray& ray) const noexcept;

    /// mm, the mesh's frame; empty for an empty mesh.
    Box bounds() const noexcept;
    /// The triangles that distances are measured to, ordered so that neighbours are near each other.
    std::span<const Triangle> triangles() const noexcept;

private:
    friend class ClearanceAsker;
    class Tree;
    std::unique_ptr<const Tree> tree_;
};

/// Computes the clearance of one tool for one pose after the other: as MeshDistance::clearance, and faster if a pose is
/// near the previous ones, whose nearest and deepest points of the mesh bound the result. Among points that are equally
/// near, which one is returned may depend on the previous poses. One object per thread; the mesh and the tool must
/// outlive it.
class ClearanceAsker {
public:
    /// Allocates. @param axis  for queries by tip alone
    ClearanceAsker(const MeshDistance& part, std::span<const RevolvedPiece> tool,
                   const glm::dvec3& axis = {0.0, 0.0, 1.0});
    ~ClearanceAsker();
    ClearanceAsker(const ClearanceAsker&) = delete;
    ClearanceAsker& operator=(const ClearanceAsker&) = delete;

    /// No allocation.
    ToolClearance ask(const glm::dvec3& tip, double within, const ClearanceTolerance& tolerance) noexcept {
        return ask(ToolPose{tip, axis_}, within, tolerance);
    }
    /// The axis may differ from pose to pose. No allocation.
    ToolClearance ask(const ToolPose& pose, double within, const ClearanceTolerance& tolerance) noexcept;
    /// Whether the tool, moving straight from one tip to another, certainly keeps a clearance on the whole move: then
    /// `ask` returns nothing less on it, except for 1e-8 mm. False: it does not, or it could not be shown. Costs little
    /// more than one `ask`. No allocation. @param clearance  mm; negative: the tool may enter by this depth
    bool keeps(const glm::dvec3& from, const glm::dvec3& to, double clearance) noexcept;
    /// Work of all queries so far, in triangle evaluations (60 to 120 ns each near a fine mesh, measured with other
    /// work running). The same poses take the same work.
    std::uint64_t work() const noexcept;

private:
    const MeshDistance& part_;
    std::span<const RevolvedPiece> tool_;
    glm::dvec3 axis_;
    std::unique_ptr<ClearanceMemory> memory_;
};

} // namespace burin
