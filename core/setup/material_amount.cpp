// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/material_amount.h"

namespace burin {

namespace {

constexpr double cubicMillimetresPerCubicCentimetre = 1e3;

} // namespace

std::vector<MaterialAmount> amountsOf(const PropertyList& list, const RunAmounts& runs, double unitVolume) {
    std::vector<MaterialAmount> amounts;
    std::vector<std::size_t> placeOf(static_cast<std::size_t>(list.size()), 0);
    for (int i = 1; i < list.size(); ++i) {
        const auto index = static_cast<PropertyIndex>(i);
        const Property& property = list[index];
        const PropertyIndex base = list.baseOf(index);
        if (base == index) {
            placeOf[index] = amounts.size();
            amounts.push_back({property.id, property.name, list.isProtected(index), 0.0, 0.0});
        }
        MaterialAmount& amount = amounts[placeOf[base]];
        const double volume = static_cast<double>(runs.units[index]) * unitVolume;
        amount.volume += volume;
        const double weight = property.valueOr(density, 0.0); // g/cm³
        if (!(weight > 0.0))
            amount.mass.reset();
        else if (amount.mass)
            *amount.mass += volume / cubicMillimetresPerCubicCentimetre * weight;
    }
    return amounts;
}

} // namespace burin
