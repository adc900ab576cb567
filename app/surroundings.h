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

/// The arguments for fixtures and limits of a setup and for the tool's axis, as given by the user.
struct SurroundingsArguments {
    std::vector<std::string> fixtures, keepOuts;
    double clearance = 1.0; ///< mm
    std::string axis, travel;
};

/// Declares --fixture, --keep-out, --clearance, --axis and --travel.
void addSurroundings(CommandParser command, SurroundingsArguments& arguments);
/// Declares --axis alone.
void addAxis(CommandParser command, std::string& axis);

/// The fixtures, which are read in child processes, followed by the keep-out volumes.
/// @param fileUnit mm per unit of a file that states none. Errors: those of importModel and fixturesOf,
/// argumentInvalid.
Result<std::vector<Obstacle>> obstaclesOf(const SurroundingsArguments& arguments, double fileUnit, Progress& progress);
/// "fixed", "free" or "X,Y,Z"; a direction of any length. Errors: argumentInvalid.
Result<AxisMode> axisModeOf(const std::string& axis);
/// "middle", "off" or "X,Y,Z". Errors: argumentInvalid.
Result<TravelPlacement> travelPlacementOf(const std::string& travel);

/// The fixtures and limits of a project, and how its tool is held.
struct Around {
    std::vector<Obstacle> obstacles;
    AxisMode axis;
    TravelPlacement travel;
    ProgramTarget target;
};
Result<Around> aroundOf(const Project& project);

/// Id of the requested machine, or of the project's. If that one is not known here, it is replaced by another one, and
/// a message reports which.
std::string machineFor(const Project& project, const std::string& asked, CommandContext& context);

/// The requested dialect; otherwise that of the project's programs if the machine is theirs; otherwise that of the
/// machine's control.
std::string dialectFor(const std::string& asked, const ProgramTarget& target, const MachineProfile& machine);

/// Concatenates both lists; names that `kept` already has get numbers, so that every obstacle has its own name.
std::vector<Obstacle> joined(std::vector<Obstacle> kept, std::vector<Obstacle> added);

/// {"mode": "fixed" | "chosen" | "free", "direction"}
nlohmann::json jsonOf(const AxisMode& axis);
nlohmann::json jsonOf(const Obstacle& obstacle);
nlohmann::json jsonOf(const std::vector<Obstacle>& obstacles);
nlohmann::json jsonOf(const TravelPlacement& placement);
/// {"layer", "kind", "name", "on"}, by number.
nlohmann::json jsonOf(const std::vector<BoundLayer>& layers);

/// The same as readable text, one line each.
std::string textOf(const AxisMode& axis);
std::string textOf(const Obstacle& obstacle);
/// "fixture vise", "the part", "the machine's travel"
std::string textOf(const BoundLayer& layer);

} // namespace burin
