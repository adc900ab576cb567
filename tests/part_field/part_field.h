// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/mesh_distance.h"

#include <cstddef>
#include <memory>
#include <span>

namespace burin {

class PartFieldLayers;

/// Parameters for the signed distance field of a part.
struct PartFieldRequest {
    double voxel = 0.5; ///< edge of the workpiece's voxels, mm: spacing of the fine samples and unit of the bounds
    double reach = 0.0; ///< mm: distance from the surface up to which coarse bricks answer (largest cutter radius +
                        ///< allowance + 4 voxels); at least the fine band of 4 voxels is built
};

/// Distance and gradient at a point, as the haptic loop needs them thousands of times.
struct PartDistance {
    float distance = 0.0F;    ///< mm, negative inside
    glm::vec3 gradient{0.0F}; ///< of the distance, about unit length where the point is in the fine band
};

/// Signed distance to a part: fine within 4 voxels of its surface, coarser beyond, with a stated error everywhere.
/// Negative inside. The sign is MeshDistance's: that of the angle-weighted pseudo-normal of the nearest point, right
/// without exception for a closed, outward-oriented mesh; near an open edge it is the side of the nearest triangle.
/// Immutable after `build`; all queries are thread-safe, without allocation, lock or exception. How the layers are
/// made, and the basis of the error bounds: README.md in this folder.
class PartField {
public:
    /// Cost: tenths of a second for 512 voxels; parallel. Copies what it needs. Errors: cancelled, outOfMemory,
    /// argumentInvalid (a voxel that is not > 0, a reach that is not finite).
    static Result<PartField> build(const TriangleMesh& mesh, const PartFieldRequest& request, Progress& progress);
    /// As above, for a mesh that already has a distance structure, which the field shares.
    static Result<PartField> build(std::shared_ptr<const MeshDistance> part, const PartFieldRequest& request,
                                   Progress& progress);
    ~PartField();
    PartField(PartField&&) noexcept;
    PartField& operator=(PartField&&) noexcept;

    /// Signed distance, mm, mesh's frame. The error is at most errorBoundAt(point). Beyond the reach the side is right,
    /// and the error of the distance is as errorBoundAt states.
    double value(const glm::dvec3& point) const noexcept;
    /// Value and gradient.
    PartDistance at(const glm::dvec3& point) const noexcept;
    /// Values and gradients of many points; as `at`, faster. @param answers of the same length
    void at(std::span<const glm::dvec3> points, std::span<PartDistance> answers) const noexcept;
    /// Largest error of the value at a point, mm: that of the brick that contains it.
    double errorBoundAt(const glm::dvec3& point) const noexcept;
    /// Lower bound of the distance from any point of the box to the part's surface, mm, >= 0. From the pyramid of least
    /// distances.
    double lowerBound(const Box& box) const noexcept;

    double voxel() const noexcept; ///< mm
    double reach() const noexcept; ///< mm
    /// The mesh distance that the field was made from: exact, as a reference.
    const MeshDistance& exact() const noexcept;

    /// Bytes of the field, without the mesh. Samples of the grid within 4 voxels of the surface: bandVoxels().
    std::size_t memoryBytes() const noexcept;
    std::size_t fineBytes() const noexcept; ///< the part of it for fine bricks: samples, headers, exact cells
    std::size_t bandVoxels() const noexcept;

private:
    explicit PartField(std::unique_ptr<const PartFieldLayers> layers);
    std::unique_ptr<const PartFieldLayers> layers_;
};

} // namespace burin
