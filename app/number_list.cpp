// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/number_list.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <charconv>

namespace burin {

std::vector<std::string> partsOf(const std::string& text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(separator, start), text.size());
        parts.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return parts;
}

std::optional<std::size_t> indexOfNumber(const std::string& text, std::size_t count) {
    const char* const end = text.data() + text.size();
    std::size_t number = 0;
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end || number < 1 || number > count) return std::nullopt;
    return number - 1;
}

std::optional<std::vector<double>> numbersOf(const std::string& text, std::size_t count) {
    std::vector<double> numbers;
    for (const std::string& part : partsOf(text, ',')) {
        const std::optional<double> number = parseNumber(part);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    if (numbers.size() != count) return std::nullopt;
    return numbers;
}

std::optional<glm::dvec3> vectorOf(const std::string& text) {
    const std::optional<std::vector<double>> numbers = numbersOf(text, 3);
    if (!numbers) return std::nullopt;
    return glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

} // namespace burin
