// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace burin {

/// `text` with %1 replaced by the first value and so on, at most nine; in one pass, so that a value may contain "%2".
inline std::string filled(std::string_view text, std::span<const std::string> values) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char number = text[i] == '%' && i + 1 < text.size() ? text[i + 1] : '0';
        if (number >= '1' && number <= '9' && static_cast<std::size_t>(number - '1') < values.size()) {
            result += values[static_cast<std::size_t>(number - '1')];
            ++i;
        } else {
            result += text[i];
        }
    }
    return result;
}

} // namespace burin
