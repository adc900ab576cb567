// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/zero_arguments.h"

#include "app/number_list.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/cad/part_face.h"
#include "core/nc/work_offset.h"

#include <vector>

namespace burin {

namespace {

/// "stock:low,low,high"; empty for any other text.
std::optional<ProgramZero> onBox(ProgramZero zero, const std::string& text) {
    const std::vector<std::string> halves = partsOf(text, ':');
    if (halves.size() != 2) return std::nullopt;
    const auto on = zeroReferenceFromId(halves[0]);
    const std::vector<std::string> sides = partsOf(halves[1], ',');
    if (!on || *on == ZeroReference::point || sides.size() != zero.sides.size()) return std::nullopt;
    for (std::size_t axis = 0; axis < sides.size(); ++axis) {
        const auto side = boxSideFromId(sides[axis]);
        if (!side) return std::nullopt;
        zero.sides[axis] = *side;
    }
    zero.on = *on;
    return zero;
}

/// "near:X,Y,Z": the result of a click at that point. Empty for any other text.
Result<std::optional<ProgramZero>> nearCorner(ProgramZero zero, const std::string& text, const Model& part,
                                              Progress& progress) {
    constexpr std::string_view near = "near:";
    const std::optional<glm::dvec3> place =
        text.starts_with(near) ? vectorOf(text.substr(near.size())) : std::optional<glm::dvec3>();
    if (!place) return std::optional<ProgramZero>();
    const Result<PartFace> face = partFaceAt(part, *place, {}, progress);
    if (!face) return face.error();
    zero.on = ZeroReference::point;
    zero.point = face->corner;
    return std::optional(zero);
}

Result<ProgramZero> placedZero(ProgramZero zero, const std::string& text, const Model& part, Progress& progress) {
    if (const std::optional<ProgramZero> placed = onBox(zero, text)) return *placed;
    const Result<std::optional<ProgramZero>> corner = nearCorner(zero, text, part, progress);
    if (!corner) return corner.error();
    if (*corner) return **corner;
    const std::optional<glm::dvec3> point = vectorOf(text);
    if (!point)
        return Error{ErrorCode::argumentInvalid, "--zero", text,
                     worded(BURIN_TEXT("Command", "stock:X,Y,Z or part:X,Y,Z with low, middle or high for each axis, "
                                                  "near:X,Y,Z or X,Y,Z in mm"))};
    zero.on = ZeroReference::point;
    zero.point = *point;
    return zero;
}

std::string textOf(BoxSide side) {
    switch (side) {
    case BoxSide::low:
        return worded(BURIN_TEXT("Command", "low"));
    case BoxSide::middle:
        return worded(BURIN_TEXT("Command", "middle"));
    case BoxSide::high:
        return worded(BURIN_TEXT("Command", "high"));
    }
    return {};
}

} // namespace

void addZero(CommandParser command, ZeroArguments& arguments) {
    command.option("--zero", arguments.zero,
                   BURIN_TEXT("Help",
                              "Program zero: stock:X,Y,Z or part:X,Y,Z, each low, middle or high of its bounding box "
                              "(stock:low,low,high is a corner of its top face); near:X,Y,Z, the part's vertex, middle "
                              "of an edge or centre of a circle that is nearest; or coordinates X,Y,Z; all in the "
                              "setup's frame, mm"));
    command.option("--work-offset", arguments.workOffset,
                   BURIN_TEXT("Help", "Work offset that stores program zero: G54 to G59, G59.1 to G59.3, or P1 to P300 "
                                      "(G54.1 P or G154 P)"));
}

Result<ProgramZero> changedZero(ProgramZero zero, const ZeroArguments& arguments, const Model& part,
                                Progress& progress) {
    if (!arguments.zero.empty()) {
        const Result<ProgramZero> placed = placedZero(zero, arguments.zero, part, progress);
        if (!placed) return placed;
        zero = *placed;
    }
    if (!arguments.workOffset.empty()) {
        const std::optional<int> number = workOffsetFromName(arguments.workOffset);
        if (!number)
            return Error{ErrorCode::argumentInvalid, "--work-offset", arguments.workOffset,
                         worded(BURIN_TEXT("Command", "G54 to G59, G59.1 to G59.3, or P1 to P300"))};
        zero.workOffset = *number;
    }
    return zero;
}

nlohmann::json jsonOf(const ProgramZero& zero) {
    nlohmann::json answer{{"work_offset", workOffsetName(zero.workOffset)}, {"on", idOf(zero.on)}};
    if (zero.on == ZeroReference::point) {
        answer["point_mm"] = {zero.point.x, zero.point.y, zero.point.z};
    } else {
        answer["sides"] = nlohmann::json::array();
        for (const BoxSide side : zero.sides) answer["sides"].push_back(idOf(side));
    }
    return answer;
}

std::string textOf(const ProgramZero& zero) {
    const std::string name = workOffsetName(zero.workOffset);
    if (zero.on == ZeroReference::point)
        return worded(BURIN_TEXT("Command", "%1, at X %2, Y %3, Z %4 mm"),
                      {name, formatFixed(zero.point.x, 3), formatFixed(zero.point.y, 3), formatFixed(zero.point.z, 3)});
    const TextId pattern = zero.on == ZeroReference::stock ? BURIN_TEXT("Command", "%1, on the stock: X %2, Y %3, Z %4")
                                                           : BURIN_TEXT("Command", "%1, on the part: X %2, Y %3, Z %4");
    return worded(pattern, {name, textOf(zero.sides[0]), textOf(zero.sides[1]), textOf(zero.sides[2])});
}

} // namespace burin
