// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/property_list.h"

#include <optional>
#include <string_view>

namespace burin {

/// The entry with the given material id, air excluded; empty if the list has none.
inline std::optional<PropertyIndex> entryOf(const PropertyList& list, std::string_view id) {
    for (int i = 1; i < list.size(); ++i)
        if (list[static_cast<PropertyIndex>(i)].id == id) return static_cast<PropertyIndex>(i);
    return std::nullopt;
}

} // namespace burin
