// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace burin {

/// How far and to which points a surface that was made of cells is moved.
struct SharpeningRaster {
    float reach = 0.0F;     ///< mm
    glm::vec3 origin{0.0F}; ///< mm, setup frame
    float cell = 1.0F;      ///< mm
};

/// Faces of a solid that are known exactly, whatever voxels made of them: where a workpiece still has them, its surface
/// is drawn with their sharp edges. All places in mm, setup frame. Thread: any, at the same time.
class KnownFaces {
public:
    /// From 1 on.
    using Number = std::uint8_t;
    static constexpr Number none = 0;

    virtual ~KnownFaces() = default;

    /// The face that a triangle lies in, within 1 µm; `none`: in no face.
    virtual Number faceOf(const std::array<glm::vec3, 3>& triangle) const noexcept = 0;
    /// Unit, outwards.
    virtual glm::vec3 normal(Number face, const glm::vec3& place) const noexcept = 0;
    /// The point on all faces that are no farther than the reach: on a corner, an edge or a face; the point itself
    /// where there is none. On an edge it is rounded to the raster, so that the rows of points that meet there become
    /// one. Keeps the order of points along each axis: no triangle is folded.
    virtual glm::vec3 sharpened(const glm::vec3& point, const SharpeningRaster& raster) const noexcept = 0;
};

} // namespace burin
