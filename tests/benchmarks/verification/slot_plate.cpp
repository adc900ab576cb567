// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/verification/slot_plate.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "tests/benchmarks/measure/session.h"

namespace burin::benchmarks {

namespace {

Model plate() {
    Body body;
    body.name = "plate";
    for (int corner = 0; corner < 8; ++corner)
        body.mesh.vertices.emplace_back(corner & 1 ? 70.0 : 0.0, corner & 2 ? 50.0 : 0.0, corner & 4 ? 3.0 : 0.0);
    body.mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    body.box = boundingBox(body.mesh);
    Model model;
    model.bodies.push_back(std::move(body));
    return model;
}

std::string program() {
    std::string text = "G21 G90 G17 G54\nT1 M6\nS12000 M3\nG0 Z5\n";
    for (int slot = 0; slot < SlotPlate::slots; ++slot) {
        const std::string y = formatFixed(-17.13 + 11.37 * slot, 3);
        const double from = -21.71, to = from + SlotPlate::length;
        text += "G0 X" + formatFixed(from, 3) + " Y" + y + "\n";
        for (int pass = 1; pass <= SlotPlate::passes; ++pass)
            text += "G1 Z" + formatFixed(-SlotPlate::depth * pass / SlotPlate::passes, 3) + " F200\nG1 X" +
                    formatFixed(pass % 2 == 1 ? to : from, 3) + " F800\n";
        text += "G0 Z5\n";
    }
    return text + "M2\n";
}

} // namespace

SlotPlate::SlotPlate()
    : text(program())
    , volume(slots * depth * (length * 2.0 * radius + pi * radius * radius))
    , model(plate())
    , part(model.bodies.front().mesh) {
    Setup setup;
    setup.voxel = 0.1;
    setup.marginLow = glm::dvec3(0.0);
    setup.marginHigh = {0.0, 0.0, 5.0};
    request.setup = require(placeStock(model, setup), "the plate's stock");
    request.model = &model;
    request.part = &part;
    request.tool.id = "flat";
    request.tool.cutter = {CutterType::flat, 2.0 * radius, 0.0, 12.0, 6.0, 30.0, {}};
    request.machine.travel = glm::dvec3(500.0);
    request.machine.maximumFeed = request.machine.rapidFeed = 5000.0;
    request.machine.maximumSpindleSpeed = 24000.0;
}

} // namespace burin::benchmarks
