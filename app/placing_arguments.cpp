// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/placing_arguments.h"

#include "app/number_list.h"
#include "app/report.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/setup/face_alignment.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace burin {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// "x", "-z" or "X,Y,Z"
std::optional<glm::dvec3> directionOf(const std::string& text) {
    const bool negative = text.starts_with('-') && text.size() == 2;
    const std::string name = negative ? text.substr(1) : text;
    for (int axis = 0; axis < 3; ++axis)
        if (name == std::string(1, "xyz"[axis])) {
            glm::dvec3 direction(0.0);
            direction[axis] = negative ? -1.0 : 1.0;
            return direction;
        }
    const std::optional<glm::dvec3> direction = vectorOf(text);
    if (!direction || !(glm::length(*direction) > 0.0)) return std::nullopt;
    return direction;
}

Result<Placement> alignmentOf(const std::string& text, const Model& part, Progress& progress) {
    const TextId allowed = BURIN_TEXT(
        "Command",
        "X,Y,Z=AXIS: a point on a face in mm, and x, -x, y, -y, z, -z or a direction that the face is to point along");
    const std::vector<std::string> parts = partsOf(text, '=');
    if (parts.size() != 2) return wrongArgument("--align", text, allowed);
    const std::optional<glm::dvec3> place = vectorOf(parts[0]), direction = directionOf(parts[1]);
    if (!place || !direction) return wrongArgument("--align", text, allowed);
    const Result<PartFace> face = partFaceAt(part, *place, {}, progress);
    if (!face) return face.error();
    return alignedFace(*face, *direction, part.box().centre());
}

Result<Placement> turnOf(const std::string& text, const Model& part) {
    const std::vector<std::string> parts = partsOf(text, ':');
    std::optional<glm::dvec3> axis;
    std::optional<double> angle;
    if (parts.size() == 2) {
        axis = directionOf(parts[0]);
        angle = parseNumber(parts[1]);
    }
    if (!axis || !angle)
        return wrongArgument("--turn", text, BURIN_TEXT("Command", "AXIS:DEGREES: x, y, z or X,Y,Z, and an angle"));
    return turnedAbout(*axis, *angle * degree, part.box().centre());
}

std::string vectorText(const glm::dvec3& vector) {
    return formatShortest(vector.x) + ", " + formatShortest(vector.y) + ", " + formatShortest(vector.z);
}

glm::dvec3 rounded(const glm::dvec3& vector) {
    constexpr double steps = 1e6;
    return glm::round(vector * steps) / steps + glm::dvec3(0.0);
}

} // namespace

void addPlacing(CommandParser command, PlacingArguments& arguments) {
    command
        .option(
            "--align", arguments.align,
            BURIN_TEXT("Help",
                       "Rotate the part so that a face points along an axis: X,Y,Z=AXIS with a point on the face in mm "
                       "and x, -x, y, -y, z or -z (down). For a cylinder or cone its axis is used; may be repeated"))
        .oneAtATime();
    command
        .option("--turn", arguments.turn,
                BURIN_TEXT("Help", "Rotate the part about the centre of its bounding box: AXIS:DEGREES with x, y, z or "
                                   "X,Y,Z; after --align; may be repeated"))
        .oneAtATime();
    command.option("--move", arguments.move, BURIN_TEXT("Help", "Move the part by X,Y,Z mm, after --turn"));
}

Result<Placement> placingOf(const PlacingArguments& arguments, std::shared_ptr<const Model> part, Progress& progress) {
    Placement whole;
    const auto add = [&](const Result<Placement>& next) -> Result<void> {
        if (!next) return next.error();
        whole = combined(whole, *next);
        part = placed(part, *next);
        return {};
    };
    for (const std::string& text : arguments.align)
        if (Result<void> added = add(alignmentOf(text, *part, progress)); !added) return std::move(added).error();
    for (const std::string& text : arguments.turn)
        if (Result<void> added = add(turnOf(text, *part)); !added) return std::move(added).error();
    if (arguments.move.empty()) return whole;
    const std::optional<glm::dvec3> way = vectorOf(arguments.move);
    if (!way) return wrongArgument("--move", arguments.move, BURIN_TEXT("Command", "X,Y,Z in mm"));
    return combined(whole, movedBy(*way));
}

nlohmann::json jsonOf(const Placement& placement) {
    return {{"turn", {jsonOf(placement.turn[0]), jsonOf(placement.turn[1]), jsonOf(placement.turn[2])}},
            {"shift_mm", jsonOf(placement.shift)}};
}

std::string textOf(const Placement& placement) {
    const glm::dquat turn = glm::quat_cast(placement.turn);
    const double angle = glm::angle(turn) / degree;
    std::string text;
    if (placement.turn != glm::dmat3(1.0))
        text = worded(BURIN_TEXT("Command", "rotated by %1 degrees about %2"),
                      {formatFixed(angle, 3), vectorText(rounded(glm::axis(turn)))});
    if (placement.shift == glm::dvec3(0.0)) return text;
    return text + (text.empty() ? "" : ", ") +
           worded(BURIN_TEXT("Command", "moved by %1 mm"), {vectorText(rounded(placement.shift))});
}

} // namespace burin
