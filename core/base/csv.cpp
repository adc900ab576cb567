// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/csv.h"

#include "core/base/trimmed.h"

#include <cstdint>

namespace burin {

namespace {

constexpr std::string_view blanks = " \t";

/// Reads a quoted field from `rest`, which begins behind the opening quote. Returns false if it is not closed.
bool takeQuoted(std::string_view& rest, std::string& field) {
    for (;;) {
        const std::size_t quote = rest.find('"');
        if (quote == std::string_view::npos) return false;
        field += rest.substr(0, quote);
        rest.remove_prefix(quote + 1);
        if (!rest.starts_with('"')) return true;
        field += '"';
        rest.remove_prefix(1);
    }
}

} // namespace

std::string_view takeLine(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::optional<std::vector<std::string>> csvFields(std::string_view line) {
    std::vector<std::string> fields;
    for (;;) {
        std::string field;
        const std::size_t start = line.find_first_not_of(blanks);
        const bool quoted = start != std::string_view::npos && line[start] == '"';
        if (quoted) {
            line.remove_prefix(start + 1);
            if (!takeQuoted(line, field)) return std::nullopt;
        }
        const std::size_t comma = line.find(',');
        const std::string_view plain = trimmed(line.substr(0, comma), blanks);
        if (quoted && !plain.empty()) return std::nullopt;
        if (!quoted) field = plain;
        fields.push_back(std::move(field));
        if (comma == std::string_view::npos) return fields;
        line.remove_prefix(comma + 1);
    }
}

bool isUtf8(std::string_view text) noexcept {
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<std::uint8_t>(text[i++]);
        if (first < 0x80) continue;
        const int more = first >= 0xC2 && first <= 0xDF   ? 1
                         : (first & 0xF0) == 0xE0         ? 2
                         : first >= 0xF0 && first <= 0xF4 ? 3
                                                          : 0;
        if (more == 0) return false;
        std::uint32_t point = first & (0x3Fu >> more);
        for (int k = 0; k < more; ++k) {
            const auto next = i < text.size() ? static_cast<std::uint8_t>(text[i++]) : std::uint8_t{0};
            if ((next & 0xC0) != 0x80) return false;
            point = point << 6 | (next & 0x3Fu);
        }
        const bool overlong = (more == 2 && point < 0x800) || (more == 3 && point < 0x10000);
        if (overlong || point > 0x10FFFF || (point >= 0xD800 && point <= 0xDFFF)) return false;
    }
    return true;
}

} // namespace burin
