// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/stock_shape.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr int faces = 6;
constexpr float onFace = 0.001F; ///< mm

constexpr int axisOf(int face) {
    return (face - 1) / 2;
}
constexpr bool isHigh(int face) {
    return face % 2 == 0;
}

} // namespace

bool BoxStock::fill(RunVolume& volume, PropertyIndex property) const {
    const Grid& grid = volume.grid();
    const auto line = [&](const glm::dvec3& corner, int axis) {
        const double centre = (corner[axis] - grid.low()[axis]) / grid.edge() - 0.5;
        return std::max(0, static_cast<std::int32_t>(std::ceil(centre - 1e-6)));
    };
    const int u = grid.axisOfU(), v = grid.axisOfV(), runs = grid.axisOfRuns();
    const LineIndex low{line(box_.low, u), line(box_.low, v)};
    const LineIndex high{std::max(low.u + 1, line(box_.high, u)), std::max(low.v + 1, line(box_.high, v))};
    return volume.fillBlock(low, high, grid.toRunPosition(box_.low[runs]), grid.toRunPosition(box_.high[runs]),
                            property);
}

float BoxStock::side(int face) const noexcept {
    return static_cast<float>(isHigh(face) ? box_.high[axisOf(face)] : box_.low[axisOf(face)]);
}

KnownFaces::Number BoxStock::faceOf(const std::array<glm::vec3, 3>& triangle) const noexcept {
    for (int face = 1; face <= faces; ++face) {
        const int axis = axisOf(face);
        const float at = side(face);
        if (std::abs(triangle[0][axis] - at) <= onFace && std::abs(triangle[1][axis] - at) <= onFace &&
            std::abs(triangle[2][axis] - at) <= onFace)
            return static_cast<Number>(face);
    }
    return none;
}

glm::vec3 BoxStock::normal(Number face, const glm::vec3&) const noexcept {
    glm::vec3 normal(0.0F);
    normal[axisOf(face)] = isHigh(face) ? 1.0F : -1.0F;
    return normal;
}

glm::vec3 BoxStock::sharpened(const glm::vec3& point, const SharpeningRaster& raster) const noexcept {
    glm::vec3 sharp = point;
    std::array<bool, 3> onSide{};
    for (int axis = 0; axis < 3; ++axis) {
        const int low = 2 * axis + 1, high = low + 1;
        const float toLow = std::abs(point[axis] - side(low)), toHigh = std::abs(point[axis] - side(high));
        if (std::min(toLow, toHigh) > raster.reach) continue;
        sharp[axis] = side(toLow <= toHigh ? low : high);
        onSide[static_cast<std::size_t>(axis)] = true;
    }
    if (std::count(onSide.begin(), onSide.end(), true) != 2) return sharp;
    const int along = static_cast<int>(std::find(onSide.begin(), onSide.end(), false) - onSide.begin());
    sharp[along] = raster.origin[along] + raster.cell * std::round((point[along] - raster.origin[along]) / raster.cell);
    return sharp;
}

} // namespace burin
