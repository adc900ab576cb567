// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removal.h"

#include <string>

namespace burin::tests {

inline constexpr PropertyIndex softStock = 1, hardStock = 2, part = 3;

inline Property material(const std::string& id, double energy, double radialRatio,
                         Machinability machinability = Machinability::machinable) {
    Property property;
    property.id = id;
    property.machinability = machinability;
    property.values.emplace(specificCuttingEnergy, NamedValue{energy, "J/mm^3", "test", false});
    property.values.emplace(radialForceRatio, NamedValue{radialRatio, "1", "test", false});
    return property;
}

/// Two machinable materials and a protected part.
inline PropertyList materials() {
    PropertyList list;
    (void)list.add(material("soft", 0.5, 0.3));
    (void)list.add(material("hard", 2.0, 0.5));
    (void)list.add(material("part", 1.0, 0.4, Machinability::isProtected));
    return list;
}

inline Grid grid(const glm::dvec3& low, double edge, const glm::ivec3& count) {
    return Grid::make(low, edge, count).value();
}

/// A grid filled with one material.
inline RunVolume block(const Grid& grid, PropertyIndex property = softStock) {
    RunVolume volume = RunVolume::make(grid, materials()).value();
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) (void)volume.fillSpan(line, 0, grid.lineEnd(), property);
    return volume;
}

/// A point on a scanline, mm, setup frame. @param units from the line's low end
inline glm::dvec3 placeOn(const Grid& grid, LineIndex line, double units) {
    const VoxelIndex voxel = grid.voxel(line, 0);
    glm::dvec3 index(voxel.i + 0.5, voxel.j + 0.5, voxel.k + 0.5);
    index[static_cast<int>(grid.axis())] = units / unitsPerVoxel;
    return grid.low() + grid.edge() * index;
}

inline Cutter ball(double diameter, double fluteLength) {
    return {CutterType::ball, diameter, 0.5 * diameter, fluteLength, 0.9 * diameter, fluteLength + 10.0, {}};
}
inline Cutter flat(double diameter, double fluteLength) {
    return {CutterType::flat, diameter, 0.0, fluteLength, 0.9 * diameter, fluteLength + 10.0, {}};
}
inline Cutter bullNose(double diameter, double corner, double fluteLength) {
    return {CutterType::bullNose, diameter, corner, fluteLength, 0.9 * diameter, fluteLength + 10.0, {}};
}

inline std::uint64_t unitsOf(const CutResult& cut, PropertyIndex property) {
    for (const MaterialVolume& material : cut.removed)
        if (material.property == property) return material.units;
    return 0;
}

} // namespace burin::tests
