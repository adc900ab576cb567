// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace burin {

/// How far, and to which points, a surface made of cells is moved.
struct SharpeningRaster {
    float reach = 0.0F;     ///< mm
    glm::vec3 origin{0.0F}; ///< mm, setup frame
    float cell = 1.0F;      ///< mm
};

/// Faces of a solid that are known exactly, independently of the voxels: where a workpiece still has them, its surface
/// is drawn with their sharp edges. All positions in mm, setup frame. Thread-safe.
class KnownFaces {
public:
    /// From 1 on.
    using Number = std::uint8_t;
    static constexpr Number none = 0;

    virtual ~KnownFaces() = default;

    /// The face that a triangle lies in, within 1 µm; `none` if in no face.
    virtual Number faceOf(const std::array<glm::vec3, 3>& triangle) const noexcept = 0;
    /// Unit length, outwards.
    virtual glm::vec3 normal(Number face, const glm::vec3& place) const noexcept = 0;
    /// The point on all faces that are within reach: on a corner, an edge or a face; the point itself if there is none.
    /// On an edge it is rounded to the raster, so that rows of points that meet there coincide. Keeps the order of
    /// points along each axis, so that no triangle is folded.
    virtual glm::vec3 sharpened(const glm::vec3& point, const SharpeningRaster& raster) const noexcept = 0;
};

} // namespace burin
