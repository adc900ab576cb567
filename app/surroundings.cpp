// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/surroundings.h"

#include "app/command.h"
#include "app/fixture_arguments.h"
#include "app/number_list.h"
#include "app/report.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/cad/import.h"
#include "core/geometry/pose.h"
#include "core/machine/machine_library.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace burin {

namespace {

using nlohmann::json;

constexpr glm::dvec3 upright(0.0, 0.0, 1.0);

Result<Obstacle> keepOutOf(const std::string& text, double clearance) {
    const Error wrong{
        ErrorCode::argumentInvalid, "--keep-out", text,
        worded(BURIN_TEXT("Command", "X0,Y0,Z0,X1,Y1,Z1 in mm, each of the last three above its counterpart"))};
    const std::optional<std::vector<double>> numbers = numbersOf(text, 6);
    if (!numbers) return wrong;
    Obstacle space;
    space.name = "keep-out";
    space.kind = ObstacleKind::keepOut;
    space.margin = clearance;
    space.shape = Box{{(*numbers)[0], (*numbers)[1], (*numbers)[2]}, {(*numbers)[3], (*numbers)[4], (*numbers)[5]}};
    if (!checkObstacle(space)) return wrong;
    return space;
}

const char* shapeName(const Obstacle& obstacle) {
    if (std::holds_alternative<Box>(obstacle.shape)) return "box";
    return std::holds_alternative<CylinderShape>(obstacle.shape) ? "cylinder" : "mesh";
}

const char* kindName(ObstacleKind kind) {
    return kind == ObstacleKind::fixture ? "fixture" : "keep-out";
}

const char* kindName(BoundLayer::Kind kind) {
    switch (kind) {
    case BoundLayer::Kind::part:
        return "part";
    case BoundLayer::Kind::fixture:
        return "fixture";
    case BoundLayer::Kind::keepOut:
        return "keep-out";
    case BoundLayer::Kind::machineTravel:
        return "machine travel";
    case BoundLayer::Kind::stock:
        return "stock";
    }
    return "";
}

/// The readable form of a name in JSON.
std::string wordFor(const char* name) {
    constexpr std::array words{BURIN_TEXT("Command", "box"), BURIN_TEXT("Command", "cylinder"),
                               BURIN_TEXT("Command", "mesh"), BURIN_TEXT("Command", "fixture"),
                               BURIN_TEXT("Command", "keep-out")};
    for (const TextId& word : words)
        if (std::string_view(name) == word.text) return worded(word);
    return name;
}

std::string textOf(const glm::dvec3& vector) {
    return formatShortest(vector.x) + ", " + formatShortest(vector.y) + ", " + formatShortest(vector.z);
}

/// Rounded to micrometres.
std::string lengthsOf(const glm::dvec3& place) {
    return textOf(glm::round(place * 1e3) / 1e3 + 0.0); // avoids "-0"
}

} // namespace

void addAxis(CommandParser command, std::string& axis) {
    command.option(
        "--axis", axis,
        BURIN_TEXT("Help", "Tool axis: fixed (+Z), X,Y,Z towards the holder (3+2), or free (it follows the stylus)"));
}

void addSurroundings(CommandParser command, SurroundingsArguments& arguments) {
    command
        .option("--fixture", arguments.fixtures,
                BURIN_TEXT("Help",
                           "Model of a fixture in the setup's frame (STEP, IGES, BREP, or a mesh); may be repeated"))
        .oneAtATime();
    command
        .option(
            "--keep-out", arguments.keepOuts,
            BURIN_TEXT("Help",
                       "Box that the tool must not enter, X0,Y0,Z0,X1,Y1,Z1 in the setup's frame, mm; may be repeated"))
        .oneAtATime();
    command
        .option("--clearance", arguments.clearance,
                BURIN_TEXT("Help", "Clearance between the tool and the added fixtures and keep-out volumes, mm"))
        .range(0.0, 100.0)
        .showDefault();
    addAxis(command, arguments.axis);
    command.option(
        "--travel", arguments.travel,
        BURIN_TEXT("Help", "Position of program zero in the machine's travel: X,Y,Z of the tip from its low end, mm; "
                           "middle (of X and Y, Z up to the tool change height); or off"));
}

Result<std::vector<Obstacle>> obstaclesOf(const SurroundingsArguments& arguments, double fileUnit, Progress& progress) {
    std::vector<Obstacle> obstacles;
    ImportOptions options;
    options.fileUnit = fileUnit;
    for (const std::string& file : arguments.fixtures) {
        const Result<Model> model = importModel(file, options, progress);
        if (!model) return model.error();
        Result<std::vector<Obstacle>> fixtures =
            fixturesOf(*model, std::filesystem::path(file).stem().string(), arguments.clearance);
        if (!fixtures) return std::move(fixtures).error();
        obstacles = joined(std::move(obstacles), std::move(*fixtures));
    }
    for (const std::string& text : arguments.keepOuts) {
        Result<Obstacle> space = keepOutOf(text, arguments.clearance);
        if (!space) return std::move(space).error();
        obstacles = joined(std::move(obstacles), {std::move(*space)});
    }
    return obstacles;
}

Result<AxisMode> axisModeOf(const std::string& axis) {
    if (axis == "fixed") return AxisMode{};
    if (axis == "free") return AxisMode{true, upright};
    const std::optional<glm::dvec3> direction = vectorOf(axis);
    const double length = direction ? glm::length(*direction) : 0.0;
    if (!(std::isfinite(length) && length > 1e-9))
        return Error{ErrorCode::argumentInvalid, "--axis", axis,
                     worded(BURIN_TEXT("Command", "fixed, free, or X,Y,Z that are not all zero"))};
    return AxisMode{false, *direction / length};
}

