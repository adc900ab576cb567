// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"

#include <cstddef>
#include <cstdint>

namespace burin {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

/// A character and its size in bytes; `valid` is false if they are not UTF-8 (one byte is then skipped).
struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 1;
    bool valid = false;
};

/// RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF.
Character characterAt(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return {first, 1, true};
    const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < size) return {};
    std::uint32_t code = first & (0xFFU >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return {};
        code = code << 6U | (byte(i) & 0x3FU);
    }
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    if (code < least[size] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {};
    return {code, size, true};
}

bool isControl(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029 ||
           (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

std::string cleaned(std::string_view text, bool keepsLines) {
    std::string clean;
    clean.reserve(text.size());
    while (!text.empty()) {
        const Character character = characterAt(text);
        const bool space = character.code == '\n' || character.code == '\t' || character.code == '\r';
        if (character.valid && space)
            clean += keepsLines ? static_cast<char>(character.code) : ' ';
        else if (!character.valid || isControl(character.code))
            clean += replacement;
        else
            clean += text.substr(0, character.bytes);
        text.remove_prefix(character.bytes);
    }
    return clean;
}

} // namespace

std::string cleanLine(std::string_view text) {
    return cleaned(text, false);
}

std::string cleanText(std::string_view text) {
    return cleaned(text, true);
}

} // namespace burin
