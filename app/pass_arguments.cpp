// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/pass_arguments.h"

#include "app/number_list.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/cad/face_area.h"
#include "core/exchange/plan_drawing.h"
#include "core/job/computed_pass.h"
#include "ui/messages/details.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace burin {

namespace {

const std::map<std::string, double>& drawingUnits() {
    static const std::map<std::string, double> units{{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"inch", 25.4}};
    return units;
}

std::vector<std::string> passIds() {
    std::vector<std::string> ids;
    for (const PassKindRow& row : passKinds) ids.emplace_back(row.id);
    return ids;
}

/// The displacement of drawings. Errors: argumentInvalid.
Result<glm::dvec2> moveOf(const PassArguments& arguments) {
    if (arguments.move.empty()) return glm::dvec2(0.0);
    const std::optional<glm::dvec3> by = vectorOf(arguments.move + ",0");
    if (!by)
        return Error{ErrorCode::argumentInvalid, "--move", arguments.move, worded(BURIN_TEXT("Command", "X,Y in mm"))};
    return glm::dvec2(*by);
}

Result<PlanDrawing> drawingOf(const std::string& file, const PassArguments& arguments, CommandContext& context) {
    const Result<glm::dvec2> by = moveOf(arguments);
    if (!by) return by.error();
    Result<PlanDrawing> drawing = readDrawing(file, arguments.unit.empty() ? 0.0 : drawingUnits().at(arguments.unit));
    if (!drawing) return drawing;
    for (DrawnCurve& curve : drawing->curves)
        for (glm::dvec2& place : curve.places) place += *by;
    if (!drawing->unitStated)
        context.message(worded(BURIN_TEXT("Command", "\"%1\" does not state its unit: one unit is taken as %2 mm. "
                                                     "Set it with --unit."),
                               {file, formatShortest(drawing->unit)}));
    for (const std::string& note : drawing->notes) context.message(file + ": " + detailText(note).toStdString());
    return drawing;
}

/// Areas and lines of a file: a drawing, or a request as printed by `path list --json`. Errors: those of readDrawing
/// and passRequestFromJson.
Result<PassRequest> shapesIn(const std::string& file, bool asArea, const PassArguments& arguments,
                             CommandContext& context) {
    if (file.ends_with(".json")) {
        const Result<std::string> text = readFile(file);
        return text ? passRequestFromJson(*text, file) : Result<PassRequest>(text.error());
    }
    const Result<PlanDrawing> drawing = drawingOf(file, arguments, context);
    if (!drawing) return drawing.error();
    PassRequest shapes;
    shapes.lines = linesOf(*drawing);
    if (!asArea) return shapes;
    Result<PlanRegion> region = regionOf(*drawing, file);
    if (!region) return std::move(region).error();
    shapes.area = std::move(*region);
    return shapes;
}

Result<void> addArea(const PassArguments& arguments, CommandContext& context, PassRequest& request) {
    if (arguments.area.empty()) return {};
    Result<PassRequest> shapes = shapesIn(arguments.area, true, arguments, context);
    if (!shapes) return std::move(shapes).error();
    request.area = std::move(shapes->area);
    request.areaOnPart = request.areaOnPart || shapes->areaOnPart;
    return {};
}

/// Adds the faces of the part and painted strokes: where the tool is to touch the part.
Result<void> addPainted(const PassArguments& arguments, const Project& project, const Model& part,
                        CommandContext& context, PassRequest& request) {
    for (const std::string& text : arguments.faces) {
        const std::optional<glm::dvec3> place = vectorOf(text);
        if (!place)
            return Error{ErrorCode::argumentInvalid, "--face", text, worded(BURIN_TEXT("Command", "X,Y,Z in mm"))};
        const Result<PlanRegion> face = faceArea(part, *place);
        if (!face) return face.error();
        request.area = joined(request.area, *face);
    }
    if (!arguments.paint.empty() && !(arguments.brush >= 0.1 && arguments.brush <= 1000.0))
        return Error{ErrorCode::argumentInvalid, "--brush", formatShortest(arguments.brush),
                     worded(BURIN_TEXT("Command", "0.1 to 1000 mm"))};
    KeptLeads kept;
    for (const std::int64_t take : arguments.paint) {
        const Result<LeadLines> lines = linesOfTake(project, take, kept, context.progress());
        if (!lines) return lines.error();
        for (const PassLine& line : **lines)
            request.area =
                joined(request.area, brushed(std::vector<glm::dvec2>(line.begin(), line.end()), 0.5 * arguments.brush));
    }
    request.areaOnPart = request.areaOnPart || !arguments.faces.empty() || !arguments.paint.empty();
    return {};
}

Result<void> addLines(const PassArguments& arguments, const Project& project, CommandContext& context,
                      PassRequest& request) {
    std::vector<TakeLines> takes;
    KeptLeads kept;
    for (const std::int64_t take : arguments.leads) {
        Result<LeadLines> lines = linesOfTake(project, take, kept, context.progress());
        if (!lines) return std::move(lines).error();
        takes.push_back({take, std::move(*lines)});
    }
    leadBy(takes, request);
    if (arguments.lines.empty()) return {};
    Result<PassRequest> shapes = shapesIn(arguments.lines, false, arguments, context);
    if (!shapes) return std::move(shapes).error();
    std::ranges::move(shapes->lines, std::back_inserter(request.lines));
    return {};
}

} // namespace

