// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace burin {

/// Lines of a text without their line endings, of any system.
class TextLines {
public:
    explicit TextLines(std::string_view text) noexcept : rest_(text) {}

    std::optional<std::string_view> next() noexcept {
        if (rest_.empty()) return std::nullopt;
        const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end);
        if (rest_.starts_with("\r\n"))
            rest_.remove_prefix(2);
        else if (!rest_.empty())
            rest_.remove_prefix(1);
        return line;
    }
    /// The text after the line that was returned last.
    std::string_view rest() const noexcept { return rest_; }

private:
    std::string_view rest_;
};

inline std::string_view trimmed(std::string_view text) noexcept {
    constexpr std::string_view spaces = " \t";
    const std::size_t first = text.find_first_not_of(spaces);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

/// Returns the first word of a line, and the text after it.
inline std::pair<std::string_view, std::string_view> firstWord(std::string_view line) noexcept {
    line = trimmed(line);
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    return {line.substr(0, end), trimmed(line.substr(end))};
}

} // namespace burin
