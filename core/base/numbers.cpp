// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"

#include "core/base/trimmed.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace burin {

std::string formatFixed(double value, int decimals) {
    std::array<char, 400> buffer{}; // the largest double has 309 digits before its point
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    if (error != std::errc{}) return "0";
    std::string text(buffer.data(), end);
    if (text.front() == '-' && text.find_first_of("123456789") == std::string::npos && std::isfinite(value))
        text.erase(0, 1);
    return text;
}

std::string formatLimit(double value, int decimals) {
    const double step = std::pow(10.0, -decimals);
    std::string text = formatFixed(value, decimals);
    if (parseNumber(text).value_or(value) < value) text = formatFixed(value + step, decimals);
    return text;
}

std::string formatShortest(double value) {
    std::array<char, 64> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return error == std::errc{} ? std::string(buffer.data(), end) : std::string("0");
}

std::optional<double> parseNumber(std::string_view text) {
    if (text.starts_with("+-")) return std::nullopt;
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

NumberWithUnit numberWithUnit(std::string_view text) {
    const std::string_view all = trimmed(text, " \t");
    const std::size_t end = std::min(all.find_first_not_of("+-.0123456789eE"), all.size());
    return {parseNumber(all.substr(0, end)), std::string(trimmed(all.substr(end), " \t"))};
}

} // namespace burin
