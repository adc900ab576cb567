// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/fixture_arguments.h"
#include "app/report.h"
#include "app/setups.h"
#include "app/surroundings.h"
#include "app/touch_arguments.h"
#include "app/wording.h"
#include "app/zero_arguments.h"
#include "core/base/numbers.h"
#include "core/base/steps.h"
#include "core/document/project_change.h"
#include "core/machine/machine_library.h"
#include "core/nc/dialect_library.h"
#include "core/setup/fixture_fit.h"

#include <algorithm>
#include <filesystem>

namespace burin {

namespace {

struct SetupArguments {
    std::string project;
    SurroundingsArguments around;
    FixtureArguments fixtures;
    SetupsArguments setups;
    ZeroArguments zero;
    TouchArguments touch;
    std::vector<std::string> remove, switchOn, switchOff;
    double fileUnit = 1.0;
    std::string machine, dialect, units;

    bool changes() const {
        return setups.changes() || !zero.empty() || !touch.empty() || !fixtures.empty() ||
               !(machine.empty() && dialect.empty() && units.empty() && around.fixtures.empty() &&
                 around.keepOuts.empty() && around.axis.empty() && around.travel.empty() && remove.empty() &&
                 switchOn.empty() && switchOff.empty());
    }
};

/// Errors: nameUnknown.
Result<std::vector<Obstacle>::iterator> named(std::vector<Obstacle>& obstacles, const std::string& name) {
    const auto found = std::ranges::find(obstacles, name, &Obstacle::name);
    if (found != obstacles.end()) return found;
    std::string known;
    for (const Obstacle& obstacle : obstacles) known += (known.empty() ? "" : ", ") + obstacle.name;
    return Error{ErrorCode::nameUnknown, "obstacle", name, known};
}

Result<void> changeObstacles(std::vector<Obstacle>& obstacles, const SetupArguments& arguments, Progress& progress) {
    for (const std::string& name : arguments.remove) {
        const auto found = named(obstacles, name);
        if (!found) return found.error();
        obstacles.erase(*found);
    }
    for (const bool on : {true, false})
        for (const std::string& name : on ? arguments.switchOn : arguments.switchOff) {
            const auto found = named(obstacles, name);
            if (!found) return found.error();
            (*found)->on = on;
        }
    Result<std::vector<Obstacle>> added = obstaclesOf(arguments.around, arguments.fileUnit, progress);
    if (!added) return std::move(added).error();
    obstacles = joined(std::move(obstacles), std::move(*added));
    return {};
}

/// The model as far as the form of the stock depends on it, in the setup frame.
Result<std::shared_ptr<const Model>> stockModel(const Project& project, const Setup& setup) {
    if (setup.form != StockForm::solids) return std::make_shared<const Model>();
    return project.placedModel();
}

Result<void> changeLibraryFixtures(const Project& project, std::vector<Obstacle>& obstacles,
                                   const SetupArguments& arguments, Progress& progress) {
    if (arguments.fixtures.empty()) return {};
    const Result<Setup> setup = project.setup();
    if (!setup) return setup.error();
    const Result<std::shared_ptr<const Model>> part = stockModel(project, *setup);
    if (!part) return part.error();
    const Result<StockSolid> stock = StockSolid::of(**part, *setup, progress);
    if (!stock) return stock.error();
    return changeFixtures(obstacles, arguments.fixtures, *stock, arguments.around.clearance);
}

/// Another machine implies the dialect of its control.
Result<void> changeTarget(ProgramTarget& target, const SetupArguments& arguments) {
    if (!arguments.machine.empty()) {
        if (const Result<MachineProfile> machine = loadMachine(arguments.machine); !machine) return machine.error();
        target.machine = arguments.machine;
        target.dialect.clear();
    }
    if (!arguments.dialect.empty()) {
        if (const auto dialect = loadDialect(arguments.dialect); !dialect) return dialect.error();
        target.dialect = arguments.dialect;
    }
    if (const auto units = ncUnitsFromId(arguments.units)) target.units = *units;
    return {};
}

/// Recordings do not depend on program zero: it may change at any time.
Result<std::vector<TouchedAxis>> changeZero(Project& project, const ZeroArguments& arguments,
                                            const TouchArguments& touch, Progress& progress) {
    if (arguments.empty() && touch.empty()) return std::vector<TouchedAxis>{};
    Result<Setup> setup = project.setup();
    if (!setup) return std::move(setup).error();
    const Result<std::shared_ptr<const Model>> part = project.placedModel();
    if (!part) return part.error();
    const Result<ProgramZero> zero = changedZero(setup->zero, arguments, **part, progress);
    if (!zero) return zero.error();
    setup->zero = *zero;
    Result<Setup> complete = placeZero(**part, std::move(*setup));
    if (!complete) return std::move(complete).error();
    Result<TouchedOff> touched = touchedOff(std::move(*complete), touch, project, **part, progress);
    if (!touched) return std::move(touched).error();
    if (Result<void> stored = project.setSetup(touched->setup); !stored) return std::move(stored).error();
    return std::move(touched->sides);
}

/// Checks that the tool's tip can reach the zero, as it could not be touched off otherwise. Errors: argumentInvalid.
Result<void> checkTravel(const Around& around) {
    if (!around.travel.on || !around.travel.zero) return {};
    const Result<MachineProfile> machine = loadMachine(around.target.machine);
    if (!machine) return machine.error();
    for (int axis = 0; axis < 3; ++axis) {
        const double place = (*around.travel.zero)[axis];
        if (place >= 0.0 && place <= machine->travel[axis]) continue;
        return Error{ErrorCode::argumentInvalid, "--travel", std::string(1, "XYZ"[axis]) + formatShortest(place),
                     worded(BURIN_TEXT("Command", "0 to %1 mm, the travel of the machine \"%2\""),
                            {formatShortest(machine->travel[axis]), around.target.machine})};
    }
    return {};
}

/// Applies the arguments; errors in them are detected before anything is stored. Returns what was touched off.
Result<std::vector<TouchedAxis>> change(ProjectChange& project, Around& around, const SetupArguments& arguments,
                                        Progress& progress) {
    if (Result<void> done = changeObstacles(around.obstacles, arguments, progress); !done)
        return std::move(done).error();
    if (Result<void> done = changeLibraryFixtures(*project, around.obstacles, arguments, progress); !done)
        return std::move(done).error();
    if (!arguments.around.axis.empty()) {
        const Result<AxisMode> axis = axisModeOf(arguments.around.axis);
        if (!axis) return axis.error();
        around.axis = *axis;
    }
    if (!arguments.around.travel.empty()) {
        const Result<TravelPlacement> travel = travelPlacementOf(arguments.around.travel);
        if (!travel) return travel.error();
        around.travel = *travel;
    }
    if (Result<void> done = changeTarget(around.target, arguments); !done) return std::move(done).error();
    if (!arguments.around.travel.empty() || !arguments.machine.empty())
        if (Result<void> reached = checkTravel(around); !reached) return std::move(reached).error();
    Result<std::vector<TouchedAxis>> touched = changeZero(*project, arguments.zero, arguments.touch, progress);
    if (!touched) return touched;
    Result<void> stored = inOrder(
        [&] { return project->setObstacles(around.obstacles); }, [&] { return project->setAxisMode(around.axis); },
        [&] { return project->setTravelPlacement(around.travel); },
        [&] { return project->setProgramTarget(around.target); }, [&] { return project.save(); });
    return stored ? std::move(touched) : Result<std::vector<TouchedAxis>>(std::move(stored).error());
}

/// Data of a project on its setups, and on the one in use.
struct Answer {
    Around around;
    std::optional<Setup> setup; ///< empty if nothing is embedded yet
    nlohmann::json setups;
    std::string setupsText;
    std::vector<BadFit> badFits;
    std::vector<TouchedAxis> touched{};
};

Result<std::vector<BadFit>> badFitsOf(const Project& project, const std::optional<Setup>& setup,
                                      const std::vector<Obstacle>& obstacles, Progress& progress) {
    if (!setup || obstacles.empty()) return std::vector<BadFit>{};
    const Result<std::shared_ptr<const Model>> part = stockModel(project, *setup);
    if (!part) return part.error();
    return badFits(**part, *setup, obstacles, progress);
}

Result<Answer> answerOf(const Project& project, Around around, Progress& progress) {
    Result<nlohmann::json> setups = jsonOfSetups(project);
    if (!setups) return std::move(setups).error();
    Result<std::string> text = textOfSetups(project);
    if (!text) return std::move(text).error();
    Result<Setup> setup = project.setup();
    if (!setup && setup.error().code != ErrorCode::projectIncomplete) return std::move(setup).error();
    std::optional<Setup> embedded = setup ? std::optional(std::move(*setup)) : std::nullopt;
    Result<std::vector<BadFit>> bad = badFitsOf(project, embedded, around.obstacles, progress);
    if (!bad) return std::move(bad).error();
    return Answer{std::move(around), std::move(embedded), std::move(*setups), std::move(*text), std::move(*bad)};
}

Result<Answer> changed(const SetupArguments& arguments, CommandContext& context) {
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return std::move(project).error();
    const Result<TakenStock> left = changeSetups(**project, arguments.setups, context);
    if (!left) return left.error();
    Result<Around> around = aroundOf(**project);
    if (!around) return std::move(around).error();
    context.stage(BURIN_TEXT("Command", "Reading fixtures"));
    Result<std::vector<TouchedAxis>> touched = change(*project, *around, arguments, context.progress());
    if (!touched) return std::move(touched).error();
    tellStock(*left, context);
    tellKeptEarlier(context, **project);
    Result<Answer> answer = answerOf(**project, std::move(*around), context.progress());
    if (answer) answer->touched = std::move(*touched);
    return answer;
}

Result<Answer> shown(const SetupArguments& arguments, CommandContext& context) {
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return project.error();
    Result<Around> around = aroundOf(*project);
    if (!around) return std::move(around).error();
    return answerOf(*project, std::move(*around), context.progress());
}

int runSetup(const SetupArguments& arguments, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<Answer> told = arguments.changes() ? changed(arguments, context) : shown(arguments, context);
    if (!told) return context.fail(told.error());
    const Around* around = &told->around;
    const ProgramTarget& target = around->target;
    std::string text = worded(BURIN_TEXT("Command", "axis     %1"), {textOf(around->axis)}) + "\n";
    text += target.dialect.empty()
                ? worded(BURIN_TEXT("Command", "machine  %1"), {target.machine})
                : worded(BURIN_TEXT("Command", "machine  %1, dialect %2"), {target.machine, target.dialect});
    text += "\n" + worded(BURIN_TEXT("Command", "units    %1"), {idOf(target.units)});
    if (told->setup) text += "\n" + worded(BURIN_TEXT("Command", "zero     %1"), {textOf(told->setup->zero)});
    text += textOf(told->touched);
    for (const Obstacle& obstacle : around->obstacles) text += "\n" + textOf(obstacle);
    text += textOf(told->badFits);
    text += told->setupsText;
    context.answer({{"project", std::filesystem::absolute(arguments.project).lexically_normal().string()},
                    {"setups", told->setups},
                    {"axis", jsonOf(around->axis)},
                    {"machine_travel", jsonOf(around->travel)},
                    {"machine", target.machine},
                    {"dialect", target.dialect.empty() ? nlohmann::json() : nlohmann::json(target.dialect)},
                    {"units", idOf(target.units)},
                    {"zero", told->setup ? jsonOf(told->setup->zero) : nlohmann::json()},
                    {"work_offset_mm", told->setup ? jsonOf(told->setup->workOffset) : nlohmann::json()},
                    {"touched", jsonOf(told->touched)},
                    {"fixture_warnings", jsonOf(told->badFits)},
                    {"obstacles", jsonOf(around->obstacles)}},
                   text);
    return 0;
}

} // namespace

void registerSetup(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<SetupArguments>();
    const CommandParser command =
        program.command("setup", BURIN_TEXT("Help", "Show and change the setups of a project: placement of the part, "
                                                    "fixtures, keep-out volumes, tool axis, machine and travel"));
    command
        .positional(BURIN_TEXT("Argument", "PROJECT"), arguments->project, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    addSetups(command, arguments->setups);
    addZero(command, arguments->zero);
    addTouches(command, arguments->touch);
    addSurroundings(command, arguments->around);
    addFixtures(command, arguments->fixtures);
    const auto addNames = [&](const char* option, std::vector<std::string>& names, TextId help) {
        command.option(option, names, help).oneAtATime();
    };
    addNames("--remove", arguments->remove,
             BURIN_TEXT("Help", "Name of a fixture or keep-out volume to delete; may be repeated"));
    addNames(
        "--switch-off", arguments->switchOff,
        BURIN_TEXT("Help",
                   "Name of a fixture or keep-out volume to switch off; it stays in the project; may be repeated"));
    addNames("--switch-on", arguments->switchOn,
             BURIN_TEXT("Help", "Name of a fixture or keep-out volume to switch on again; may be repeated"));
    command
        .option("--file-unit,--stl-unit", arguments->fileUnit,
                BURIN_TEXT("Help", "Millimetres per unit of a file that states none (STL, OBJ, PLY, OFF)"))
        .range(1e-6, 1e6)
        .showDefault();
    command.option("--machine", arguments->machine, BURIN_TEXT("Help", "Machine of its programs"));
    command.option("--dialect", arguments->dialect,
                   BURIN_TEXT("Help", "Dialect of its programs (default: the machine's)"));
    command.option("--units", arguments->units, BURIN_TEXT("Help", "Units of its programs: mm or inch"))
        .choices({"mm", "inch"});
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runSetup(*arguments, context); });
}

} // namespace burin
