// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/array_table.h"

#include "core/base/numbers.h"
#include "core/volume/runs/property_entry.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

using nlohmann::json;

Error wrong(const std::string& origin, std::size_t entry, std::string why) {
    return {ErrorCode::resourceInvalid, origin, "entries[" + std::to_string(entry) + "]", std::move(why)};
}

std::optional<double> numberOf(const json& entry, const char* key) {
    const auto found = entry.find(key);
    if (found == entry.end() || !found->is_number()) return std::nullopt;
    const double number = found->get<double>();
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

} // namespace

Result<ArrayTable> ArrayTable::parse(std::string_view text, const std::string& origin,
                                     const std::function<Result<Property>(const std::string& id)>& material) {
    const json whole = json::parse(text, nullptr, false);
    if (!whole.is_object() || !whole.contains("entries") || !whole["entries"].is_array())
        return Error{ErrorCode::resourceInvalid, origin, "entries", "has to be a list"};
    ArrayTable table;
    for (std::size_t i = 0; i < whole["entries"].size(); ++i) {
        const json& entry = whole["entries"][i];
        if (!entry.is_object() || !entry.contains("material")) return wrong(origin, i, "has to name a material");
        const std::optional<double> value = numberOf(entry, "value");
        const std::optional<double> from = value ? value : numberOf(entry, "from");
        const std::optional<double> to = value ? value : numberOf(entry, "to");
        if (!from || !to || *from > *to) return wrong(origin, i, "has to have a value, or from and to that rise");
        Range range{*from, *to, airProperty};
        const json& named = entry["material"];
        if (!named.is_null()) {
            Result<Property> property = named.is_string() ? material(named.get<std::string>())
                                        : named.is_object()
                                            ? propertyFromJson(named.dump(), origin)
                                            : wrong(origin, i, "material has to be an id, null or a material");
            if (!property) return std::move(property).error();
            if (const auto standing = entryOf(table.list_, property->id)) {
                range.property = *standing;
            } else {
                const Result<PropertyIndex> added = table.list_.add(*std::move(property));
                if (!added) return added.error();
                range.property = *added;
            }
        }
        table.ranges_.push_back(range);
    }
    std::ranges::sort(table.ranges_, {}, &Range::from);
    for (std::size_t i = 1; i < table.ranges_.size(); ++i)
        if (table.ranges_[i].from <= table.ranges_[i - 1].to)
            return Error{ErrorCode::argumentInvalid, origin, formatShortest(table.ranges_[i].from),
                         "values that one entry alone has"};
    return table;
}

std::optional<PropertyIndex> ArrayTable::of(double value) const noexcept {
    auto next = std::ranges::upper_bound(ranges_, value, {}, &Range::from);
    if (next == ranges_.begin()) return std::nullopt;
    --next;
    return value <= next->to ? std::optional(next->property) : std::nullopt;
}

std::string tableOf(const PropertyList& list) {
    json entries = json::array();
    entries.push_back({{"value", 0}, {"material", nullptr}});
    for (int i = 1; i < list.size(); ++i)
        entries.push_back({{"value", i}, {"material", json::parse(toJson(list[static_cast<PropertyIndex>(i)]))}});
    return json{{"entries", std::move(entries)}}.dump(2) + "\n";
}

} // namespace burin
