// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace burin {

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
    /// The place on the corner, else on the edge, else on the face nearby: an edge or a face no farther than `reach`
    /// from the face or from both; a corner twice as far along its edges. The place itself where there is none.
    virtual glm::vec3 sharpened(const glm::vec3& place, float reach) const noexcept = 0;
};

} // namespace burin
