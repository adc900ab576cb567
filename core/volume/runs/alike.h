// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/grid.h"
#include "core/volume/runs/property_list.h"

namespace burin {

/// Whether two volumes have the same grid, bit for bit.
inline bool alike(const Grid& one, const Grid& other) noexcept {
    return one.low() == other.low() && one.edge() == other.edge() && one.count() == other.count() &&
           one.axis() == other.axis();
}

/// Whether two lists have the same entries, with equal values. @throws std::bad_alloc
inline bool alike(const PropertyList& one, const PropertyList& other) {
    if (one.size() != other.size()) return false;
    for (int i = 1; i < one.size(); ++i) {
        const auto entry = static_cast<PropertyIndex>(i);
        if (one.isProtected(entry) != other.isProtected(entry) || toJson(one[entry]) != toJson(other[entry]))
            return false;
    }
    return true;
}

} // namespace burin
