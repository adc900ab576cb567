// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/project_workpiece.h"
#include "app/volume_files.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/base/steps.h"
#include "core/document/companions.h"
#include "core/exchange/volume_output.h"
#include "core/volume/operations/boolean.h"
#include "core/volume/operations/boundary.h"
#include "core/volume/operations/dense.h"
#include "core/volume/operations/fingerprint.h"
#include "core/volume/operations/moments.h"
#include "core/volume/operations/relation.h"
#include "core/volume/operations/turn.h"

#include <array>

namespace burin {

namespace {

using nlohmann::json;

struct VolumeArguments {
    std::string first, second, output, table, at, axis = "z";
    bool stock = false;
};

/// Makes a volume from the files in the arguments.
using Make = Result<RunVolume> (*)(const VolumeArguments& arguments, CommandContext& context);

std::string sizeText(const Grid& grid) {
    const glm::ivec3 count = grid.count();
    return std::to_string(count.x) + " x " + std::to_string(count.y) + " x " + std::to_string(count.z);
}

json jsonOf(const Grid& grid) {
    const glm::ivec3 count = grid.count();
    return {{"voxels", {count.x, count.y, count.z}},
            {"voxel_mm", grid.edge()},
            {"low_corner_mm", {grid.low().x, grid.low().y, grid.low().z}},
            {"runs_along", std::string(1, "xyz"[grid.axisOfRuns()])}};
}

json jsonOf(const glm::dvec3& vector) {
    return json::array({vector.x, vector.y, vector.z});
}

/// Mass and its moments; null if the material states no density.
json momentsJson(const Property& property, const BodyMoments& body) {
    json answer{{"id", property.id}, {"volume_mm3", body.volume}, {"centroid_mm", jsonOf(body.centroid)}};
    const glm::dmat3 inertia = body.inertia();
    answer["inertia_mm5"] = json::array({jsonOf(inertia[0]), jsonOf(inertia[1]), jsonOf(inertia[2])});
    const double weight = property.valueOr(density, 0.0);
    constexpr double cubicMillimetres = 1e3; // per cm³
    answer["mass_g"] = weight > 0.0 ? json(weight * body.volume / cubicMillimetres) : json();
    return answer;
}

int answerMoments(const VolumeSnapshot& volume, CommandContext& context) {
    const VolumeMoments all = moments(volume);
    json materials = json::array();
    std::string text = worded(BURIN_TEXT("Command", "%1 voxels of %2 mm"),
                              {sizeText(volume.grid()), formatShortest(volume.grid().edge())});
    for (int i = 1; i < volume.properties().size(); ++i) {
        const auto index = static_cast<PropertyIndex>(i);
        const BodyMoments& body = all.byProperty[index];
        if (!(body.volume > 0.0)) continue;
        const Property& property = volume.properties()[index];
        materials.push_back(momentsJson(property, body));
        const json& mass = materials.back()["mass_g"];
        text +=
            "\n" + worded(BURIN_TEXT("Command", "  %1: %2 mm^3, %3 g, centre (%4, %5, %6) mm"),
                          {resourceName(property.name), formatFixed(body.volume, 3),
                           mass.is_null() ? "-" : formatFixed(mass.get<double>(), 3), formatFixed(body.centroid.x, 3),
                           formatFixed(body.centroid.y, 3), formatFixed(body.centroid.z, 3)});
    }
    json answer = jsonOf(volume.grid());
    answer["hash"] = fingerprintText(fingerprint(volume));
    text += "\n" + worded(BURIN_TEXT("Command", "hash %1"), {fingerprintText(fingerprint(volume))});
    answer["materials"] = std::move(materials);
    Property whole;
    whole.id = "all";
    answer["all"] = momentsJson(whole, all.material);
    context.answer(answer, text);
    return 0;
}

int runMoments(const VolumeArguments& arguments, CommandContext& context) {
    Result<RunVolume> volume = readVolume(arguments.first, arguments.table, context);
    if (!volume) return context.fail(volume.error());
    return answerMoments(volume->snapshot(), context);
}

Result<RunVolume> readFirst(const VolumeArguments& arguments, CommandContext& context) {
    return readVolume(arguments.first, arguments.table, context);
}

/// A set operation on two volumes in one grid.
template <Result<RunVolume> (*operation)(const VolumeSnapshot&, const VolumeSnapshot&)>
Result<RunVolume> combine(const VolumeArguments& arguments, CommandContext& context) {
    Result<RunVolume> a = readVolume(arguments.first, arguments.table, context);
    if (!a) return a.error();
    Result<RunVolume> b = readVolume(arguments.second, arguments.table, context);
    if (!b) return b.error();
    return operation(a->snapshot(), b->snapshot());
}

Result<RunVolume> turn(const VolumeArguments& arguments, CommandContext& context) {
    Result<RunVolume> volume = readFirst(arguments, context);
    if (!volume) return volume.error();
    const auto axis = static_cast<RunAxis>(arguments.axis.front() - 'x'); // the parser accepts no other
    Result<TurnedVolume> made = turned(volume->snapshot(), axis, context.progress());
    if (!made) return std::move(made).error();
    return std::move(made->volume);
}

/// Keeps only the boundary voxels.
Result<RunVolume> boundary(const VolumeArguments& arguments, CommandContext& context) {
    Result<RunVolume> volume = readFirst(arguments, context);
    if (!volume) return volume.error();
    const VolumeSnapshot snapshot = volume->snapshot();
    const Grid& grid = snapshot.grid();
    const std::vector<PropertyIndex> all = toDense(snapshot);
    std::vector<PropertyIndex> kept(all.size(), airProperty);
    const glm::ivec3 count = grid.count();
    for (const VoxelIndex voxel : boundaryVoxels(snapshot)) {
        const auto place = (static_cast<std::size_t>(voxel.k) * static_cast<std::size_t>(count.y) +
                            static_cast<std::size_t>(voxel.j)) *
                               static_cast<std::size_t>(count.x) +
                           static_cast<std::size_t>(voxel.i);
        kept[place] = all[place];
    }
    return fromDense(grid, snapshot.properties(), kept);
}

/// The workpiece as the takes left it, or the stock before them.
Result<RunVolume> ofProject(const VolumeArguments& arguments, CommandContext& context) {
    const Result<Project> project = projectForReading(arguments.first, context);
    if (!project) return project.error();
    return workpieceOf(*project, {arguments.stock, arguments.at}, context);
}

int runMake(const VolumeArguments& arguments, Make make, CommandContext& context) {
    std::vector<std::filesystem::path> inputs{arguments.first};
    if (!arguments.second.empty()) inputs.emplace_back(arguments.second);
    if (Result<void> free = checkOutput("--output", arguments.output, inputs); !free) return context.fail(free.error());
    Result<RunVolume> volume = make(arguments, context);
    if (!volume) return context.fail(volume.error());
    context.stage(BURIN_TEXT("Command", "Saving"));
    const Result<WrittenVolume> written = writeAnyVolume(arguments.output, volume->snapshot(), context.progress());
    if (!written) return context.fail(written.error());
    json answer = jsonOf(volume->grid());
    answer["file"] = written->file;
    answer["hash"] = fingerprintText(fingerprint(volume->snapshot()));
    answer["table"] = written->table.empty() ? json() : json(written->table);
    answer["triangles"] = written->triangles;
    answer["rounded_run_ends"] = written->roundedEnds;
    std::string text = worded(BURIN_TEXT("Command", "%1: %2 voxels of %3 mm"),
                              {written->file, sizeText(volume->grid()), formatShortest(volume->grid().edge())});
    if (written->triangles > 0)
        text = worded(BURIN_TEXT("Command", "%1: %2 triangles"), {written->file, std::to_string(written->triangles)});
    text += "\n" + worded(BURIN_TEXT("Command", "hash %1"), {answer["hash"].get<std::string>()});
    if (!written->table.empty()) text += "\n" + worded(BURIN_TEXT("Command", "its table: %1"), {written->table});
    if (written->roundedEnds > 0)
        text += "\n" + worded(BURIN_TEXT("Command", "%1 run ends within voxels were rounded to whole voxels; a volume "
                                                    "file keeps them"),
                              {std::to_string(written->roundedEnds)});
    context.answer(answer, text);
    return 0;
}

int runRelation(const VolumeArguments& arguments, CommandContext& context) {
    Result<RunVolume> a = readVolume(arguments.first, arguments.table, context);
    if (!a) return context.fail(a.error());
    Result<RunVolume> b = readVolume(arguments.second, arguments.table, context);
    if (!b) return context.fail(b.error());
    const Result<SpatialRelation> found = relation(a->snapshot(), b->snapshot());
    if (!found) return context.fail(found.error());
    constexpr std::array names{"intersecting", "adjacent", "separate"}; // in the order of SpatialRelation
    constexpr std::array words{BURIN_TEXT("Command", "intersecting: they share space"),
                               BURIN_TEXT("Command", "adjacent: they touch and share no space"),
                               BURIN_TEXT("Command", "separate: there is a gap between them")};
    const auto place = static_cast<std::size_t>(*found);
    context.answer({{"relation", names[place]}}, worded(words[place]));
    return 0;
}

/// Declares the subcommands.
class VolumeCommands {
public:
    VolumeCommands(CommandParser command, CommandContext& context, int& status)
        : command_(command), context_(context), status_(status), arguments_(std::make_shared<VolumeArguments>()) {}

