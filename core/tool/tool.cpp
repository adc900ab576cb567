// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool.h"

#include "core/base/estimate.h"
#include "core/base/numbers.h"
#include "core/tool/flute_form.h"
#include "core/tool/tool_solid.h"

#include <cmath>
#include <utility>

namespace burin {

namespace {

Error invalid(std::string key, double value, std::string allowed) {
    return {ErrorCode::argumentInvalid, std::move(key), formatShortest(value), std::move(allowed)};
}

bool isPositive(double value) {
    return std::isfinite(value) && value > 0.0;
}

Result<void> validateHolder(const std::vector<HolderSegment>& holder) {
    for (std::size_t i = 0; i < holder.size(); ++i) {
        const std::string key = "cutter.holder[" + std::to_string(i) + "].";
        if (!isPositive(holder[i].lowerDiameter))
            return invalid(key + "lower_diameter_mm", holder[i].lowerDiameter, "> 0");
        if (!isPositive(holder[i].upperDiameter))
            return invalid(key + "upper_diameter_mm", holder[i].upperDiameter, "> 0");
        if (!isPositive(holder[i].length)) return invalid(key + "length_mm", holder[i].length, "> 0");
    }
    return {};
}

Result<void> validateCutter(const Cutter& cutter) {
    if (!isPositive(cutter.diameter)) return invalid("cutter.diameter_mm", cutter.diameter, "> 0");
    if (!isPositive(cutter.shankDiameter)) return invalid("cutter.shank_diameter_mm", cutter.shankDiameter, "> 0");
    if (!isPositive(cutter.fluteLength) || cutter.fluteLength < cutter.cornerRadius)
        return invalid("cutter.flute_length_mm", cutter.fluteLength, "> 0 and at least the corner radius");
    if (Result<void> form = validateFlutes(cutter); !form) return form;
    if (!std::isfinite(cutter.stickOut) || cutter.stickOut < cutter.fluteLength)
        return invalid("cutter.stick_out_mm", cutter.stickOut, "at least the length of the flutes");
    if (Result<void> holder = validateHolder(cutter.holder); !holder) return holder;
    return cutter.solid == nullptr ? Result<void>() : validateSolid(cutter);
}

} // namespace

bool Cutter::turns() const noexcept {
    return solid == nullptr || solid->turns();
}

HollowSpace Cutter::hollow() const noexcept {
    return isHollow() ? HollowSpace{0.5 * solid->hollowWidth, solid->hollowDepth} : HollowSpace{};
}

double Cutter::length() const noexcept {
    double sum = stickOut;
    for (const HolderSegment& segment : holder) sum += segment.length;
    return sum;
}

bool Tool::isEstimate(const std::string& key) const {
    const auto own = sources.find(key);
    return burin::isEstimate(own != sources.end() ? own->second : source);
}

Result<void> validate(const Tool& tool) {
    if (tool.id.empty()) return Error{ErrorCode::argumentInvalid, "id", {}, "not empty"};
    if (tool.number < 1) return invalid("number", tool.number, "at least 1");
    if (tool.fluteCount < 1) return invalid("flute_count", tool.fluteCount, "at least 1");
    if (Result<void> cutter = validateCutter(tool.cutter); !cutter) return cutter;
    if (!isPositive(tool.maximumDepthOfCut) || tool.maximumDepthOfCut > tool.cutter.fluteLength)
        return invalid("maximum_depth_of_cut_mm", tool.maximumDepthOfCut, "> 0 and at most the length of the flutes");
    if (!std::isfinite(tool.maximumSpindleSpeed) || tool.maximumSpindleSpeed < 0.0)
        return invalid("maximum_spindle_speed_rpm", tool.maximumSpindleSpeed, "at least 0");
    for (const auto& [key, value] : {std::pair{"modulus_n_per_mm2", tool.modulus},
                                     {"strength_n_per_mm2", tool.strength},
                                     {"maximum_chip_load_mm", tool.maximumChipLoad},
                                     {"maximum_width_of_cut_mm", tool.maximumWidthOfCut}})
        if (!std::isfinite(value) || value < 0.0) return invalid(key, value, "at least 0");
    return validatePresets(tool);
}

Result<void> checkTurns(const Cutter& cutter, std::string_view request) {
    if (cutter.turns()) return {};
    return Error{ErrorCode::notSupported, std::string(request), "a tool that turns", {}};
}

Result<void> checkTilts(const Cutter& cutter) {
    if (cutter.isHollow())
        return Error{
            ErrorCode::notSupported, "a tilted axis of a tool with a hollow tip", "a tool without a hollow", {}};
    return checkTurns(cutter, "a tilted axis of a tool that doesn't turn");
}

std::vector<RevolvedPiece> pieces(const Cutter& cutter) {
    std::vector<RevolvedPiece> stack = flutePieces(cutter);
    const double shank = 0.5 * cutter.shankDiameter;
    if (cutter.stickOut > cutter.fluteLength) stack.push_back({cutter.fluteLength, cutter.stickOut, shank, shank, 0.0});
    double bottom = cutter.stickOut;
    for (const HolderSegment& segment : cutter.holder) {
        const double top = bottom + segment.length;
        stack.push_back({bottom, top, 0.5 * segment.lowerDiameter, 0.5 * segment.upperDiameter, 0.0});
        bottom = top;
    }
    return stack;
}

ToolSection sectionOf(const Cutter& cutter, std::size_t piece) {
    const std::size_t flutes = flutePieces(cutter).size();
    if (piece < flutes) return ToolSection::flutes;
    return piece == flutes && cutter.stickOut > cutter.fluteLength ? ToolSection::shank : ToolSection::holder;
}

} // namespace burin
