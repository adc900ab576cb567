// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/number_list.h"
#include "app/wording.h"
#include "core/cad/part_measure.h"
#include "ui/panels/measure_labels.h"

#include <nlohmann/json.hpp>

namespace burin {

namespace {

struct MeasureArguments {
    std::string project, at, to;
};

nlohmann::json jsonOf(const glm::dvec3& place) {
    return {place.x, place.y, place.z};
}

nlohmann::json jsonOf(const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json jsonOf(const MeasuredFace& face) {
    const bool round = face.radius > 0.0;
    return {{"face", idOf(face.kind)},
            {"position_mm", jsonOf(face.place)},
            {"corner_mm", jsonOf(face.corner)},
            {"normal", jsonOf(face.normal)},
            {"axis", jsonOf(face.axis)},
            {"axis_position_mm", round ? jsonOf(face.axisPlace) : nlohmann::json()},
            {"radius_mm", round ? nlohmann::json(face.radius) : nlohmann::json()},
            {"taper_rad", face.taper},
            {"area_mm2", face.area > 0.0 ? nlohmann::json(face.area) : nlohmann::json()},
            {"thickness_mm", jsonOf(face.thickness)}};
}

nlohmann::json jsonOf(const PartMeasure& measure) {
    nlohmann::json answer{{"from", jsonOf(measure.from)}};
    if (!measure.to || !measure.pair) return answer;
    answer["to"] = jsonOf(*measure.to);
    answer["between"] = {{"points_mm", measure.pair->places},
                         {"corners_mm", measure.pair->corners},
                         {"faces_mm", jsonOf(measure.pair->faces)},
                         {"nearest_from_mm", jsonOf(measure.pair->nearestFrom)},
                         {"nearest_to_mm", jsonOf(measure.pair->nearestTo)},
                         {"angle_rad", jsonOf(measure.pair->angle)},
                         {"apart_mm", jsonOf(measure.pair->apart)}};
    return answer;
}

Error unreadable(const char* option, const std::string& text) {
    return {ErrorCode::argumentInvalid, option, text, worded(BURIN_TEXT("Command", "X,Y,Z in mm, on the part"))};
}

int runMeasure(const MeasureArguments& arguments, CommandContext& context) {
    const std::optional<glm::dvec3> at = vectorOf(arguments.at);
    if (!at) return context.fail(unreadable("--at", arguments.at));
    std::optional<glm::dvec3> to;
    if (!arguments.to.empty() && !(to = vectorOf(arguments.to))) return context.fail(unreadable("--to", arguments.to));
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return context.fail(project.error());
    Result<Model> model = project->model();
    if (!model) return context.fail(model.error());
    const Result<Setup> setup = project->setup();
    if (!setup) return context.fail(setup.error());
    const auto part = placed(std::make_shared<const Model>(std::move(*model)), setup->placement);
    const Result<PartMeasure> measure = measurePart(*part, *at, to, {}, context.progress());
    if (!measure) return context.fail(measure.error());
    context.answer(jsonOf(*measure), measureText(*measure, setup->workOffset, LengthUnit::millimetre).toStdString());
    return 0;
}

} // namespace

void registerMeasure(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<MeasureArguments>();
    const CommandParser command = program.command(
        "measure",
        BURIN_TEXT("Help", "Measure the part: a face, its wall thickness, or how two faces lie to each other"));
    command
        .positional(BURIN_TEXT("Argument", "PROJECT"), arguments->project, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    command
        .option(
            "--at", arguments->at,
            BURIN_TEXT("Help", "X,Y,Z on the part, mm, in the coordinates of the setup; the nearest face is measured"))
        .required();
    command.option("--to", arguments->to, BURIN_TEXT("Help", "The same of a second face: distances and angle"));
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runMeasure(*arguments, context); });
}

} // namespace burin