    void addMaking(const char* name, TextId help, Make make, bool two, TextId input) {
        const CommandParser one = begin(name, help, two, input);
        one.option("-o,--output", arguments_->output,
                   BURIN_TEXT("Help", "File to write: .srle (volume file), .nrrd with a table beside it, .stl, .ply or "
                                      ".3mf (surface)"))
            .required();
        one.run([arguments = arguments_, make, &context = context_, &status = status_] {
            status = runMake(*arguments, make, context);
        });
        if (std::string_view(name) == "turn")
            one.option("--axis", arguments_->axis, BURIN_TEXT("Help", "Axis that the runs lie along: x, y or z"))
                .choices({"x", "y", "z"})
                .showDefault();
        if (std::string_view(name) == "export") {
            one.flag("--stock", arguments_->stock, BURIN_TEXT("Help", "The stock before anything was milled"));
            one.option("--at", arguments_->at,
                       BURIN_TEXT("Help", "The workpiece at a moment: TAKE:SECONDS, or TAKE for its end"));
        }
    }

    void addAsking(const char* name, TextId help, int (*run)(const VolumeArguments&, CommandContext&), bool two) {
        const CommandParser one = begin(name, help, two, BURIN_TEXT("Help", "Volume file, or voxel array"));
        one.run([arguments = arguments_, run, &context = context_, &status = status_] {
            status = run(*arguments, context);
        });
    }

private:
    CommandParser begin(const char* name, TextId help, bool two, TextId input) {
        const CommandParser one = command_.command(name, help);
        one.passOn();
        one.positional(BURIN_TEXT("Argument", "FILE"), arguments_->first, input).required();
        if (two) one.positional(BURIN_TEXT("Argument", "OTHER"), arguments_->second, input).required();
        one.option("--table", arguments_->table,
                   BURIN_TEXT("Help", "Table of the materials that the values of a voxel array mean (JSON)"));
        return one;
    }

