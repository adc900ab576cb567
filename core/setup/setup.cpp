// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/setup.h"

#include "core/base/available_memory.h"
#include "core/base/numbers.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double bytesPerMegabyte = 1e6;

Error invalid(const char* parameter, const char* allowed) {
    return {ErrorCode::stockInvalid, parameter, {}, allowed};
}

bool isLength(const glm::dvec3& v) {
    return isFinite(v) && v.x >= 0.0 && v.y >= 0.0 && v.z >= 0.0;
}

std::string megabytes(double value) {
    return formatFixed(value, 0) + " MB";
}

} // namespace

Result<Setup> placeStock(const Model& model, Setup setup) {
    if (!(std::isfinite(setup.voxel) && setup.voxel > 0.0)) return invalid("voxel", "a finite length above 0 mm");
    if (!isLength(setup.marginLow) || !isLength(setup.marginHigh))
        return invalid("margin", "finite lengths of 0 mm or more");
    Box box;
    for (const Body& body : model.bodies) box.include(body.box);
    if (box.empty()) return invalid("part", "a model with at least one body");
    setup.stock = {box.low - setup.marginLow, box.high + setup.marginHigh};
    setup.workOffset = {setup.stock.centre().x, setup.stock.centre().y, setup.stock.high.z};
    return setup;
}

Result<EmbeddingSize> embeddingSize(const Setup& setup) {
    if (!(std::isfinite(setup.voxel) && setup.voxel > 0.0)) return invalid("voxel", "a finite length above 0 mm");
    if (setup.stock.empty() || !isFinite(setup.stock.low) || !isFinite(setup.stock.high))
        return invalid("stock", "a finite box");
    EmbeddingSize size;
    for (int axis = 0; axis < 3; ++axis) {
        // A stock of a whole number of voxels must not gain one by the rounding of a division.
        const double voxels = std::max(1.0, std::ceil(setup.stock.size()[axis] / setup.voxel - 1e-6));
        if (voxels > Grid::maximumVoxelsPerAxis)
            return Error{ErrorCode::volumeTooLarge,
                         formatFixed(voxels, 0) + " voxels on one axis",
                         std::to_string(Grid::maximumVoxelsPerAxis) + " voxels",
                         {}};
        size.voxels[axis] = static_cast<int>(voxels);
    }
    const Result<Grid> grid = Grid::make(setup.stock.low, setup.voxel, size.voxels, setup.runs);
    if (!grid) return grid.error();
    size.megabytes = static_cast<double>(RunVolume::defaultReserve(*grid)) / bytesPerMegabyte;
    // The other half is for meshes, fields, pictures and the rest of the machine.
    const double limit = 0.5 * static_cast<double>(availableMemory()) / bytesPerMegabyte;
    if (size.megabytes > limit)
        return Error{ErrorCode::volumeTooLarge, megabytes(size.megabytes), megabytes(limit), {}};
    return size;
}

} // namespace burin
