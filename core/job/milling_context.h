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

/// What a project is worked on with: its part on a fine mesh, its workpiece as the takes so far left it, one tool in
/// one machine. Made from a project in seconds; the project stays the truth.
/// Thread: one at a time; the haptic loop while it mills.
struct MillingContext {
    std::shared_ptr<const Model> model;     ///< all that was imported, as it lies in the setup; never null
    std::shared_ptr<const Model> partModel; ///< the bodies that nothing may cut, maybe none; never null
    Setup setup;
    std::vector<Property> materials; ///< that the project keeps, by id; the library has the others
    Tool tool;
    MachineProfile machine;
    CuttingConditions conditions; ///< of the tool in the stock's material
    MeshDistance part;            ///< all bodies of `partModel`
    EmbeddedSetup embedded;
    std::vector<Obstacle> obstacles;    ///< around the stock
    std::vector<Obstacle> bodyFixtures; ///< bodies of the model that hold it
    TravelPlacement travel;
    std::shared_ptr<MilledStock> stock; ///< as paths leave it; of model, setup and materials; never null

    std::vector<Obstacle> surroundings() const; ///< all that the tool keeps clear of: `obstacles`, then `bodyFixtures`
    Box tipRegion() const; ///< where the tip may go: stock grown by the cutter, up to the safe height, mm
    Box tipRegion(const Tool& other) const; ///< the same for another tool
    double safeHeight() const;              ///< mm, setup frame: above the stock and what stands beside it
    double workpieceVolume() const;         ///< mm³ of machinable material
};

/// What a milling context is made of, as values: no project is needed on the thread that makes it.
struct MillingContextRequest {
    std::shared_ptr<const Model> model; ///< as it lies in the setup
    Setup setup;
    Tool tool;
    std::string machineId;
    std::vector<Property> materials; ///< by id; the library has the others
    std::vector<Obstacle> obstacles{};
    TravelPlacement travel{};
};

/// Errors: those of loadMaterial, loadMachine, embed, cuttingConditions, checkObstacle, cancelled.
Result<MillingContext> makeMillingContext(const MillingContextRequest& request, Progress& progress);
/// The same from a project; its own machine where `machineId` is empty. Errors: also projectIncomplete.
Result<MillingContext> makeMillingContext(const Project& project, const Tool& tool, const std::string& machineId,
                                          Progress& progress);

/// The tool of a project by id, or of the library where the project has none of that name.
Result<Tool> toolFor(const Project& project, const std::string& id);

/// The field that a tool's proxy moves in; a field without walls where the model has no body.
/// Errors: cancelled, outOfMemory.
Result<std::unique_ptr<const ClearanceField>> clearanceField(const MillingContext& milling, double maximumAllowance,
                                                             Progress& progress);
/// The same for a tool that the milling context is about to get: its own stays in force meanwhile.
Result<std::unique_ptr<const ClearanceField>> clearanceField(const MillingContext& milling, const Tool& tool,
                                                             double maximumAllowance, Progress& progress);

} // namespace burin
