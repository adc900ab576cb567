// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// Consecutive triangles of a mesh whose faces have a colour of their own.
struct ColouredTriangles {
    std::uint32_t first = 0, count = 0;
    std::array<std::uint8_t, 3> colour{}; ///< sRGB

    friend bool operator==(const ColouredTriangles&, const ColouredTriangles&) = default;
};

/// The triangles of a mesh whose faces differ in colour from their body, in rising order; they do not overlap.
using FaceColours = std::vector<ColouredTriangles>;

/// Whether the colours are in order and belong to a mesh with this number of triangles.
bool areSound(const FaceColours& colours, std::size_t triangles) noexcept;

/// Appends triangles; those that continue the last ones in the same colour are merged with them.
void append(FaceColours& colours, const ColouredTriangles& more);

} // namespace burin
