// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/brick_field.h"

#include <algorithm>

namespace burin {

namespace {

/// Value and gradient (per unit of the cell) between the eight corners of a cell, x running fastest.
struct Trilinear {
    double value;
    glm::dvec3 gradient;

    Trilinear(const std::array<double, 8>& c, const glm::dvec3& t) noexcept {
        const double x00 = c[0] + t.x * (c[1] - c[0]), x10 = c[2] + t.x * (c[3] - c[2]);
        const double x01 = c[4] + t.x * (c[5] - c[4]), x11 = c[6] + t.x * (c[7] - c[6]);
        const double y0 = x00 + t.y * (x10 - x00), y1 = x01 + t.y * (x11 - x01);
        value = y0 + t.z * (y1 - y0);
        gradient.z = y1 - y0;
        gradient.y = (x10 - x00) + t.z * ((x11 - x01) - (x10 - x00));
        const double d00 = c[1] - c[0], d10 = c[3] - c[2], d01 = c[5] - c[4], d11 = c[7] - c[6];
        const double d0 = d00 + t.y * (d10 - d00), d1 = d01 + t.y * (d11 - d01);
        gradient.x = d0 + t.z * (d1 - d0);
    }
};

template <class Number>
std::array<double, 8> cornersOfCell(const Number* first, std::size_t rowStep, std::size_t layerStep) noexcept {
    const auto number = [first](std::size_t i) { return static_cast<double>(first[i]); };
    return {number(0),
            number(1),
            number(rowStep),
            number(rowStep + 1),
            number(layerStep),
            number(layerStep + 1),
            number(layerStep + rowStep),
            number(layerStep + rowStep + 1)};
}

} // namespace

FieldSample BrickField::sample(const glm::dvec3& tip) const noexcept {
    glm::ivec3 cell, brick;
    glm::dvec3 part;
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) {
        const double wanted = tip[axis], low = tips.low[axis], high = tips.high[axis];
        const double kept = wanted > low ? (wanted < high ? wanted : high) : low; // NaN becomes low
        inside = inside && kept == wanted;
        const double along = (kept - low) / spacing;
        cell[axis] = std::min(static_cast<int>(along), bricks[axis] * cells - 1);
        part[axis] = along - cell[axis];
        brick[axis] = cell[axis] / cells;
    }
    const std::size_t number = brickAt(brick);
    if (place[number] != coarse) {
        const glm::ivec3 local = cell - brick * cells;
        const std::int16_t* first =
            samples.data() + static_cast<std::size_t>(place[number]) * samplesPerBrick + sampleAt(local);
        const Trilinear fine(cornersOfCell(first, samplesAlong, samplesAlong * samplesAlong), part);
        return {fine.value * quantum, fine.gradient * (quantum / spacing), inside};
    }
    const auto row = static_cast<std::size_t>(bricks.x + 1), layer = row * static_cast<std::size_t>(bricks.y + 1);
    const glm::dvec3 partOfBrick = (glm::dvec3(cell - brick * cells) + part) / static_cast<double>(cells);
    const Trilinear between(cornersOfCell(corners.data() + cornerAt(brick), row, layer), partOfBrick);
    return {between.value - static_cast<double>(coarseBound[number]), between.gradient / brickEdge(), false};
}

/// Coarse values are never too high; outside the box the true clearance decreases by no more than the distance to the
/// box.
double BrickField::bound(const glm::dvec3& tip) const noexcept {
    glm::dvec3 kept;
    for (int axis = 0; axis < 3; ++axis) // NaN becomes low
        kept[axis] = tip[axis] > tips.low[axis] ? std::min(tip[axis], tips.high[axis]) : tips.low[axis];
    const glm::ivec3 brick = glm::min(glm::ivec3((kept - tips.low) / brickEdge()), bricks - 1);
    const std::int32_t fine = place[brickAt(brick)];
    const double inside = fine == coarse ? 0.0 : static_cast<double>(fineBound[static_cast<std::size_t>(fine)]);
    return inside + glm::length(tip - kept);
}

} // namespace burin
