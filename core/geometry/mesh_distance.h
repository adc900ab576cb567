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

/// Where a mesh is nearest to a point.
struct ClosestPoint {
    glm::dvec3 point{0.0};       ///< on the mesh, mm
    double distance = 0.0;       ///< mm, >= 0
    double signedDistance = 0.0; ///< mm, negative inside a closed, outward mesh (angle-weighted pseudo-normals)
    std::size_t triangle = 0;
    glm::dvec3 outward{0.0}; ///< pseudo-normal there, not of unit length; zero when nothing was found
};

/// How far a tool keeps from a mesh.
struct ToolClearance {
    double clearance = 0.0;         ///< mm; negative: the tool enters the solid by so much (its gouge is -clearance)
    glm::dvec3 meshPoint{0.0};      ///< mm, the nearest or deepest point of the mesh, same frame as the mesh
    glm::dvec3 away{0.0, 0.0, 1.0}; ///< unit vector along which the tool has to move to gain clearance fastest
    std::size_t piece = 0;          ///< which piece of the tool
    glm::dvec3 outward{0.0}; ///< the mesh's pseudo-normal at meshPoint, not of unit length; zero where the answer
                             ///< is the depth of a point of the tool, or none
};

/// By how much a clearance may be answered too great, mm, which is quicker where much of the mesh is equally near or
/// deep.
struct ClearanceTolerance {
    double ordinary = 1e-8;
    double deepBelow = -std::numeric_limits<double>::infinity(); ///< for clearances below this
    double deep = 1e-8;                                          ///< it is so much
};

/// What a ClearanceAsker keeps of its last answers.
struct ClearanceMemory;

/// Distance queries against one triangle mesh, mm, in the mesh's frame, exact for its triangles (Burin's judge of
/// gouges; the mesh is made with a chord of 0.005 mm or finer). Copies what it needs; immutable after construction, so
/// any number of threads may ask.
class MeshDistance {
public:
    /// Cost: O(n log n) for n triangles. An empty mesh answers an infinite distance. Triangles with a corner that is
    /// not finite are left out. Vertices that are bit-identical count as one.
    explicit MeshDistance(const TriangleMesh& mesh);
    ~MeshDistance();
    MeshDistance(MeshDistance&&) noexcept;
    MeshDistance& operator=(MeshDistance&&) noexcept;

    /// @param within stop looking beyond this distance, mm. Where there is nothing nearer, distance and signedDistance
    /// are `within` (the sign is not known then), the point is the asked one; so for a point that is not finite.
    ClosestPoint closest(const glm::dvec3& point, double within = 1e300) const;

    /// Triangles by numbers of this object's own, for `closestOf`: all that are no farther than `within` from a point,
    /// mm. Replaces what `numbers` holds.
    void trianglesNear(const glm::dvec3& point, double within, std::vector<std::uint32_t>& numbers) const;
    /// As `closest`, among the triangles that were named, at least one. No allocation. Cost: some 15 ns a triangle.
    ClosestPoint closestOf(std::span<const std::uint32_t> numbers, const glm::dvec3& point) const noexcept;

    /// Clearance of a tool, given as pieces of which each stands on the one before, at a pose with any axis.
    /// Apart or touching: the distance between tool and mesh. Otherwise minus the greater of two depths: of the mesh's
    /// deepest point in a piece, and in the solid of the deepest of the axis' points (ends of the pieces, centres of
    /// their roundings). So it changes no faster than the tool moves. Exact to 1e-6 mm for every piece.
    /// Clearances above `within` are answered as `within`; meshPoint is the tip and away the axis then. A pose that is
    /// not finite touches nothing.
    /// @param tolerance  mm: by so much the answer may be too great, which is quicker where much of the mesh is equally
    /// near or deep
    ToolClearance clearance(std::span<const RevolvedPiece> tool, const ToolPose& pose, double within = 1e300,
                            double tolerance = 1e-8) const;

    /// For each of many tips of a tool along `axis` whether it is in the solid by more than `depth`, mm, > 0: a point
    /// of the mesh lies deeper in one of its pieces, or all of the tool is in the solid; 1 or 0. Neighbours share the
    /// search, so that a million tips beside a surface take some tenths of a second. All cores. Tips that are not
    /// finite enter nothing; once cancelled, what is not known yet is 0.
    std::vector<std::uint8_t> entered(std::span<const RevolvedPiece> tool, const glm::dvec3& axis,
                                      std::span<const glm::dvec3> tips, double depth, const Progress& progress) const;

    /// What a ray meets first; nothing: it meets none.
    std::optional<TriangleHit> hit(const Ray& ray) const noexcept;

    /// mm, the mesh's frame; empty for an empty mesh.
    Box bounds() const noexcept;
    /// What is measured to, in an order in which neighbours are near each other.
    std::span<const Triangle> triangles() const noexcept;

private:
    friend class ClearanceAsker;
    class Tree;
    std::unique_ptr<const Tree> tree_;
};

/// Asks for the clearance of one tool, one pose after the other: as MeshDistance::clearance, and faster where a pose is
/// near the last ones, whose nearest and deepest points of the mesh bound what there is to be found. Of points that are
/// equally near, which one is answered may depend on the poses asked before. One thread each; the mesh and the tool
/// must outlive it.
class ClearanceAsker {
public:
    /// Allocates. @param axis  of the tips that are asked without one
    ClearanceAsker(const MeshDistance& part, std::span<const RevolvedPiece> tool,
                   const glm::dvec3& axis = {0.0, 0.0, 1.0});
    ~ClearanceAsker();
    ClearanceAsker(const ClearanceAsker&) = delete;
    ClearanceAsker& operator=(const ClearanceAsker&) = delete;

    /// No allocation.
    ToolClearance ask(const glm::dvec3& tip, double within, const ClearanceTolerance& tolerance) noexcept {
        return ask(ToolPose{tip, axis_}, within, tolerance);
    }
    /// The axis may turn from pose to pose. No allocation.
    ToolClearance ask(const ToolPose& pose, double within, const ClearanceTolerance& tolerance) noexcept;
    /// Whether the tool, moving straight from one tip to another, certainly keeps a clearance all the way: then `ask`
    /// answers nothing less on it, but for 1e-8 mm. False: it does not, or it could not be shown. Costs little more
    /// than one `ask`. No allocation. @param clearance  mm; negative: the tool may enter by so much
    bool keeps(const glm::dvec3& from, const glm::dvec3& to, double clearance) noexcept;
    /// What all answers took together: looks at a triangle (60 to 120 ns each beside a fine mesh, measured with
    /// other work running). The same poses take the same.
    std::uint64_t work() const noexcept;

private:
    const MeshDistance& part_;
    std::span<const RevolvedPiece> tool_;
    glm::dvec3 axis_;
    std::unique_ptr<ClearanceMemory> memory_;
};

} // namespace burin
