// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/property_list.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Which material the values of a voxel array mean.
class ArrayTable {
public:
    /// JSON: {"entries": [{"value": 0, "material": null}, {"from": 100, "to": 300, "material": "beech"}, …]}; a
    /// material is an id, null for air, or a whole material in Burin's own form. Both ends of a range belong to it.
    /// @param material finds those that are named by their ids
    /// Errors: resourceInvalid (place: the entry), those of `material`, argumentInvalid (more than a list holds,
    /// entries that overlap).
    static Result<ArrayTable> parse(std::string_view text, const std::string& origin,
                                    const std::function<Result<Property>(const std::string& id)>& material);

    const PropertyList& materials() const noexcept { return list_; }
    /// The material of a value; nothing: no entry has it. Cost: log of the entries.
    std::optional<PropertyIndex> of(double value) const noexcept;

private:
    struct Range {
        double from = 0.0, to = 0.0;
        PropertyIndex property = airProperty;
    };
    std::vector<Range> ranges_; ///< rising, apart
    PropertyList list_;
};

/// The table of a volume's own properties by their indices, in the form that `parse` reads.
std::string tableOf(const PropertyList& list);

} // namespace burin
