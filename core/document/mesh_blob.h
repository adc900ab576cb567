// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// A mesh in few bytes; every bit of every coordinate comes back.
std::string encodeMesh(const TriangleMesh& mesh);

/// Nothing when the blob is damaged or a triangle names a vertex that isn't there.
std::optional<TriangleMesh> decodeMesh(std::string_view blob);

/// What the meshes of one file take in memory. Each alone is held to its packed size by `decodeMesh`; many small blobs
/// could still come to gigabytes.
class MeshesTogether {
public:
    /// False: they take more than their blobs can come to. @param packed bytes of the blob that `mesh` was read from
    bool add(const TriangleMesh& mesh, std::size_t packed) noexcept;

private:
    std::size_t taken_ = 0, packed_ = 0;
};

/// Six doubles of a box, bit for bit (an empty box is infinite, which JSON can't write).
std::string encodeBox(const Box& box);
std::optional<Box> decodeBox(std::string_view blob);

} // namespace burin