    CommandParser command_;
    CommandContext& context_;
    int& status_;
    std::shared_ptr<VolumeArguments> arguments_;
};

} // namespace

void registerVolume(CommandParser program, CommandContext& context, int& status) {
    const CommandParser command = program.command(
        "volume", BURIN_TEXT("Help", "Convert, combine and measure volumes of voxels; export the workpiece"));
    command.requireCommand();
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    VolumeCommands commands(command, context, status);
    const TextId volume = BURIN_TEXT("Help", "Volume file, or voxel array (NRRD, or raw with a header in JSON)");
    commands.addMaking("convert", BURIN_TEXT("Help", "Write a volume in another form"), &readFirst, false, volume);
    commands.addMaking("union", BURIN_TEXT("Help", "What belongs to one volume or the other"), &combine<unionOf>, true,
                       volume);
    commands.addMaking("intersection", BURIN_TEXT("Help", "What belongs to both volumes"), &combine<intersectionOf>,
                       true, volume);
    commands.addMaking("difference", BURIN_TEXT("Help", "What belongs to the first volume alone"),
                       &combine<differenceOf>, true, volume);
    commands.addMaking("boundary", BURIN_TEXT("Help", "The voxels that have an empty neighbour"), &boundary, false,
                       volume);
    commands.addMaking("turn", BURIN_TEXT("Help", "The same volume with its runs along another axis"), &turn, false,
                       volume);
    commands.addMaking("export", BURIN_TEXT("Help", "The workpiece of a project, as its takes left it"), &ofProject,
                       false, BURIN_TEXT("Help", "Project file (.burin)"));
    commands.addAsking("moments", BURIN_TEXT("Help", "Volume, mass, centre and inertia of each material"), &runMoments,
                       false);
    commands.addAsking("relation", BURIN_TEXT("Help", "Whether two volumes share space, touch or are apart"),
                       &runRelation, true);
}

} // namespace burin
