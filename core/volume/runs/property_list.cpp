// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/property_list.h"

#include <algorithm>
#include <utility>

namespace burin {

double Property::valueOr(std::string_view valueName, double otherwise) const {
    const auto found = values.find(valueName);
    return found == values.end() ? otherwise : found->second.value;
}

PropertyList::PropertyList() {
    Property air;
    air.id = "air";
    air.name = "Air";
    air.colour = {255, 255, 255};
    entries_.push_back(std::move(air));
}

Result<PropertyIndex> PropertyList::add(Property property) {
    const auto refuse = [&](std::string rule) {
        return Error{ErrorCode::argumentInvalid, "property", property.id, std::move(rule)};
    };
    const auto placeOf = [&](const std::string& id) {
        return std::find_if(entries_.begin(), entries_.end(), [&](const Property& entry) { return entry.id == id; });
    };
    if (placeOf(property.id) != entries_.end())
        return Error{ErrorCode::argumentInvalid, "property id", property.id, "an id that is not in the list yet"};
    if (entries_.size() > 255) return refuse("at most 255 properties beside air");
    const bool machinable = property.machinability == Machinability::machinable, isGrade = !property.base.empty();
    const auto index = static_cast<PropertyIndex>(entries_.size());
    PropertyIndex base = index;
    if (isGrade) {
        const auto found = placeOf(property.base);
        if (found == entries_.begin() || found == entries_.end() || !found->base.empty())
            return refuse("a grade of a material that is in the list and no grade itself");
        if (found->machinability != property.machinability)
            return refuse("a grade that is machinable as its material is");
        base = static_cast<PropertyIndex>(found - entries_.begin());
    }
    if (machinable) {
        const auto count = [&](auto&& counts) { return std::count_if(entries_.begin() + 1, entries_.end(), counts); };
        const auto isMachinable = [](const Property& entry) {
            return entry.machinability == Machinability::machinable;
        };
        if (count(isMachinable) >= maximumMachinableProperties)
            return refuse("at most " + std::to_string(maximumMachinableProperties) + " machinable properties");
        if (!isGrade && count([&](const Property& entry) { return isMachinable(entry) && entry.base.empty(); }) >=
                            maximumMachinableMaterials)
            return refuse("at most " + std::to_string(maximumMachinableMaterials) +
                          " machinable materials, their grades not counted");
    }
    protected_[index] = !machinable;
    base_[index] = base;
    entries_.push_back(std::move(property));
    return index;
}

} // namespace burin
