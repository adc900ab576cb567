// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/face_colours.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

// The appearance of a model while its mesh is still being made. These types are for display only: they are neither
// Model nor TriangleMesh, so that nothing can be embedded in them, milled to them or measured on them.

/// Triangles for display: coarse, possibly with holes between them.
struct PreviewMesh {
    std::vector<glm::vec3> vertices; ///< mm, frame of the model
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct PreviewBody {
    std::string name;                                  ///< as `Body::name`
    std::optional<std::array<std::uint8_t, 3>> colour; ///< as `Body::colour`
    PreviewMesh mesh;
    FaceColours faceColours{}; ///< as `Body::faceColours`
};

struct ModelPreview {
    std::string sourceFile; ///< absolute path
    std::vector<PreviewBody> bodies;
};

} // namespace burin
