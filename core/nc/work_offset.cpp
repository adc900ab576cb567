// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/work_offset.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace burin {

namespace {

constexpr int furtherBegin = 1000; // NcMotion::workOffset
constexpr int furtherMost = 300;   // G54.1 P300, the highest that a Fanuc control has
constexpr int tenthsBegin = 590;   // 591 is G59.1

} // namespace

std::string workOffsetName(int number) {
    if (number > furtherBegin) return "P" + std::to_string(number - furtherBegin);
    if (number > tenthsBegin) return "G59." + std::to_string(number - tenthsBegin);
    return "G" + std::to_string(number);
}

std::optional<int> workOffsetFromName(std::string_view name) {
    std::string text(name);
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    if (text.size() > 1 && text.front() == 'P') {
        int further = 0;
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data() + 1, end, further);
        const bool known = read.ec == std::errc() && read.ptr == end && further >= 1 && further <= furtherMost;
        return known ? std::optional(furtherBegin + further) : std::nullopt;
    }
    for (const int number : {54, 55, 56, 57, 58, 59, 591, 592, 593})
        if (text == workOffsetName(number)) return number;
    return std::nullopt;
}

} // namespace burin
