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

/// What a triangle belongs to: a material, and a known face of the workpiece (KnownFaces) or none.
struct SurfaceRegion {
    PropertyIndex material = airProperty;
    KnownFaces::Number face = KnownFaces::none;
    friend bool operator==(SurfaceRegion, SurfaceRegion) = default;
    /// Whether the border between two regions must be kept: colours change there, or faces meet in a sharp edge.
    bool bordersOn(SurfaceRegion other) const noexcept {
        return material != other.material ||
               (face != other.face && face != KnownFaces::none && other.face != KnownFaces::none);
    }
};

/// Thins a triangle mesh out by drawing points into a neighbour. A point goes only if it lies within the tolerance of
/// the planes of all triangles that come in its place, what earlier steps moved there included; if no triangle turns
/// over, neither at once nor step by step; and if the surface stays a surface. A point between two regions goes
/// along their border only, under the same tolerance. Points on the rim stay.
/// Sweeps of points that are no neighbours of each other take the place of a priority queue, the tolerance growing from
/// round to round: as fast, and no fans of slivers on flat faces.
class EdgeCollapse {
public:
    /// @param triangles thinned out in place
    /// @param regions one a triangle, likewise
    void run(std::span<const glm::vec3> points, std::span<const glm::vec3> normals,
             std::vector<std::uint32_t>& triangles, std::vector<SurfaceRegion>& regions, float tolerance);

private:
    /// A triangle at the point in question: the two others corners, in its turn.
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
    std::vector<std::uint32_t> firstCorner_, nextCorner_; ///< the corners at each point, a chain
    std::vector<float> moved_;                            ///< mm, what the surface has moved at most around a point
    std::vector<std::uint8_t> state_;
    std::vector<std::uint32_t> touched_, stamp_;
    std::uint32_t sweep_ = 0, mark_ = 0;
    std::vector<Side> star_;             ///< round the point in question, in order
    std::vector<std::uint32_t> targets_; ///< neighbours, near ones first
    std::vector<std::uint32_t> border_;  ///< neighbours that the border of two regions leads to
};

} // namespace burin
