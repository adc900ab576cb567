// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace burin {

/// The integer value of a JSON value, from `low` to `high`; empty for anything else. nlohmann::json truncates values
/// that do not fit the requested type: 4294967297 would pass as an int of 1, 18446744073709551615 as -1.
/// @param value of any kind of nlohmann::basic_json
template <class Json>
std::optional<std::int64_t> wholeNumber(const Json& value, std::int64_t low = std::numeric_limits<std::int64_t>::min(),
                                        std::int64_t high = std::numeric_limits<std::int64_t>::max()) {
    if (!value.is_number_integer()) return std::nullopt;
    if (value.is_number_unsigned() && std::cmp_greater(value.template get<std::uint64_t>(), high)) return std::nullopt;
    const auto number = value.template get<std::int64_t>();
    if (number < low || number > high) return std::nullopt;
    return number;
}

} // namespace burin
