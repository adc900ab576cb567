// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/findings.h"

#include <cmath>

namespace burin {

void Findings::add(FindingKind kind, std::uint32_t line, const glm::dvec3& place, double amount) {
    add(Finding{kind, line, place, amount});
}

void Findings::add(const Finding& finding) {
    const auto [entry, isNew] = worst_.try_emplace({finding.line, finding.kind}, finding);
    if (!isNew && isWorse(finding, entry->second)) entry->second = finding;
}

bool isWorse(const Finding& one, const Finding& other) noexcept {
    if (one.kind == FindingKind::allowanceDiffers)
        return std::abs(one.amount - one.limit) > std::abs(other.amount - other.limit);
    return one.amount > other.amount;
}

std::vector<Finding> Findings::inProgramOrder() const {
    std::vector<Finding> list;
    list.reserve(worst_.size());
    for (const auto& [key, finding] : worst_) list.push_back(finding);
    return list;
}

const char* idOf(FindingKind kind) {
    switch (kind) {
    case FindingKind::gouge:
        return "gouge";
    case FindingKind::rapidInStock:
        return "rapid_in_stock";
    case FindingKind::shankCollision:
        return "shank_collision";
    case FindingKind::holderCollision:
        return "holder_collision";
    case FindingKind::spindleOff:
        return "spindle_off";
    case FindingKind::spindleOn:
        return "spindle_on";
    case FindingKind::travelLimit:
        return "travel_limit";
    case FindingKind::feedLimit:
        return "feed_limit";
    case FindingKind::spindleLimit:
        return "spindle_limit";
    case FindingKind::rotaryLimit:
        return "rotary_limit";
    case FindingKind::unknownStart:
        return "unknown_start";
    case FindingKind::obstacleCollision:
        return "obstacle_collision";
    case FindingKind::spindlePower:
        return "spindle_power";
    case FindingKind::spindleTorque:
        return "spindle_torque";
    case FindingKind::toolBreakage:
        return "tool_breakage";
    case FindingKind::toolBending:
        return "tool_bending";
    case FindingKind::chipLoad:
        return "chip_load";
    case FindingKind::depthOfCut:
        return "depth_of_cut";
    case FindingKind::widthOfCut:
        return "width_of_cut";
    case FindingKind::centrePlunge:
        return "plunge_without_centre";
    case FindingKind::toolUnknown:
        return "tool_unknown";
    case FindingKind::toolNotLoaded:
        return "tool_not_loaded";
    case FindingKind::lengthOffsetMissing:
        return "length_offset_missing";
    case FindingKind::lengthOffsetOfOther:
        return "length_offset_of_another_tool";
    case FindingKind::workOffsetOther:
        return "other_work_offset";
    case FindingKind::spindleReversed:
        return "spindle_reversed";
    case FindingKind::cornerGouge:
        return "corner_gouge";
    case FindingKind::cornerExcess:
        return "corner_excess";
    case FindingKind::allowanceDiffers:
        return "allowance_differs";
    case FindingKind::partNotProtected:
        return "part_not_protected";
    }
    return "unknown";
}

const char* unitOf(FindingKind kind) {
    switch (kind) {
    case FindingKind::gouge:
    case FindingKind::travelLimit:
    case FindingKind::obstacleCollision:
    case FindingKind::toolBending:
    case FindingKind::chipLoad:
    case FindingKind::depthOfCut:
    case FindingKind::widthOfCut:
    case FindingKind::centrePlunge:
    case FindingKind::cornerGouge:
    case FindingKind::cornerExcess:
    case FindingKind::allowanceDiffers:
        return "mm";
    case FindingKind::spindlePower:
        return "W";
    case FindingKind::spindleTorque:
        return "N m";
    case FindingKind::toolBreakage:
        return "N/mm^2";
    case FindingKind::rapidInStock:
    case FindingKind::shankCollision:
    case FindingKind::holderCollision:
    case FindingKind::spindleOff:
    case FindingKind::spindleOn:
        return "mm^3";
    case FindingKind::feedLimit:
        return "mm/min";
    case FindingKind::spindleLimit:
    case FindingKind::spindleReversed:
        return "1/min";
    case FindingKind::rotaryLimit:
        return "deg";
    case FindingKind::unknownStart:
    case FindingKind::toolUnknown:
    case FindingKind::toolNotLoaded:
    case FindingKind::lengthOffsetMissing:
    case FindingKind::lengthOffsetOfOther:
    case FindingKind::workOffsetOther:
    case FindingKind::partNotProtected:
        break;
    }
    return "";
}

TextId remedyOf(FindingKind kind) {
    switch (kind) {
    case FindingKind::gouge:
        return BURIN_TEXT("Finding", "retract or delete this part of the path, or mill it with a smaller tool");
    case FindingKind::rapidInStock:
        return BURIN_TEXT("Finding", "retract above the material before this move");
    case FindingKind::shankCollision:
        return BURIN_TEXT("Finding", "mill the material around it first, or use a tool with longer flutes");
    case FindingKind::holderCollision:
        return BURIN_TEXT("Finding", "mill the material around it first, or use a tool with a longer stick-out");
    case FindingKind::spindleOff:
        return BURIN_TEXT("Finding", "start the spindle before this move");
    case FindingKind::spindleOn:
        return BURIN_TEXT("Finding", "stop the spindle before this move, and hold it: the tool doesn't turn");
    case FindingKind::travelLimit:
        return BURIN_TEXT("Finding", "place the part elsewhere on the table, or use a machine with more travel");
    case FindingKind::feedLimit:
        return BURIN_TEXT("Finding", "lower the feed to the machine's maximum");
    case FindingKind::spindleLimit:
        return BURIN_TEXT("Finding", "use a spindle speed within the machine's range");
    case FindingKind::rotaryLimit:
        return BURIN_TEXT("Finding", "tilt the tool less, or use a machine whose rotary axes turn farther");
    case FindingKind::unknownStart:
        return BURIN_TEXT("Finding", "state X, Y and Z before this move");
    case FindingKind::obstacleCollision:
        return BURIN_TEXT("Finding", "move the fixture, or retract the path above it");
    case FindingKind::spindlePower:
    case FindingKind::spindleTorque:
        return BURIN_TEXT("Finding", "mill it in more levels or with a smaller step-over, or use a stronger machine");
    case FindingKind::toolBreakage:
    case FindingKind::toolBending:
        return BURIN_TEXT("Finding", "mill it in more levels or with a smaller step-over, or use a thicker or shorter "
                                     "tool");
    case FindingKind::chipLoad:
        return BURIN_TEXT("Finding", "lower the feed");
    case FindingKind::depthOfCut:
        return BURIN_TEXT("Finding", "mill it in more levels");
    case FindingKind::widthOfCut:
        return BURIN_TEXT("Finding", "use a smaller step-over");
    case FindingKind::centrePlunge:
        return BURIN_TEXT("Finding", "begin beside the material, or use a centre-cutting tool");
    case FindingKind::toolUnknown:
        return BURIN_TEXT("Finding", "add the tool to the project with this number, or correct the number");
    case FindingKind::toolNotLoaded:
        return BURIN_TEXT("Finding", "load the tool with M6 before this move");
    case FindingKind::lengthOffsetMissing:
        return BURIN_TEXT("Finding", "add G43 with the tool's H number after the tool change");
    case FindingKind::lengthOffsetOfOther:
        return BURIN_TEXT("Finding", "use the H number of the tool in the spindle");
    case FindingKind::workOffsetOther:
        return BURIN_TEXT("Finding", "use the work offset in which the project's zero is stored");
    case FindingKind::spindleReversed:
        return BURIN_TEXT("Finding", "use M3: the tool is right-handed");
    case FindingKind::cornerGouge:
    case FindingKind::cornerExcess:
        return BURIN_TEXT("Finding", "use G64 with a small P, or G61");
    case FindingKind::allowanceDiffers:
        return BURIN_TEXT("Finding", "correct the shift or the coordinates, or post the path again");
    case FindingKind::partNotProtected:
        return BURIN_TEXT("Finding", "choose smaller voxels");
    }
    return {};
}

} // namespace burin
