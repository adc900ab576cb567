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

/// Maps the values of a voxel array to materials.
class ArrayTable {
public:
    /// JSON: {"entries": [{"value": 0, "material": null}, {"from": 100, "to": 300, "material": "beech"}, …]}; a
    /// material is an id, null for air, or a complete material in Burin's own form. Both ends of a range are included.
    /// @param material finds a material by its id
    /// Errors: resourceInvalid (place: the entry), those of `material`, argumentInvalid (more materials than a list can
    /// hold, overlapping entries).
    static Result<ArrayTable> parse(std::string_view text, const std::string& origin,
                                    const std::function<Result<Property>(const std::string& id)>& material);

    const PropertyList& materials() const noexcept { return list_; }
    /// The material of a value; empty if no entry contains it. Cost: log of the entries.
    std::optional<PropertyIndex> of(double value) const noexcept;

private:
    struct Range {
        double from = 0.0, to = 0.0;
        PropertyIndex property = airProperty;
    };
    std::vector<Range> ranges_; ///< ascending, disjoint
    PropertyList list_;
};

/// The table that maps the property indices of a volume to their materials, in the form that `parse` reads.
std::string tableOf(const PropertyList& list);

} // namespace burin
