// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/touch_arguments.h"

#include "app/number_list.h"
#include "app/wording.h"
#include "core/job/milling_context.h"
#include "core/job/touched_stock.h"

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

Result<Setup> touchedOff(Setup setup, const TouchArguments& arguments, const Project& project, const Model& part) {
    if (arguments.empty()) return setup;
    const Result<Tool> tool = toolFor(project, arguments.tool);
    if (!tool) return tool.error();
    for (const std::string& text : arguments.touches) {
        const std::optional<Touch> touch = touchOf(text);
        if (!touch)
            return wrongArgument("--touch", text,
                                 BURIN_TEXT("Command", "X,Y,Z=AXIS: a point in mm, and x, -x, y, -y or -z"));
        const Result<TouchedFace> face = touchStock(setup, *tool, touch->tip, touch->towards);
        if (!face) {
            Error error = face.error();
            error.subject = "--touch";
            return error;
        }
        const std::optional<double> side =
            face->outcome == TouchedFace::Outcome::found ? sideTouched(setup, *face) : std::nullopt;
        if (!side)
            return wrongArgument("--touch", text,
                                 BURIN_TEXT("Command",
                                            "a point from which the tool meets a side of the stock squarely, "
                                            "a ball with its middle below the upper edge"));
        setup.zero.on = ZeroReference::point;
        setup.zero.point = setup.workOffset;
        setup.zero.point[face->axis] = *side;
        Result<Setup> placed = placeZero(part, std::move(setup));
        if (!placed) return placed;
        setup = std::move(*placed);
    }
    return setup;
}

} // namespace burin
