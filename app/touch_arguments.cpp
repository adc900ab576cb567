// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/touch_arguments.h"

#include "app/number_list.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/job/milling_context.h"

#include <cmath>
#include <optional>

namespace burin {

namespace {

/// A tip and the direction in which the tool is moved.
struct Touch {
    glm::dvec3 tip{0.0}, towards{0.0};
};

/// "X,Y,Z=-x"; empty for any other text.
std::optional<Touch> touchOf(const std::string& text) {
    const std::vector<std::string> parts = partsOf(text, '=');
    if (parts.size() != 2) return std::nullopt;
    const std::optional<glm::dvec3> tip = vectorOf(parts[0]);
    const bool negative = parts[1].starts_with('-');
    const std::string name = parts[1].substr(negative ? 1 : 0);
    for (int axis = 0; axis < 3; ++axis)
        if (tip && name == std::string(1, "xyz"[axis])) {
            Touch touch{*tip, glm::dvec3(0.0)};
            touch.towards[axis] = negative ? -1.0 : 1.0;
            return touch;
        }
    return std::nullopt;
}

} // namespace

void addTouches(CommandParser command, TouchArguments& arguments) {
    command
        .option("--touch", arguments.touches,
                BURIN_TEXT("Help",
                           "Touch off program zero as with an edge finder: X,Y,Z=AXIS moves the tip of the tool from a "
                           "point in mm along x, -x, y, -y or -z until the stock stops it; the side that it touches "
                           "becomes zero along this axis; may be repeated"))
        .oneAtATime();
    command.option("--touch-tool", arguments.tool, BURIN_TEXT("Help", "Tool for --touch")).showDefault();
}

Result<TouchedOff> touchedOff(Setup setup, const TouchArguments& arguments, const Project& project, const Model& part,
                              Progress& progress) {
    TouchedOff answer{std::move(setup), {}};
    if (arguments.empty()) return answer;
    const Result<TouchableStock> stock = TouchableStock::of(part, answer.setup, progress);
    if (!stock) return stock.error();
    const Result<Tool> tool = toolFor(project, arguments.tool);
    if (!tool) return tool.error();
    for (const std::string& text : arguments.touches) {
        const std::optional<Touch> touch = touchOf(text);
        if (!touch)
            return wrongArgument("--touch", text,
                                 BURIN_TEXT("Command", "X,Y,Z=AXIS: a point in mm, and x, -x, y, -y or -z"));
        const Result<TouchedFace> face = touchStock(*stock, *tool, touch->tip, touch->towards);
        if (!face) {
            Error error = face.error();
            error.subject = "--touch";
            return error;
        }
        const std::optional<TouchedSide> side = stock->sideTouched(*face, *tool);
        if (!side)
            return wrongArgument("--touch", text,
                                 BURIN_TEXT("Command",
                                            "a point from which the tool meets a side of the stock squarely, "
                                            "a ball with its middle below the upper edge"));
        answer.setup.zero.on = ZeroReference::point;
        answer.setup.zero.point = answer.setup.workOffset;
        answer.setup.zero.point[face->axis] = side->coordinate;
        Result<Setup> placed = placeZero(part, std::move(answer.setup));
        if (!placed) return std::move(placed).error();
        answer.setup = std::move(*placed);
        answer.sides.push_back({face->axis, *side});
    }
    return answer;
}

nlohmann::json jsonOf(const std::vector<TouchedAxis>& sides) {
    nlohmann::json list = nlohmann::json::array();
    for (const TouchedAxis& touched : sides)
        list.push_back({{"axis", std::string(1, "xyz"[touched.axis])},
                        {"coordinate_mm", touched.side.coordinate},
                        {"error_mm", touched.side.error}});
    return list;
}

std::string textOf(const std::vector<TouchedAxis>& sides) {
    std::string text;
    for (const TouchedAxis& touched : sides) {
        const std::string axis(1, "XYZ"[touched.axis]), place = formatFixed(touched.side.coordinate, 3);
        text += "\n";
        text += touched.side.error > 0.0 ? worded(BURIN_TEXT("Command", "touched  %1 %2 mm, within %3 mm"),
                                                  {axis, place, formatShortest(touched.side.error)})
                                         : worded(BURIN_TEXT("Command", "touched  %1 %2 mm"), {axis, place});
    }
    return text;
}

} // namespace burin
