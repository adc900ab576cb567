// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/face_colours.h"
#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Encodes a mesh compactly, without loss of any bit of its coordinates.
std::string encodeMesh(const TriangleMesh& mesh);

/// Empty if the blob is damaged or a triangle names a vertex that does not exist.
std::optional<TriangleMesh> decodeMesh(std::string_view blob);

/// Returns the bytes that follow a mesh in its blob, and that `decodeMesh` and older versions of Burin skip; empty if
/// no face has a colour of its own.
std::string encodeFaceColours(const FaceColours& colours);
/// Empty if the blob is damaged; no colours if it has none. @param triangles of its mesh
std::optional<FaceColours> decodeFaceColours(std::string_view blob, std::size_t triangles);

/// Limits the total memory of the meshes of one file. `decodeMesh` limits each mesh by its packed size; many small
/// blobs could still expand to gigabytes.
class MeshesTogether {
public:
    /// Returns false if the meshes take more memory than their blobs can justify. @param packed bytes of the blob of
    /// `mesh`
    bool add(const TriangleMesh& mesh, std::size_t packed) noexcept;

private:
    std::size_t taken_ = 0, packed_ = 0;
};

/// The six doubles of a box, bit for bit (an empty box is infinite, which JSON can't represent).
std::string encodeBox(const Box& box);
std::optional<Box> decodeBox(std::string_view blob);

} // namespace burin