Argument addPass(CommandParser command, PassArguments& arguments) {
    PassRequest& request = arguments.request;
    const Argument pass =
        command
            .option("--pass", arguments.kind,
                    BURIN_TEXT("Help", "Compute a pass: levels (roughing), pocket, profile, face, parallel, radial, "
                                       "spiral, flow (rows that follow --lead or --lines), waterline, scallop, pencil "
                                       "(concave edges), rest (what is left), engrave, drill, thread"))
            .choices(passIds());
    const auto withPass = [&](const Argument& argument) { return argument.needs(pass); };
    withPass(command.option("--tool", arguments.tool,
                            BURIN_TEXT("Help", "Tool of the pass (default: the tool of the path)")));
    withPass(command.option("--allowance", request.allowance, BURIN_TEXT("Help", "Stock to leave on the part, mm")));
    withPass(command.option("--step-over", request.stepOver,
                            BURIN_TEXT("Help", "Distance between rows or loops, or between the heights of a waterline, "
                                               "mm (default: 0.4 of the diameter for roughing, 1/15 for finishing)")));
    withPass(command.option("--scallop", request.scallop,
                            BURIN_TEXT("Help", "Instead of --step-over: height of the ridges between rows, mm")));
    withPass(command.option(
        "--level-depth", request.levelDepth,
        BURIN_TEXT(
            "Help",
            "Largest depth of a level, or of a peck when drilling, mm (default: what material, tool and spindle can "
            "take; holes deeper than 3 diameters: one diameter)")));
    withPass(command.option(
        "--stairs", request.stairs,
        BURIN_TEXT("Help",
                   "levels: largest height of the steps left on slopes, mm (default: a tenth of the diameter)")));
    withPass(command.option("--direction", arguments.directionDegrees,
                            BURIN_TEXT("Help", "Direction of parallel rows, degrees from X")));
    withPass(command.option("--flattest", arguments.flattestDegrees,
                            BURIN_TEXT("Help", "Only where the part is at least this steep, degrees")));
    withPass(command.option("--steepest", arguments.steepestDegrees,
                            BURIN_TEXT("Help", "Only where the part is at most this steep, degrees")));
    withPass(command.option("--top", request.top,
                            BURIN_TEXT("Help", "Height at which the pass begins, mm (default: the top of the stock)")));
    withPass(command.option(
        "--bottom", request.bottom,
        BURIN_TEXT("Help", "Lowest height of the tip, mm (default: the lowest point of the part; for face its top)")));
    withPass(command.option(
        "--depth", request.depth,
        BURIN_TEXT("Help", "engrave, drill: depth below the top of the stock, mm; thread: below the top of its "
                           "hole or stud (default of drill and thread: to the bottom of the part's hole, or as far as "
                           "the tool has room around the stud)")));
    addHoleOptions(command, pass, arguments.holes, request);
    withPass(command.option("--tabs", request.tabs,
                            BURIN_TEXT("Help", "profile: number of holding tabs left on each outline")));
    withPass(command.option("--tab-width", request.tabWidth, BURIN_TEXT("Help", "Width of a holding tab, mm")));
    withPass(command.option("--tab-height", request.tabHeight,
                            BURIN_TEXT("Help", "Height of a holding tab above the lowest level, mm")));
    withPass(command.flag("--dogbones", request.dogbones,
                          BURIN_TEXT("Help", "pocket, profile: cut into the inner corners of the area, so that a "
                                             "part with square corners fits")));
    withPass(command.flag("--one-way", request.oneWay, BURIN_TEXT("Help", "Cut all rows in one direction")));
    withPass(command.flag("--inside", request.inside,
                          BURIN_TEXT("Help", "profile: inside the outline of --area instead of around it")));
    withPass(command.flag("--rest", request.restOnly, BURIN_TEXT("Help", "Only rows where stock is left")));
    withPass(command.option(
        "--area", arguments.area,
        BURIN_TEXT("Help", "Area of the pass, in the coordinates of the setup: closed curves of a DXF or SVG drawing, "
                           "or a JSON file with a request as \"path list --json\" prints it")));
    withPass(command
                 .option("--face", arguments.faces,
                         BURIN_TEXT("Help",
                                    "Area: the face of the part at X,Y,Z, mm, within 1 mm; can be given several times"))
                 .oneAtATime());
    withPass(command
                 .option("--paint", arguments.paint,
                         BURIN_TEXT("Help", "Area: painted by the strokes of these takes, as wide as --brush"))
                 .separatedBy(','));
    withPass(command.option("--brush", arguments.brush, BURIN_TEXT("Help", "Diameter of the brush of --paint, mm")));
    withPass(command.flag("--on-part", request.areaOnPart,
                          BURIN_TEXT("Help", "The area limits where rows touch the part, not where the tip goes "
                                             "(always with --face and --paint)")));
    withPass(command.option(
        "--lines", arguments.lines,
        BURIN_TEXT("Help", "Curves to engrave, that the rows of flow follow, or beside which pencil looks for "
                           "edges: DXF, SVG or JSON")));
    withPass(
        command
            .option("--lead", arguments.leads,
                    BURIN_TEXT("Help", "Takes whose strokes the rows of flow follow, or beside which pencil looks for "
                                       "edges"))
            .separatedBy(','));
    withPass(
        command
            .option("--hand", arguments.hand,
                    BURIN_TEXT("Help", "What rows do where takes earlier in the path have finished the part: ignore "
                                       "(default), keep-off, blend (go on over its border by --overlap, without a "
                                       "step), extend (flow: its rows continue those strokes sideways)"))
            .choices(std::vector<std::string>(handStrokesIds.begin(), handStrokesIds.end())));
    withPass(command.option("--overlap", request.overlap,
                            BURIN_TEXT("Help", "--hand blend: how far rows go on over the border, mm (default: 0.5)")));
    withPass(command.option(
        "--finished-within", request.finishedWithin,
        BURIN_TEXT("Help", "--hand: largest height that takes may have left on what counts as finished, mm (default: "
                           "0.02)")));
    withPass(command.option("--move", arguments.move, BURIN_TEXT("Help", "Move the drawing by X,Y, mm")));
    withPass(command
                 .option("--unit", arguments.unit,
                         BURIN_TEXT("Help", "Unit of the drawing (default: the unit that it states)"))
                 .choices(keysOf(drawingUnits())));
    withPass(command.flag("--preview", arguments.preview,
                          BURIN_TEXT("Help", "Only estimate the length and time of the pass; change nothing")));
    return pass;
}

Result<PassRequest> requestOf(const PassArguments& arguments, const Project& project, const Model& part,
                              CommandContext& context) {
    PassRequest request = arguments.request;
    const Result<PassKind> kind = passKindWithId(arguments.kind);
    if (!kind) return kind.error();
    request.kind = *kind;
    const auto hand = std::ranges::find(handStrokesIds, arguments.hand); // the parser knows no others
    request.hand = static_cast<HandStrokes>(hand - handStrokesIds.begin());
    request.direction = glm::radians(arguments.directionDegrees);
    if (arguments.flattestDegrees) request.flattest = glm::radians(*arguments.flattestDegrees);
    if (arguments.steepestDegrees) request.steepest = glm::radians(*arguments.steepestDegrees);
    if (Result<void> added = addArea(arguments, context, request); !added) return std::move(added).error();
    if (Result<void> added = addPainted(arguments, project, part, context, request); !added)
        return std::move(added).error();
    if (Result<void> added = addHoles(arguments.holes, part, request); !added) return std::move(added).error();
    if (Result<void> added = addLines(arguments, project, context, request); !added) return std::move(added).error();
    if (Result<void> valid = validate(request); !valid) return std::move(valid).error();
    return request;
}

} // namespace burin
