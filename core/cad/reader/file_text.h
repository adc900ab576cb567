// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

/// Helpers for the beginning and the end of the text of a model file.
namespace burin::file_text {

constexpr std::string_view endIsMissing = "the end of the file is missing";

inline bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

inline bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

inline std::string_view withoutLeadingSpace(std::string_view text) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
    while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
    return text;
}

/// Returns the text without leading blanks and comments as defined in ISO 10303-21: comments may stand wherever blanks
/// may.
inline std::string_view withoutLead(std::string_view text) {
    text = withoutLeadingSpace(text);
    while (text.starts_with("/*")) {
        const std::size_t end = text.find("*/", 2);
        if (end == std::string_view::npos) return text;
        text = withoutLeadingSpace(text.substr(end + 2));
    }
    return text;
}

/// Removes and returns the last line of the content. Also removes what programs leave after the end: blank lines, the
/// Ctrl-Z of CP/M, the zeros of a padded record.
inline std::string_view takeLastLine(std::string_view& content) {
    const auto isPadding = [](char c) { return isSpace(c) || c == '\x1A' || c == '\0'; };
    while (!content.empty() && isPadding(content.back())) content.remove_suffix(1);
    const std::size_t line = content.find_last_of("\r\n");
    const std::string_view last = content.substr(line == std::string_view::npos ? 0 : line + 1);
    content.remove_suffix(last.size());
    return last;
}

} // namespace burin::file_text
