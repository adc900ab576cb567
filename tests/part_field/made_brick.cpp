// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/made_brick.h"

#include <algorithm>

namespace burin {

float distanceIn(const MadeBrick& made, const glm::vec3& place) noexcept {
    const glm::ivec3 cell = glm::clamp(glm::ivec3(place), 0, CellGrid::cells - 1);
    const glm::vec3 share = place - glm::vec3(cell);
    const std::size_t first = CellGrid::sampleAt(cell.x, cell.y, cell.z);
    const bool wide = made.header.wide != 0;
    const auto residual = [&](std::size_t step) noexcept {
        return wide ? static_cast<float>(made.wide[first + step]) : static_cast<float>(made.narrow[first + step]);
    };
    const auto alongX = [&](std::size_t step) noexcept {
        return glm::mix(residual(step), residual(step + 1), share.x);
    };
    const float rest =
        glm::mix(glm::mix(alongX(0), alongX(9), share.y), glm::mix(alongX(81), alongX(90), share.y), share.z);
    const auto& [x, y, z] = made.header.slope;
    return made.header.base + glm::dot(glm::vec3(x, y, z), place) + made.header.quantum * rest;
}

bool isExactIn(const MadeBrick& made, const glm::vec3& place) noexcept {
    const glm::ivec3 cell = glm::clamp(glm::ivec3(place), 0, CellGrid::cells - 1);
    return ((made.exactMask[static_cast<std::size_t>(cell.z)] >> (cell.x + 8 * cell.y)) & 1U) != 0;
}

namespace {

using Face = std::array<float, CellGrid::along * CellGrid::along>;

/// The samples of a brick on a face perpendicular to an axis. @param at 0 or 8 along it
Face faceOf(const MadeBrick& made, int axis, int at) noexcept {
    constexpr std::array<int, 3> step{1, CellGrid::along, CellGrid::along * CellGrid::along};
    const auto a = static_cast<std::size_t>(axis), u = (a + 1) % 3, v = (a + 2) % 3;
    const FineBrick& header = made.header;
    const float base = header.base + header.slope[a] * static_cast<float>(at);
    Face face;
    const auto fill = [&](const auto* samples) noexcept {
        std::size_t place = 0;
        for (int j = 0; j < CellGrid::along; ++j) {
            const float row = base + header.slope[v] * static_cast<float>(j);
            for (int i = 0; i < CellGrid::along; ++i)
                face[place++] = row + header.slope[u] * static_cast<float>(i) +
                                header.quantum * static_cast<float>(samples[at * step[a] + i * step[u] + j * step[v]]);
        }
    };
    if (header.wide != 0)
        fill(made.wide.data());
    else
        fill(made.narrow.data());
    return face;
}

} // namespace

float disagreement(const MadeBrick& first, const MadeBrick& second, int axis) noexcept {
    const Face end = faceOf(first, axis, CellGrid::cells), begin = faceOf(second, axis, 0);
    float most = 0.0F;
    for (std::size_t i = 0; i < end.size(); ++i) most = std::max(most, std::abs(end[i] - begin[i]));
    return most;
}

} // namespace burin
