// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/number_list.h"
#include "app/project_workpiece.h"
#include "app/volume_files.h"
#include "app/wording.h"
#include "core/job/part_distance.h"
#include "core/job/workpiece_measure.h"
#include "ui/panels/measure_labels.h"

#include <nlohmann/json.hpp>

namespace burin {

namespace {

struct MeasureArguments {
    std::string project, at, to, direction, moment, file;
    bool workpiece = false;
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

nlohmann::json jsonOf(const std::optional<MeasuredLength>& length) {
    if (!length) return {};
    return {{"value_mm", length->value}, {"uncertainty_mm", length->within}};
}

nlohmann::json jsonOf(const MeasuredWorkpiece& at) {
    nlohmann::json answer = jsonOf(at.face);
    answer.erase("corner_mm"); // what is fitted has no corners and no border
    answer.erase("area_mm2");
    answer["uncertainty_mm"] = at.within;
    answer["radius_uncertainty_mm"] = at.face.radius > 0.0 ? nlohmann::json(at.radiusWithin) : nlohmann::json();
    answer["angle_uncertainty_rad"] = at.angleWithin;
    answer["thickness_uncertainty_mm"] = at.face.thickness ? nlohmann::json(at.thicknessWithin) : nlohmann::json();
    answer["thickness_along_direction"] = jsonOf(at.along);
    answer["width"] = jsonOf(at.opening);
    answer["depth"] = jsonOf(MeasuredLength{at.depth, at.depthWithin});
    answer["from_part_mm"] = jsonOf(at.fromPart);
    answer["material"] = at.material;
    return answer;
}

nlohmann::json jsonOf(const WorkpieceMeasure& measure) {
    nlohmann::json answer{{"from", jsonOf(measure.from)}};
    if (!measure.to || !measure.pair) return answer;
    answer["to"] = jsonOf(*measure.to);
    answer["between"] = {{"points_mm", measure.pair->places},
                         {"angle_rad", jsonOf(measure.pair->angle)},
                         {"apart_mm", jsonOf(measure.pair->apart)},
                         {"uncertainty_mm", measure.pairWithin},
                         {"angle_uncertainty_rad", measure.angleWithin}};
    return answer;
}

Error unreadable(const char* option, const std::string& text) {
    return {ErrorCode::argumentInvalid, option, text, worded(BURIN_TEXT("Command", "X,Y,Z in mm, on the part"))};
}

/// The points to measure, and the direction of the thickness.
struct MeasurePoints {
    WorkpiecePoint from;
    std::optional<WorkpiecePoint> to;
};

/// Errors: argumentInvalid.
Result<MeasurePoints> pointsOf(const MeasureArguments& arguments) {
    MeasurePoints points;
    const std::optional<glm::dvec3> at = vectorOf(arguments.at);
    if (!at) return unreadable("--at", arguments.at);
    points.from.place = *at;
    if (!arguments.to.empty()) {
        const std::optional<glm::dvec3> to = vectorOf(arguments.to);
        if (!to) return unreadable("--to", arguments.to);
        points.to = WorkpiecePoint{*to, std::nullopt};
    }
    if (arguments.direction.empty()) return points;
    if (!arguments.workpiece && arguments.file.empty())
        return Error{ErrorCode::argumentInvalid, "--direction", arguments.direction,
                     worded(BURIN_TEXT("Command", "used with --workpiece or --workpiece-file"))};
    points.from.direction = vectorOf(arguments.direction);
    if (!points.from.direction || *points.from.direction == glm::dvec3(0.0))
        return Error{ErrorCode::argumentInvalid, "--direction", arguments.direction, "a direction"};
    return points;
}

int measurePartOf(const Project& project, const MeasurePoints& points, CommandContext& context) {
    Result<Model> model = project.model();
    if (!model) return context.fail(model.error());
    const Result<Setup> setup = project.setup();
    if (!setup) return context.fail(setup.error());
    const auto part = placed(std::make_shared<const Model>(std::move(*model)), setup->placement);
    const Result<PartMeasure> measure = measurePart(
        *part, points.from.place, points.to ? std::optional(points.to->place) : std::nullopt, {}, context.progress());
    if (!measure) return context.fail(measure.error());
    context.answer(jsonOf(*measure), measureText(*measure, setup->workOffset, LengthUnit::millimetre).toStdString());
    return 0;
}

int measureWorkpieceOf(const Project& project, const MeasureArguments& arguments, const MeasurePoints& points,
                       CommandContext& context) {
    const Result<Setup> setup = project.setup();
    if (!setup) return context.fail(setup.error());
    Result<RunVolume> workpiece = arguments.file.empty() ? workpieceOf(project, {false, arguments.moment}, context)
                                                         : readVolume(arguments.file, {}, context);
    if (!workpiece) return context.fail(workpiece.error());
    const Result<MeshDistance> part = partDistance(project);
    if (!part) return context.fail(part.error());
    const Result<WorkpieceMeasure> measure = measureWorkpiece(workpiece->snapshot(), {&*part, setup->stock.high.z},
                                                              points.from, points.to, context.progress());
    if (!measure) return context.fail(measure.error());
    context.answer(jsonOf(*measure), measureText(*measure, setup->workOffset, LengthUnit::millimetre).toStdString());
    return 0;
}

int runMeasure(const MeasureArguments& arguments, CommandContext& context) {
    const Result<MeasurePoints> points = pointsOf(arguments);
    if (!points) return context.fail(points.error());
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return context.fail(project.error());
    return arguments.workpiece || !arguments.file.empty() ? measureWorkpieceOf(*project, arguments, *points, context)
                                                          : measurePartOf(*project, *points, context);
}

} // namespace

void registerMeasure(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<MeasureArguments>();
    const CommandParser command = program.command(
        "measure",
        BURIN_TEXT(
            "Help",
            "Measure the part or the workpiece: a face, its wall thickness, or how two faces lie to each other"));
    command
        .positional(BURIN_TEXT("Argument", "PROJECT"), arguments->project, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    command
        .option(
            "--at", arguments->at,
            BURIN_TEXT("Help", "X,Y,Z on the part, mm, in the coordinates of the setup; the nearest face is measured"))
        .required();
    command.option("--to", arguments->to, BURIN_TEXT("Help", "The same of a second face: distances and angle"));
    const Argument workpiece = command.flag(
        "--workpiece", arguments->workpiece,
        BURIN_TEXT("Help", "Measure the workpiece as the takes left it: also its depth below the top of the stock, the "
                           "width to the opposite side and the stock left on the part, each with its uncertainty"));
    const Argument file =
        command.option("--workpiece-file", arguments->file,
                       BURIN_TEXT("Help", "Measure the workpiece of a volume file (.srle), as verify writes it"));
    command
        .option("--moment", arguments->moment,
                BURIN_TEXT("Help", "The workpiece at a moment: TAKE:SECONDS, or TAKE for its end"))
        .needs(workpiece);
    command.option("--direction", arguments->direction,
                   BURIN_TEXT("Help", "X,Y,Z into the workpiece: its thickness along this direction, too"));
    file.excludes(workpiece);
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runMeasure(*arguments, context); });
}

} // namespace burin
