// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/array_volume.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

/// An array that is read has as many values as its sizes state, and becomes a volume or an error; the same for a table.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string text(reinterpret_cast<const char*>(bytes), count);
    const auto named = [](const std::string& id) -> burin::Result<burin::Property> {
        burin::Property property;
        property.id = property.name = id;
        return property;
    };
    (void)burin::ArrayTable::parse(text, "fuzz", named);
    const auto array = burin::readArray(text, "/nowhere/fuzz");
    if (!array) return 0;
    const auto voxels = static_cast<std::size_t>(array->count.x) * static_cast<std::size_t>(array->count.y) *
                        static_cast<std::size_t>(array->count.z);
    if (std::visit([](const auto& values) { return values.size(); }, array->values) != voxels) std::abort();
    if (voxels > 100'000) return 0;
    const auto table = burin::ArrayTable::parse(
        R"({"entries": [{"from": -1e300, "to": -1e-300, "material": "a"}, {"value": 0, "material": null}]})", "fuzz",
        named);
    (void)burin::volumeOf(*array, *table);
    return 0;
}
