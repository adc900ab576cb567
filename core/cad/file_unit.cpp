// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/file_unit.h"

#include "core/base/numbers.h"

#include <array>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr std::array<std::pair<double, const char*>, 10> unitNames{{{1.0, "mm"},
                                                                    {10.0, "cm"},
                                                                    {100.0, "dm"},
                                                                    {1000.0, "m"},
                                                                    {1e6, "km"},
                                                                    {1e-3, "µm"},
                                                                    {25.4, "inch"},
                                                                    {304.8, "foot"},
                                                                    {914.4, "yard"},
                                                                    {0.0254, "mil"}}};
constexpr std::array<std::pair<double, std::string_view>, 4> shortNames{
    {{25.4, "in"}, {304.8, "ft"}, {914.4, "yd"}, {1e-3, "um"}}};
constexpr double smallestUnit = 1e-6, largestUnit = 1e6; // mm

bool hasNoUnit(const Model& model) noexcept {
    return model.lengthUnit == "none";
}

/// How much larger the model is than its file states; mm per unit if that states none.
double growthOf(const Model& model) noexcept {
    if (hasNoUnit(model)) return model.unitScale;
    return unitReplaced(model) ? model.unitScale / model.statedUnit : 1.0;
}

} // namespace

bool isSameUnit(double one, double other) noexcept {
    return std::abs(one / other - 1.0) < 1e-9;
}

std::string unitName(double millimetres, const std::string& otherwise) {
    for (const auto& [scale, name] : unitNames)
        if (isSameUnit(millimetres, scale)) return name;
    return otherwise;
}

std::optional<double> unitFromText(std::string_view text) {
    for (const auto& [scale, name] : unitNames)
        if (text == name) return scale;
    for (const auto& [scale, name] : shortNames)
        if (text == name) return scale;
    const std::optional<double> number = parseNumber(text);
    const bool usable = number && *number >= smallestUnit && *number <= largestUnit;
    return usable ? number : std::nullopt;
}

bool statesUnit(const Model& model) noexcept {
    return !hasNoUnit(model) && model.format != "BREP";
}

bool unitReplaced(const Model& model) noexcept {
    return model.statedUnit > 0.0 && !isSameUnit(model.unitScale, model.statedUnit);
}

glm::dvec3 sizeInUnit(const Model& model, double scale) {
    const Box box = model.box();
    return box.empty() ? glm::dvec3(0.0) : box.size() * (scale / model.unitScale);
}

ImportOptions importOptionsAsBefore(const Model& before) {
    ImportOptions options;
    if (hasNoUnit(before)) options.fileUnit = before.unitScale;
    if (unitReplaced(before)) options.unitInstead = before.unitScale;
    return options;
}

Placement placementAsBefore(const Model& model, const Model& before) {
    Placement placement = before.brepPlacement;
    placement.shift *= growthOf(model) / growthOf(before);
    return placement;
}

} // namespace burin
