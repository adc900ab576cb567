// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/document/project.h"
#include "core/field/tool_field.h"
#include "core/geometry/mesh_distance.h"
#include "core/job/milled_stock.h"
#include "core/machine/envelope.h"
#include "core/machine/machine_profile.h"
#include "core/setup/obstacle.h"
#include "core/setup/setup.h"

#include <memory>
#include <string>
#include <vector>

namespace burin {

/// Everything needed to mill a project: its part on a fine mesh, its workpiece as left by the takes so far, one tool in
/// one machine. Made from a project in seconds; the project remains authoritative.
/// Used by one thread at a time; by the haptic loop while it mills.
struct MillingContext {
    std::shared_ptr<const Model> model;     ///< everything that was imported, in the setup frame; never null
    std::shared_ptr<const Model> partModel; ///< the protected bodies, possibly none; never null
    Setup setup;
    std::vector<Property> materials; ///< stored in the project, by id; the others are in the library
    Tool tool;
    MachineProfile machine;
    CuttingConditions conditions; ///< of the tool in the stock's material
    MeshDistance part;            ///< all bodies of `partModel`
    EmbeddedSetup embedded;
    std::vector<Obstacle> obstacles;    ///< around the stock
    std::vector<Obstacle> bodyFixtures; ///< bodies of the model that hold the stock
    TravelPlacement travel;
    std::shared_ptr<MilledStock> stock; ///< as left by paths; made from model, setup and materials; never null

    std::vector<Obstacle> surroundings() const; ///< all fixtures and keep-out volumes: `obstacles`, then `bodyFixtures`
    Box tipRegion() const; ///< allowed region of the tip: stock grown by the cutter, up to the safe height, mm
    Box tipRegion(const Tool& other) const; ///< the same for another tool
    double safeHeight() const;              ///< mm, setup frame: above the stock and the fixtures around it
    double workpieceVolume() const;         ///< mm³ of machinable material
};

/// The input for a milling context, as values: the thread that makes it needs no project.
struct MillingContextRequest {
    std::shared_ptr<const Model> model; ///< in the setup frame
    Setup setup;
    Tool tool;
    std::string machineId;
    std::vector<Property> materials; ///< by id; the others are in the library
    std::vector<Obstacle> obstacles{};
    TravelPlacement travel{};
};

/// Errors: those of loadMaterial, loadMachine, embed, cuttingConditions, checkObstacle, cancelled.
Result<MillingContext> makeMillingContext(const MillingContextRequest& request, Progress& progress);
/// The same from a project; with the project's machine if `machineId` is empty. Errors: also projectIncomplete.
Result<MillingContext> makeMillingContext(const Project& project, const Tool& tool, const std::string& machineId,
                                          Progress& progress);

/// Returns a tool of the project by id, or of the library if the project has none with that id.
Result<Tool> toolFor(const Project& project, const std::string& id);

/// Returns the clearance field that a tool's proxy moves in; a field without obstacles if the model has no body.
/// Errors: cancelled, outOfMemory.
Result<std::unique_ptr<const ClearanceField>> clearanceField(const MillingContext& milling, double maximumAllowance,
                                                             Progress& progress);
/// The same for a tool that the milling context is about to get; its current tool stays in use meanwhile.
Result<std::unique_ptr<const ClearanceField>> clearanceField(const MillingContext& milling, const Tool& tool,
                                                             double maximumAllowance, Progress& progress);

} // namespace burin
