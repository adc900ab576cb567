// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cmath>
#include <string_view>

namespace burin {

/// Reads numbers from an attribute of SVG, in which blanks and commas between them are optional.
class SvgNumbers {
public:
    explicit SvgNumbers(std::string_view text) : rest_(text) { skip(); }

    bool ended() const noexcept { return rest_.empty(); }
    /// The next character if it is a letter, otherwise 0.
    char letter() noexcept {
        const char next = ended() ? '\0' : rest_.front();
        if (!((next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z'))) return 0;
        rest_.remove_prefix(1);
        skip();
        return next;
    }
    bool number(double& value) noexcept {
        std::string_view text = rest_;
        if (!text.empty() && text.front() == '+') text.remove_prefix(1);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || !std::isfinite(value)) return false;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        skip();
        return true;
    }
    /// One character, 0 or 1.
    bool flag(bool& value) noexcept {
        if (ended() || (rest_.front() != '0' && rest_.front() != '1')) return false;
        value = rest_.front() == '1';
        rest_.remove_prefix(1);
        skip();
        return true;
    }
    /// The remaining text.
    std::string_view rest() const noexcept { return rest_; }

private:
    void skip() noexcept {
        const auto first = rest_.find_first_not_of(" \t\r\n\f,");
        rest_.remove_prefix(first == std::string_view::npos ? rest_.size() : first);
    }
    std::string_view rest_;
};

} // namespace burin
