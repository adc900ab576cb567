// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <string>

namespace burin::test {

inline constexpr PropertyIndex wax = 1, aluminium = 2, part = 3;

/// Air, two machinable materials, one protected.
inline PropertyList someProperties() {
    PropertyList list;
    for (const char* id : {"wax", "aluminium", "part"}) {
        Property property;
        property.id = property.name = id;
        if (std::string(id) == "part") property.machinability = Machinability::isProtected;
        (void)list.add(property);
    }
    return list;
}

inline Grid cubeGrid(glm::ivec3 count, RunAxis axis = RunAxis::z, double edge = 1.0) {
    return *Grid::make(glm::dvec3(0.0), edge, count, axis);
}

inline RunVolume emptyVolume(const Grid& grid, std::size_t reservedBytes = 0) {
    return *RunVolume::make(grid, someProperties(), reservedBytes);
}

} // namespace burin::test
