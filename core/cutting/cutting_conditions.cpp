// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/cutting/cutting_force.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// Returns the value for this type of cutter if the material has one, else the general one.
Result<double> positiveValue(const Property& material, std::string_view name, CutterType cutter) {
    const double value = material.valueOr(valueForCutter(name, cutter), material.valueOr(name, 0.0));
    if (std::isfinite(value) && value > 0.0) return value;
    return Error{ErrorCode::resourceInvalid, material.id, std::string(name), "the material needs a value above 0"};
}

Result<void> checkLimit(const char* name, double value) {
    if (std::isfinite(value) && value > 0.0) return {};
    return Error{ErrorCode::argumentInvalid, name, formatShortest(value), "above 0"};
}

/// Makers of end mills allow 3 to 10 degrees, less for harder materials. The values in between are our estimates; half
/// of them for a tool that is not centre-cutting.
double rampAngleFor(const Tool& tool, const Property& material) {
    constexpr double degree = pi / 180.0, soft = 0.3, middling = 1.2; // J/mm³
    const double energy = material.valueOr(specificCuttingEnergy, 0.0);
    const double angle = !(energy > 0.0) || energy > middling ? 3.0 : energy > soft ? 5.0 : 10.0;
    return (tool.centreCutting ? angle : 0.5 * angle) * degree;
}

/// @param highest spindle speed, 1/min
Result<CuttingConditions> conditionsOf(const CuttingPreset& preset, const Tool& tool, const Property& material,
                                       double highest, double maximumFeed) {
    CuttingConditions conditions;
    conditions.spindleSpeed = std::min(preset.spindleSpeed, highest);
    const double turns = conditions.spindleSpeed / preset.spindleSpeed;
    const double wantedFeed = turns * feedOf(preset, tool.fluteCount);
    conditions.feed = std::min(wantedFeed, maximumFeed);
    double plunge = turns * preset.plungeFeed;
    if (!(plunge > 0.0)) {
        const Result<double> ratio = positiveValue(material, plungeFeedRatio, tool.cutter.type);
        if (!ratio) return ratio.error();
        plunge = conditions.feed * *ratio;
    }
    conditions.plungeFeed = std::min(plunge, maximumFeed);
    conditions.limitedByMachine = preset.spindleSpeed > highest || wantedFeed > maximumFeed;
    return conditions;
}

Result<CuttingConditions> tableConditions(const Tool& tool, const Property& material, double highest,
                                          double maximumFeed) {
    const Result<double> speed = positiveValue(material, surfaceSpeed, tool.cutter.type);
    if (!speed) return speed.error();
    const Result<double> chipLoad = positiveValue(material, chipLoadPerDiameter, tool.cutter.type);
    if (!chipLoad) return chipLoad.error();
    const Result<double> plungeRatio = positiveValue(material, plungeFeedRatio, tool.cutter.type);
    if (!plungeRatio) return plungeRatio.error();
    const double diameter = tool.cutter.diameter;
    const double wantedSpindle = *speed * millimetresPerMetre / (pi * diameter);
    CuttingConditions conditions;
    conditions.spindleSpeed = std::min(wantedSpindle, highest);
    // The chip load is determined by the tool: the feed follows the spindle speed that is really reached.
    const double wantedFeed = conditions.spindleSpeed * tool.fluteCount * *chipLoad * diameter;
    conditions.feed = std::min(wantedFeed, maximumFeed);
    conditions.plungeFeed = std::min(conditions.feed * *plungeRatio, maximumFeed);
    conditions.limitedByMachine = wantedSpindle > highest || wantedFeed > maximumFeed;
    return conditions;
}

} // namespace

const CuttingPreset* presetFor(const Tool& tool, const Property& material) noexcept {
    return presetFor(tool, material.id, material.base);
}

std::string valueForCutter(std::string_view name, CutterType cutter) {
    return std::string(name) + '_' + std::string(cutterTypeName(cutter));
}

Result<CuttingConditions> cuttingConditions(const Tool& tool, const Property& material, double maximumSpindleSpeed,
                                            double maximumFeed) {
    if (Result<void> valid = checkLimit("maximum spindle speed", maximumSpindleSpeed); !valid) return valid.error();
    if (Result<void> valid = checkLimit("maximum feed", maximumFeed); !valid) return valid.error();
    const double highest =
        tool.maximumSpindleSpeed > 0.0 ? std::min(maximumSpindleSpeed, tool.maximumSpindleSpeed) : maximumSpindleSpeed;
    const CuttingPreset* preset = presetFor(tool, material);
    Result<CuttingConditions> conditions = preset != nullptr
                                               ? conditionsOf(*preset, tool, material, highest, maximumFeed)
                                               : tableConditions(tool, material, highest, maximumFeed);
    if (!conditions) return conditions;
    conditions->surfaceSpeed = pi * tool.cutter.diameter * conditions->spindleSpeed / secondsPerMinute;
    conditions->rampAngle = rampAngleFor(tool, material);
    return conditions;
}

} // namespace burin
