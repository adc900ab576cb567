// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"

#include <QByteArray>

namespace burin::testing {

/// A mesh as a text STL file, with coordinates that are exact to the last bit.
inline QByteArray stlText(const TriangleMesh& mesh, const QByteArray& name = "mesh") {
    QByteArray text = "solid " + name + '\n';
    for (const auto& triangle : mesh.triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const std::uint32_t corner : triangle) {
            const glm::dvec3& place = mesh.vertices[corner];
            text += "vertex " + QByteArray::number(place.x, 'g', 17) + ' ' + QByteArray::number(place.y, 'g', 17) +
                    ' ' + QByteArray::number(place.z, 'g', 17) + '\n';
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid " + name + '\n';
}

} // namespace burin::testing
