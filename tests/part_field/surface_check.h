// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "tests/part_field/part_brick.h"

#include <atomic>
#include <span>

namespace burin {

/// A brick near the surface that may be fine. Its block says its number where it says that of a fine brick later.
struct FieldCandidate {
    glm::ivec3 brick; ///< counted from the origin
    std::size_t block;
    bool smooth = false; ///< its corners tell what lies between
    bool fine = false;
};

/// Number of the candidate at a place, `coarse` where there is none.
inline std::int32_t candidateAt(const PartFieldLayers& layers, const glm::ivec3& brick) noexcept {
    const std::int32_t block = layers.blockNumberAt(brick >> 3);
    if (block == PartFieldLayers::coarse) return PartFieldLayers::coarse;
    const glm::ivec3 in = brick & 7;
    return layers.divided[static_cast<std::size_t>(block)].fine[CellGrid::cellAt(in.x, in.y, in.z)];
}

/// Holds made bricks against the whole mesh: every point of it bounds the distances around it, which finds what lies
/// between samples. The brick around a point answers for those beside it as long as they agree on the samples that they
/// share. And holds bricks against each other: where a gap in the surface was not seen, no point of the mesh lies.
class SurfaceCheck {
public:
    SurfaceCheck(const MeshDistance& part, const PartFieldLayers& layers, const std::vector<FieldCandidate>& candidates,
                 const std::vector<MadeBrick>& made)
        : part_(part)
        , layers_(layers)
        , candidates_(candidates)
        , made_(made)
        , perVoxel_(1.0 / layers.request.voxel)
        , facetWidth_(candidates.size(), 0) {}

    /// Candidates that a point of the mesh contradicts: a value exceeds the way to it by more than its error, or the
    /// band passes through one that is not fine; and those that contradict each other. Parallel.
    std::vector<std::size_t> contradicted(Progress& progress);

    /// Candidates beside bricks of which each sample was asked that do not keep what they state at these.
    /// @param asked a flag for each candidate: all of its samples were asked @param last those that were so last
    std::vector<std::size_t> contradictedBy(std::span<const std::size_t> last,
                                            const std::vector<std::uint8_t>& asked) const;

    /// Once `contradicted` has been through the mesh: whether a facet as wide as that, voxels, is near a candidate.
    bool isFacetNear(std::size_t number, int width) const noexcept;

private:
    std::vector<std::uint32_t> findDoubtful(std::vector<std::uint8_t>& wrong, Progress& progress) const;
    void doubt(std::size_t number, std::vector<std::uint32_t>& doubtful, std::vector<std::uint8_t>& wrong) const;
    void check(const glm::dvec3& point, double width, const std::vector<std::uint32_t>& doubtful,
               std::vector<std::uint8_t>& wrong);
    void meetFacet(std::size_t number, double width) noexcept;
    bool contradicts(std::size_t number, const glm::vec3& inside, float away) const noexcept;
    bool isFine(std::int32_t number) const noexcept { return candidates_[static_cast<std::size_t>(number)].fine; }
    float inMillimetres(float voxels) const noexcept {
        return static_cast<float>(static_cast<double>(voxels) * layers_.request.voxel);
    }

    const MeshDistance& part_;
    const PartFieldLayers& layers_;
    const std::vector<FieldCandidate>& candidates_;
    const std::vector<MadeBrick>& made_;
    const double perVoxel_;
    std::vector<std::uint8_t> facetWidth_; ///< per candidate: of the widest facet in it, whole voxels; 0: less than 2
    std::atomic<bool> anyFacet_{false};    ///< is as wide
};

} // namespace burin
