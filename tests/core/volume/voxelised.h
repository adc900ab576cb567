// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/voxelisation/voxelisation.h"
#include "tests/core/volume/volumes.h"

#include <algorithm>
#include <array>

namespace burin::test {

inline VoxelisationReport fill(const TriangleMesh& mesh, RunVolume& volume, PropertyIndex property = part) {
    Progress progress;
    return *voxelise(mesh, property, volume, progress);
}

inline PropertyIndex propertyAt(const RunVolume& volume, LineIndex line, RunPosition unit) {
    for (const Segment segment : volume.line(line))
        if (segment.end() > unit) return segment.property();
    return airProperty;
}

/// Volume, mm³, on a grid around the mesh; its low corner is `shift` of a voxel from a voxel face.
inline double volumeAlong(const TriangleMesh& mesh, int voxels, RunAxis axis, VoxelisationReport* report = nullptr,
                          double shift = 0.37) {
    const Box box = boundingBox(mesh);
    const double edge = std::max({box.size().x, box.size().y, box.size().z}) / (voxels - 3);
    const Grid grid = *Grid::make(box.low - glm::dvec3((1.0 + shift) * edge), edge,
                                  glm::ivec3(glm::ceil(box.size() / edge)) + 3, axis);
    RunVolume volume = emptyVolume(grid);
    const VoxelisationReport found = fill(mesh, volume);
    if (report != nullptr) *report = found;
    return static_cast<double>(volume.amounts().units[part]) * grid.unitVolume();
}

inline constexpr std::array everyAxis{RunAxis::x, RunAxis::y, RunAxis::z};

} // namespace burin::test
