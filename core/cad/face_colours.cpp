// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/face_colours.h"

namespace burin {

bool areSound(const FaceColours& colours, std::size_t triangles) noexcept {
    std::uint64_t end = 0;
    for (const ColouredTriangles& part : colours) {
        if (part.count == 0 || part.first < end) return false;
        end = std::uint64_t{part.first} + part.count;
    }
    return end <= triangles;
}

void append(FaceColours& colours, const ColouredTriangles& more) {
    if (more.count == 0) return;
    if (!colours.empty()) {
        ColouredTriangles& last = colours.back();
        if (last.colour == more.colour && last.first + last.count == more.first) {
            last.count += more.count;
            return;
        }
    }
    colours.push_back(more);
}

} // namespace burin
