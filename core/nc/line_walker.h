// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/block.h"

#include <optional>
#include <string_view>

namespace burin {

/// Walks over the lines of a program and knows its tape marks. Views the text.
class LineWalker {
public:
    explicit LineWalker(std::string_view text) noexcept : rest_(text) {}

    /// The next line without its end (LF or CR LF); nothing behind the last one.
    std::optional<std::string_view> next() noexcept {
        if (rest_.empty()) return std::nullopt;
        ++number_;
        const std::size_t end = rest_.find('\n');
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        return line;
    }
    std::uint32_t number() const noexcept { return number_; } ///< of the line that `next` gave, from 1

    /// Whether a block, the line that `next` gave, ends the program by its tape mark: the first line's % opens the
    /// tape, the next one ends the program and all that is read of it.
    bool closes(const Block& block) noexcept {
        const bool closes = block.percent && (seenMark_ || seenWords_);
        seenMark_ = seenMark_ || block.percent;
        seenWords_ = seenWords_ || !block.empty();
        return closes;
    }

private:
    std::string_view rest_;
    std::uint32_t number_ = 0;
    bool seenMark_ = false, seenWords_ = false;
};

} // namespace burin
