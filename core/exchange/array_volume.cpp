// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/array_volume.h"

#include "core/base/numbers.h"
#include "core/volume/operations/dense.h"

#include <new>

namespace burin {

namespace {

Error unknownValue(const VoxelArray& array, std::size_t place) {
    const auto x = place % static_cast<std::size_t>(array.count.x);
    const std::size_t row = place / static_cast<std::size_t>(array.count.x);
    const auto y = row % static_cast<std::size_t>(array.count.y), z = row / static_cast<std::size_t>(array.count.y);
    const auto number = [](std::size_t value) { return std::to_string(value); };
    const glm::dvec3 middle =
        array.low +
        array.edge * (glm::dvec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)) + 0.5);
    return {ErrorCode::argumentInvalid, array.file, formatShortest(array.at(place)),
            "values that the table has an entry for; voxel " + number(x) + ", " + number(y) + ", " + number(z) +
                " at X" + formatShortest(middle.x) + " Y" + formatShortest(middle.y) + " Z" + formatShortest(middle.z) +
                " mm is the first without"};
}

} // namespace

Result<RunVolume> volumeOf(const VoxelArray& array, const ArrayTable& table) try {
    const Result<Grid> grid = Grid::make(array.low, array.edge, array.count);
    if (!grid) return grid.error();
    const std::size_t voxels = std::visit([](const auto& numbers) { return numbers.size(); }, array.values);
    std::vector<PropertyIndex> properties(voxels);
    double last = 0.0; // neighbours are often equal: most voxels need no search
    std::optional<PropertyIndex> known = table.of(last);
    for (std::size_t i = 0; i < voxels; ++i) {
        if (const double value = array.at(i); value != last) {
            last = value;
            known = table.of(value);
        }
        if (!known) return unknownValue(array, i);
        properties[i] = *known;
    }
    return fromDense(*grid, table.materials(), properties);
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, array.file, {}, {}};
}

WholeVoxels wholeVoxels(const VolumeSnapshot& volume) {
    WholeVoxels whole{toDense(volume), 0};
    const Grid& grid = volume.grid();
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            for (const Segment segment : volume.line(line))
                if (segment.end() % unitsPerVoxel != 0) ++whole.roundedEnds;
    return whole;
}

} // namespace burin