Result<TravelPlacement> travelPlacementOf(const std::string& travel) {
    if (travel == "middle") return TravelPlacement{};
    if (travel == "off") return TravelPlacement{false, std::nullopt};
    const std::optional<glm::dvec3> zero = vectorOf(travel);
    if (!zero)
        return Error{ErrorCode::argumentInvalid, "--travel", travel,
                     worded(BURIN_TEXT("Command", "middle, off, or X,Y,Z in mm"))};
    return TravelPlacement{true, zero};
}

Result<Around> aroundOf(const Project& project) {
    Result<std::vector<Obstacle>> obstacles = project.obstacles();
    if (!obstacles) return std::move(obstacles).error();
    const Result<AxisMode> axis = project.axisMode();
    if (!axis) return axis.error();
    const Result<TravelPlacement> travel = project.travelPlacement();
    if (!travel) return travel.error();
    const Result<ProgramTarget> target = project.programTarget();
    if (!target) return target.error();
    return Around{std::move(*obstacles), *axis, *travel, *target};
}

std::string machineFor(const Project& project, const std::string& asked, CommandContext& context) {
    if (!asked.empty()) return asked;
    const Result<ProgramTarget> target = project.programTarget();
    if (!target) return {}; // creating the milling context reports the same error
    const Result<MachineProfile> machine = loadMachine(target->machine);
    if (machine || machine.error().code != ErrorCode::nameUnknown) return target->machine;
    context.message(worded(BURIN_TEXT("Command", "The project's machine \"%1\" is not on this computer; \"%2\" is used "
                                                 "in its place. Choose another with --machine, or with burin setup "
                                                 "--machine."),
                           {target->machine, firstMachine}));
    return firstMachine;
}

std::string dialectFor(const std::string& asked, const ProgramTarget& target, const MachineProfile& machine) {
    if (!asked.empty()) return asked;
    return machine.id == target.machine ? target.dialectFor(machine) : machine.dialect;
}

std::vector<Obstacle> joined(std::vector<Obstacle> kept, std::vector<Obstacle> added) {
    for (Obstacle& obstacle : added) {
        const std::string name = obstacle.name;
        const auto taken = [&] {
            return std::ranges::any_of(kept, [&](const Obstacle& other) { return other.name == obstacle.name; });
        };
        for (int number = 2; taken(); ++number) obstacle.name = name + " " + std::to_string(number);
        kept.push_back(std::move(obstacle));
    }
    return kept;
}

json jsonOf(const AxisMode& axis) {
    const bool fixed = !axis.free && axis.direction == upright;
    return {{"mode", axis.free ? "free"
                     : fixed   ? "fixed"
                               : "chosen"},
            {"direction", axis.free ? json(nullptr) : jsonOf(axis.direction)}};
}

json jsonOf(const Obstacle& obstacle) {
    return {{"name", obstacle.name},
            {"kind", kindName(obstacle.kind)},
            {"shape", shapeName(obstacle)},
            {"bounding_box_mm", jsonOf(boundsOf(obstacle))},
            {"clearance_mm", obstacle.margin},
            {"on", obstacle.on},
            {"library", obstacle.design ? jsonOf(*obstacle.design) : json(nullptr)}};
}

json jsonOf(const std::vector<Obstacle>& obstacles) {
    json list = json::array();
    for (const Obstacle& obstacle : obstacles) list.push_back(jsonOf(obstacle));
    return list;
}

json jsonOf(const TravelPlacement& placement) {
    return {{"on", placement.on}, {"zero_mm", placement.zero ? jsonOf(*placement.zero) : json(nullptr)}};
}

json jsonOf(const std::vector<BoundLayer>& layers) {
    json list = json::array();
    for (const BoundLayer& layer : layers)
        list.push_back(
            {{"layer", list.size()}, {"kind", kindName(layer.kind)}, {"name", layer.name}, {"on", layer.on}});
    return list;
}

std::string textOf(const AxisMode& axis) {
    if (axis.free) return worded(BURIN_TEXT("Command", "free, with the stylus"));
    return axis.direction == upright ? worded(BURIN_TEXT("Command", "fixed, +Z"))
                                     : worded(BURIN_TEXT("Command", "chosen, %1"), {textOf(axis.direction)});
}

std::string textOf(const Obstacle& obstacle) {
    const Box box = boundsOf(obstacle);
    return worded(obstacle.on ? BURIN_TEXT("Command", "%1 \"%2\": %3 from (%4) to (%5) mm, clearance %6 mm")
                              : BURIN_TEXT("Command", "%1 \"%2\": %3 from (%4) to (%5) mm, clearance %6 mm, off"),
                  {wordFor(kindName(obstacle.kind)), obstacle.name,
                   obstacle.design ? worded(rowOf(obstacle.design->kind).title) : wordFor(shapeName(obstacle)),
                   lengthsOf(box.low), lengthsOf(box.high), formatShortest(obstacle.margin)});
}

std::string textOf(const BoundLayer& layer) {
    switch (layer.kind) {
    case BoundLayer::Kind::part:
        return worded(BURIN_TEXT("Command", "the part"));
    case BoundLayer::Kind::machineTravel:
        return worded(BURIN_TEXT("Command", "the machine's travel"));
    case BoundLayer::Kind::stock:
        return worded(BURIN_TEXT("Command", "the stock"));
    case BoundLayer::Kind::fixture:
    case BoundLayer::Kind::keepOut:
        break;
    }
    return worded(BURIN_TEXT("Command", "%1 \"%2\""), {wordFor(kindName(layer.kind)), layer.name});
}

} // namespace burin
