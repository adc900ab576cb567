// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/material_library.h"

#include "core/base/resource_folder.h"
#include "core/cutting/cutting_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace burin {

namespace {

/// A value that Burin reads, and its range.
struct KnownValue {
    std::string_view name, unit;
    double above = 0.0; ///< exclusive lower limit
    double below = 1e6; ///< exclusive upper limit
};
// Values from which others may be derived come first.
constexpr std::array knownValues{KnownValue{kienzleForce, "N/mm^2", 0.0, 100'000.0},
                                 KnownValue{kienzleExponent, "1", -1e-9, 1.0},
                                 KnownValue{specificCuttingEnergy, "J/mm^3", 0.0, 1000.0},
                                 KnownValue{radialForceRatio, "1", 0.0, 10.0},
                                 KnownValue{density, "g/cm^3", 0.0, 100.0},
                                 KnownValue{surfaceSpeed, "m/min", 0.0, 100'000.0},
                                 KnownValue{chipLoadPerDiameter, "1", 0.0, 1.0},
                                 KnownValue{plungeFeedRatio, "1", 0.0, 1.000001}};

Error wrong(const std::string& origin, std::string_view value, std::string why) {
    return {ErrorCode::resourceInvalid, origin, std::string(value), std::move(why)};
}

bool has(const Property& material, std::string_view name) {
    return material.values.find(name) != material.values.end();
}

/// Checks a value that the material may have.
Result<void> checkValue(const Property& material, const KnownValue& known, std::string_view name,
                        const std::string& origin) {
    const auto found = material.values.find(name);
    if (found == material.values.end()) return {};
    const NamedValue& value = found->second;
    if (value.unit != known.unit)
        return wrong(origin, name, "has to be in " + std::string(known.unit) + ", not in " + value.unit);
    if (!(value.value > known.above && value.value < known.below))
        return wrong(origin, name, "is out of what can be milled");
    return {};
}

} // namespace

Result<void> checkMaterial(const Property& material, const std::string& origin) {
    if (!isResourceId(material.id)) return wrong(origin, "id", "has to be letters, digits, '-', '_' and '.'");
    if (material.name.empty()) return wrong(origin, "name", "has to be there");
    for (const auto& [name, value] : material.values)
        if (!std::isfinite(value.value)) return wrong(origin, name, "has to be a finite number");
    for (const KnownValue& known : knownValues)
        if (Result<void> sound = checkValue(material, known, known.name, origin); !sound) return sound;
    for (const KnownValue& known : knownValues) {
        if (std::ranges::find(valuesByCutter, known.name) == valuesByCutter.end()) continue;
        for (int type = 0; type <= static_cast<int>(CutterType::profile); ++type)
            if (Result<void> sound =
                    checkValue(material, known, valueForCutter(known.name, static_cast<CutterType>(type)), origin);
                !sound)
                return sound;
    }
    if (has(material, kienzleForce) != has(material, kienzleExponent))
        return wrong(origin, has(material, kienzleForce) ? kienzleExponent : kienzleForce,
                     "has to be there, as the other half of Kienzle's law is");
    if (!has(material, specificCuttingEnergy) && !has(material, kienzleForce))
        return wrong(origin, specificCuttingEnergy, "has to be there, or Kienzle's law: without it nothing is felt");
    for (const std::string_view needed : valuesByCutter)
        if (!has(material, needed)) return wrong(origin, needed, "has to be there: feeds and speeds come from it");
    const Result<Property> again = propertyFromJson(toJson(material), origin); // otherwise its file could not be read
    return again ? Result<void>() : again.error();
}

Property copyOf(const Property& material, const std::string& id, const std::string& name) {
    Property copy = material;
    copy.id = id;
    copy.name = name;
    const std::string from = "copy of " + material.id + ": ";
    for (auto& [key, value] : copy.values)
        if (!value.source.starts_with(from)) value.source = from + value.source;
    return copy;
}

bool isShippedMaterial(std::string_view id) {
    return isShipped(materialResource, id) && !isOfUser(materialResource, id);
}

Result<std::filesystem::path> saveMaterial(const Property& material, bool replace) {
    if (Result<void> sound = checkMaterial(material, material.id); !sound) return std::move(sound).error();
    Result<std::filesystem::path> file = userMaterialFile(material.id, replace);
    if (!file) return file;
    return saveUserResource(materialResource, material.id, toJson(material));
}

Result<void> removeMaterial(const std::string& id) {
    if (isShippedMaterial(id))
        return Error{ErrorCode::argumentInvalid, "material", id,
                     "a material of your own; those that Burin is shipped with can't be deleted"};
    return removeUserResource(materialResource, id);
}

} // namespace burin
