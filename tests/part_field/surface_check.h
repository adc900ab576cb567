// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "tests/part_field/part_brick.h"

#include <atomic>
#include <span>

namespace burin {

/// A brick near the surface that may become fine. Its block stores its number where it later stores that of a fine
/// brick.
struct FieldCandidate {
    glm::ivec3 brick; ///< counted from the origin
    std::size_t block;
    bool smooth = false; ///< its corners determine the samples between them
    bool fine = false;
};

/// Number of the candidate at a position, `coarse` where there is none.
inline std::int32_t candidateAt(const PartFieldLayers& layers, const glm::ivec3& brick) noexcept {
    const std::int32_t block = layers.blockNumberAt(brick >> 3);
    if (block == PartFieldLayers::coarse) return PartFieldLayers::coarse;
    const glm::ivec3 in = brick & 7;
    return layers.divided[static_cast<std::size_t>(block)].fine[CellGrid::cellAt(in.x, in.y, in.z)];
}

/// Checks finished bricks against the whole mesh: every point of it bounds the distances around it, which detects
/// features between samples. The brick around a point represents its neighbours as long as they agree on the samples
/// that they share. Also checks bricks against each other: where a gap in the surface was missed, there is no point of
/// the mesh to detect it.
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

    /// Candidates that a point of the mesh contradicts: a value exceeds the distance to it by more than its error, or
    /// the band passes through one that is not fine; and candidates that contradict each other. Parallel.
    std::vector<std::size_t> contradicted(Progress& progress);

    /// Candidates next to fully sampled bricks whose values differ from those samples by more than their stated bound.
    /// @param asked a flag for each candidate: all of its samples were taken from the mesh @param last those that were
    /// fully sampled in the last pass
    std::vector<std::size_t> contradictedBy(std::span<const std::size_t> last,
                                            const std::vector<std::uint8_t>& asked) const;

    /// Whether a facet at least that wide, voxels, is near a candidate. Valid after `contradicted` has examined the
    /// mesh.
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
    std::vector<std::uint8_t> facetWidth_; ///< per candidate: width of its widest facet, whole voxels; 0: less than 2
    std::atomic<bool> anyFacet_{false};    ///< whether any facet is that wide
};

} // namespace burin
