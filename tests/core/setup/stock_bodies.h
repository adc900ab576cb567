// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"
#include "tests/core/volume/shapes.h"

#include <string>
#include <utility>
#include <vector>

namespace burin::test {

inline Body bodyOf(const std::string& name, TriangleMesh mesh) {
    Body body;
    body.name = name;
    body.box = boundingBox(mesh);
    body.volume = signedVolume(mesh);
    body.area = 6.0 * body.box.size().x * body.box.size().y; // of the right order of magnitude
    body.mesh = std::move(mesh);
    return body;
}

inline Model modelOf(std::vector<Body> bodies) {
    Model model;
    model.sourceFile = "part.step";
    model.bodies = std::move(bodies);
    return model;
}

inline Property materialOf(const std::string& id, double energy, double weight) {
    Property material;
    material.id = material.name = id;
    material.values[std::string(specificCuttingEnergy)] = {energy, "J/mm^3", "a test", true};
    material.values[std::string(density)] = {weight, "g/cm^3", "a test", true};
    return material;
}

/// A metal, a wood, a foam, and an unmeasured material.
inline std::vector<Property> fourMaterials() {
    std::vector<Property> materials{materialOf("metal", 1.0, 2.7), materialOf("brass", 0.8, 8.5),
                                    materialOf("beech", 0.1, 0.7), materialOf("foam", 0.02, 0.1)};
    Property unknown;
    unknown.id = unknown.name = "unmeasured";
    materials.push_back(unknown);
    return materials;
}

inline Setup setupOf(double voxel, double margin) {
    Setup setup;
    setup.voxel = voxel;
    setup.marginLow = setup.marginHigh = glm::dvec3(margin);
    setup.stockMaterial = "metal";
    return setup;
}

inline Result<EmbeddedSetup> embedded(const Model& model, const Setup& asked) {
    const Result<Setup> setup = placeStock(model, asked);
    if (!setup) return setup.error();
    Progress progress;
    return embed(model, *setup, fourMaterials(), progress);
}

/// Id of the material at a point; "" for air. The scanline used is the one whose centre is nearest.
inline std::string materialAt(const RunVolume& volume, const glm::dvec3& place) {
    const Grid& grid = volume.grid();
    const auto line = [&](int axis) {
        return static_cast<std::int32_t>(std::floor((place[axis] - grid.low()[axis]) / grid.edge()));
    };
    const LineIndex index{line(grid.axisOfU()), line(grid.axisOfV())};
    if (!grid.contains(index)) return {};
    const double unit = (place[grid.axisOfRuns()] - grid.low()[grid.axisOfRuns()]) / grid.edge() * 256.0;
    for (const Segment segment : volume.line(index))
        if (unit < static_cast<double>(segment.end()))
            return segment.property() == airProperty ? std::string() : volume.properties()[segment.property()].id;
    return {};
}

/// mm³ of one entry; 0 if there is none with that id.
inline double volumeOf(const RunVolume& volume, const std::string& id) {
    for (int i = 1; i < volume.properties().size(); ++i)
        if (const auto index = static_cast<PropertyIndex>(i); volume.properties()[index].id == id)
            return static_cast<double>(volume.amounts().units[index]) * volume.grid().unitVolume();
    return 0.0;
}

} // namespace burin::test
