// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/base/progress.h"
#include "core/document/project.h"
#include "core/job/tool_bounds.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace burin {

class CommandContext;

/// What the command line says of what stands around a setup and of the tool's axis, as it was written.
struct SurroundingsArguments {
    std::vector<std::string> fixtures, keepOuts;
    double clearance = 1.0; ///< mm
    std::string axis, travel;
};

/// Declares --fixture, --keep-out, --clearance, --axis and --travel.
void addSurroundings(CommandParser command, SurroundingsArguments& arguments);
/// Declares --axis alone.
void addAxis(CommandParser command, std::string& axis);

/// The fixtures, read in child processes, then the keep-out volumes.
/// @param fileUnit mm per unit of a file that states none. Errors: those of importModel and fixturesOf,
/// argumentInvalid.
Result<std::vector<Obstacle>> obstaclesOf(const SurroundingsArguments& arguments, double fileUnit, Progress& progress);
/// "fixed", "free" or "X,Y,Z"; a direction of any length. Errors: argumentInvalid.
Result<AxisMode> axisModeOf(const std::string& axis);
/// "middle", "off" or "X,Y,Z". Errors: argumentInvalid.
Result<TravelPlacement> travelPlacementOf(const std::string& travel);

/// What a project says of what stands around its stock, and how its tool is held.
struct Around {
    std::vector<Obstacle> obstacles;
    AxisMode axis;
    TravelPlacement travel;
    ProgramTarget target;
};
Result<Around> aroundOf(const Project& project);

/// Id of the machine asked for, or of the project's. Where that one is not known here another one stands in, and a
/// message says which.
std::string machineFor(const Project& project, const std::string& asked, CommandContext& context);

/// What is asked for, or what the project's programs are for, or what another machine's control reads.
std::string dialectFor(const std::string& asked, const ProgramTarget& target, const MachineProfile& machine);

/// Names that `kept` has already get numbers; then both. So each obstacle can be told from the others.
std::vector<Obstacle> joined(std::vector<Obstacle> kept, std::vector<Obstacle> added);

/// {"mode": "fixed" | "chosen" | "free", "direction"}
nlohmann::json jsonOf(const AxisMode& axis);
nlohmann::json jsonOf(const Obstacle& obstacle);
nlohmann::json jsonOf(const std::vector<Obstacle>& obstacles);
nlohmann::json jsonOf(const TravelPlacement& placement);
/// {"layer", "kind", "name", "on"}, by number.
nlohmann::json jsonOf(const std::vector<BoundLayer>& layers);

/// The same for people, a line each.
std::string textOf(const AxisMode& axis);
std::string textOf(const Obstacle& obstacle);
/// "fixture vise", "the part", "the machine's travel"
std::string textOf(const BoundLayer& layer);

} // namespace burin
