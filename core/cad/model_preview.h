// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

// What a model looks like while its mesh is still being made. These types are for the picture alone: they are no Model
// and no TriangleMesh, so that nothing can be embedded in them, milled to them or measured on them.

/// Triangles to look at: coarse, and there may be holes between them.
struct PreviewMesh {
    std::vector<glm::vec3> vertices; ///< mm, frame of the model
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct PreviewBody {
    std::string name;                                  ///< as `Body::name`
    std::optional<std::array<std::uint8_t, 3>> colour; ///< as `Body::colour`
    PreviewMesh mesh;
};

struct ModelPreview {
    std::string sourceFile; ///< absolute path
    std::vector<PreviewBody> bodies;
};

} // namespace burin
