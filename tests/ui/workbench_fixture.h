// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/cad/model.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"
#include "ui/theme/theme.h"

#include <cmath>
#include <memory>

namespace burin::fixture {

/// A palette in which no two roles share a colour, so that a pixel shows what was drawn.
inline Palette palette() {
    Palette p;
    p.window = QColor(0x14, 0x17, 0x1c);
    p.panel = QColor(0x1b, 0x20, 0x27);
    p.field = QColor(0x11, 0x14, 0x19);
    p.border = QColor(0x33, 0x3b, 0x46);
    p.text = QColor(0xe6, 0xe9, 0xee);
    p.quietText = QColor(0x8a, 0x93, 0xa0);
    p.accent = QColor(0xf2, 0xa2, 0x3a);
    p.force = QColor(0xe5, 0x50, 0x4a);
    p.inOrder = QColor(0x54, 0xb3, 0x6a);
    p.part = QColor(0x4f, 0x97, 0xdb);
    p.sceneTop = QColor(0x2b, 0x36, 0x45);
    p.sceneBottom = QColor(0x16, 0x1b, 0x22);
    p.grid = QColor(0x3c, 0x48, 0x58);
    p.flutes = QColor(0xdc, 0xe1, 0xe8);
    p.shank = QColor(0x8a, 0x98, 0xa8);
    p.holder = QColor(0x55, 0x5f, 0x6e);
    p.ghost = QColor(0x9f, 0xb6, 0xd0);
    p.coupling = QColor(0xbf, 0xd4, 0xee);
    p.guide = QColor(0xc9, 0xb0, 0xff);
    p.path = QColor(0xf2, 0xa2, 0x3b);
    p.livePath = QColor(0xff, 0xc0, 0x60);
    p.conventionalPath = QColor(0xff, 0x9c, 0xf0);
    p.rapidPath = QColor(0xb8, 0xc4, 0xd2);
    p.plungePath = QColor(0xf4, 0xf6, 0xf8);
    p.chosenPath = QColor(0xff, 0xf0, 0x4a);
    p.comparedPath = QColor(0x38, 0xf5, 0xe8);
    p.pathHalo = QColor(0x07, 0x09, 0x0c);
    return p;
}

/// The upper half of an ellipsoid, closed by its flat underside at z = 0, around the origin.
inline TriangleMesh dome(const glm::dvec3& radii, int around = 72, int up = 18) {
    TriangleMesh mesh;
    for (int ring = 0; ring < up; ++ring)
        for (int i = 0; i < around; ++i) {
            const double a = 2.0 * pi * i / around, b = 0.5 * pi * ring / up;
            mesh.vertices.push_back(radii *
                                    glm::dvec3(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)));
        }
    const auto top = static_cast<std::uint32_t>(mesh.vertices.size()), middle = top + 1;
    mesh.vertices.emplace_back(0.0, 0.0, radii.z);
    mesh.vertices.emplace_back(0.0);
    const auto at = [around](int ring, int i) { return static_cast<std::uint32_t>(ring * around + i % around); };
    for (int i = 0; i < around; ++i) {
        for (int ring = 0; ring + 1 < up; ++ring) {
            mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
            mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
        }
        mesh.triangles.push_back({at(up - 1, i), at(up - 1, i + 1), top});
        mesh.triangles.push_back({middle, at(0, i + 1), at(0, i)});
    }
    return mesh;
}

inline std::shared_ptr<const Model> model(const glm::dvec3& radii) {
    auto model = std::make_shared<Model>();
    Body body;
    body.name = "dome";
    body.mesh = dome(radii);
    body.box = boundingBox(body.mesh);
    model->bodies.push_back(std::move(body));
    return model;
}

inline constexpr PropertyIndex stockProperty = 1, partProperty = 2;

/// A block of stock (its low corner and size, mm) around the dome of `model`. Where x < 0 it is milled down to a floor
/// 4 mm above the dome's foot, or to the dome.
inline RunVolume milledBlock(const Box& block, double edge, const glm::dvec3& radii) {
    const Grid grid = Grid::make(block.low, edge, glm::ivec3(glm::round(block.size() / edge))).value();
    PropertyList properties;
    Property stock, part;
    stock.id = "stock";
    stock.colour = {188, 192, 198};
    part.id = "part";
    part.colour = {79, 151, 219};
    part.machinability = Machinability::isProtected;
    (void)properties.add(stock);
    (void)properties.add(part);
    RunVolume volume = RunVolume::make(grid, properties).value();
    for (int v = 0; v < grid.lineCountV(); ++v)
        for (int u = 0; u < grid.lineCountU(); ++u) {
            const glm::dvec2 centre = grid.lineCentre({u, v});
            const double inside = 1.0 - std::pow(centre.x / radii.x, 2) - std::pow(centre.y / radii.y, 2);
            const double domeTop = inside > 0.0 ? radii.z * std::sqrt(inside) : block.low.z;
            const double top = centre.x < 0.0 ? std::max(4.0, domeTop) : block.high.z;
            volume.fillSpan({u, v}, 0, grid.toRunPosition(top), stockProperty);
            if (inside > 0.0)
                volume.fillSpan({u, v}, grid.toRunPosition(0.0), grid.toRunPosition(domeTop), partProperty);
        }
    return volume;
}

/// A ball-end mill of 6 mm with shank and holder.
inline Tool ballTool() {
    Tool tool;
    tool.id = "ball-6";
    tool.name = "Ball 6 mm";
    tool.cutter = {CutterType::ball, 6.0, 3.0, 14.0, 8.0, 36.0, {{16.0, 20.0, 18.0}, {26.0, 26.0, 8.0}}};
    return tool;
}

} // namespace burin::fixture
