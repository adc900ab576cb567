// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"
#include "core/volume/surface/known_faces.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

inline float distanceToSegment(const glm::vec3& point, const glm::vec3& from, const glm::vec3& to) {
    const glm::vec3 line = to - from, way = point - from;
    const float size = glm::dot(line, line);
    const float place = size > 0.0F ? glm::clamp(glm::dot(way, line) / size, 0.0F, 1.0F) : 0.0F;
    return glm::length(way - place * line);
}

/// The region of a triangle: a material, and a known face of the workpiece (KnownFaces) or none.
struct SurfaceRegion {
    PropertyIndex material = airProperty;
    KnownFaces::Number face = KnownFaces::none;
    friend bool operator==(SurfaceRegion, SurfaceRegion) = default;
    /// Whether the border between two regions must be preserved: the colour changes there, or faces meet in a sharp
    /// edge.
    bool bordersOn(SurfaceRegion other) const noexcept {
        return material != other.material ||
               (face != other.face && face != KnownFaces::none && other.face != KnownFaces::none);
    }
};

/// Simplifies a triangle mesh by collapsing points into a neighbour. A point is removed only if it lies within the
/// tolerance of the planes of all triangles that replace its own, including displacements by earlier steps; if no
/// triangle flips, neither in one step nor gradually; and if the surface remains a surface. A point between two regions
/// is collapsed only along their border, under the same tolerance. Points on the rim stay.
/// Instead of a priority queue it uses sweeps over points that are not neighbours of each other, with a tolerance that
/// grows from round to round: equally fast, and without fans of slivers on flat faces.
class EdgeCollapse {
public:
    /// @param triangles  simplified in place
    /// @param regions    one per triangle, likewise
    void run(std::span<const glm::vec3> points, std::span<const glm::vec3> normals,
             std::vector<std::uint32_t>& triangles, std::vector<SurfaceRegion>& regions, float tolerance);

private:
    /// A triangle at the current point: its two other corners, in its orientation.
    struct Side {
        std::uint32_t first = 0, second = 0, triangle = 0;
    };

    void link();
    bool sweep(float tolerance);
    bool readStar(std::uint32_t point);
    bool orderStar();
    bool tryCollapse(std::uint32_t point, float tolerance);
    void sortTargets(std::uint32_t point);
    bool findBorderOfRegions();
    bool linkIsSound(std::uint32_t target);
    bool staysClose(std::uint32_t point, std::uint32_t target, float allowed, float& moved) const;
    bool borderStaysClose(std::uint32_t point, std::uint32_t target, float allowed, float& moved) const;
    void collapse(std::uint32_t point, std::uint32_t target, float moved);

    std::span<const glm::vec3> points_, normals_;
    std::vector<std::uint32_t>* triangles_ = nullptr;
    std::vector<SurfaceRegion>* regions_ = nullptr;
    std::vector<std::uint32_t> firstCorner_, nextCorner_; ///< chain of the corners at each point
    std::vector<float> moved_;                            ///< mm, greatest displacement of the surface around a point
    std::vector<std::uint8_t> state_;
    std::vector<std::uint32_t> touched_, stamp_;
    std::uint32_t sweep_ = 0, mark_ = 0;
    std::vector<Side> star_;             ///< around the current point, in order
    std::vector<std::uint32_t> targets_; ///< neighbours, nearest first
    std::vector<std::uint32_t> border_;  ///< neighbours along the border of two regions
};

} // namespace burin
