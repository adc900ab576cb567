// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/insert_overlap.h"

#include "core/base/numbers.h"
#include "core/volume/voxelisation/voxelisation.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// Cells along the longest side of the intersection of two boxes; fine enough to resolve a shared thousandth of a body.
constexpr double cellsAcross = 200.0;

Box shared(const Box& one, const Box& other) {
    return {glm::max(one.low, other.low), glm::min(one.high, other.high)};
}

/// Returns the volume that both bodies share, mm³, to the accuracy of the cells.
Result<double> sharedVolume(const Body& one, const Body& other, Progress& progress) {
    const Box box = shared(one.box, other.box);
    const glm::dvec3 size = box.size();
    if (box.empty() || !(std::min({size.x, size.y, size.z}) > 0.0)) return 0.0;
    const double cell = std::max({size.x, size.y, size.z}) / cellsAcross;
    const Result<Grid> grid = Grid::make(box.low, cell, glm::ivec3(glm::max(glm::ceil(size / cell - 1e-6), 1.0)));
    if (!grid) return grid.error();
    PropertyList list;
    std::vector<BodyMesh> bodies;
    for (const Body* body : {&one, &other}) {
        Property property;
        property.id = std::to_string(bodies.size());
        const Result<PropertyIndex> index = list.add(std::move(property));
        if (!index) return index.error();
        bodies.push_back({&body->mesh, *index});
    }
    Result<RunVolume> volume = RunVolume::make(*grid, list);
    if (!volume) return volume.error();
    const Result<std::vector<VoxelisationReport>> reports = voxelise(bodies, *volume, progress);
    if (!reports) return reports.error();
    return static_cast<double>(reports->back().replaced.units[bodies.front().property]) * grid->unitVolume();
}

} // namespace

Result<void> requireInsertsApart(const Model& model, const Setup& setup, Progress& progress) {
    constexpr double touching = 1e-3; // share of the smaller insert
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        for (std::size_t earlier = 0; earlier < i; ++earlier) {
            if (roleOf(setup, i) != BodyRole::insert || roleOf(setup, earlier) != BodyRole::insert) continue;
            const Body &one = model.bodies[earlier], &other = model.bodies[i];
            const Result<double> both = sharedVolume(one, other, progress);
            if (!both) return both.error();
            if (*both > touching * std::min(one.volume, other.volume))
                return Error{ErrorCode::argumentInvalid, "insert", nameOf(model, earlier) + ", " + nameOf(model, i),
                             "inserts that do not overlap; these share " + formatFixed(*both, 2) + " mm^3"};
        }
    return {};
}

} // namespace burin
