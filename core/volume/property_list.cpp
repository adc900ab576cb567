// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/property_list.h"

#include <algorithm>

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
    const auto sameId = [&](const Property& entry) { return entry.id == property.id; };
    if (std::any_of(entries_.begin(), entries_.end(), sameId))
        return Error{ErrorCode::argumentInvalid, "property id", property.id, "an id that is not in the list yet"};
    if (entries_.size() > 255)
        return Error{ErrorCode::argumentInvalid, "property", property.id, "at most 255 properties beside air"};
    const bool machinable = property.machinability == Machinability::machinable;
    const auto isMachinable = [](const Property& entry) { return entry.machinability == Machinability::machinable; };
    // Air counts as machinable by its default, so one more than the limit stands in the list.
    if (machinable && std::count_if(entries_.begin(), entries_.end(), isMachinable) > maximumMachinableProperties)
        return Error{ErrorCode::argumentInvalid, "property", property.id,
                     "at most " + std::to_string(maximumMachinableProperties) + " machinable properties"};
    const auto index = static_cast<PropertyIndex>(entries_.size());
    protected_[index] = !machinable;
    entries_.push_back(std::move(property));
    return index;
}

} // namespace burin
