// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/block.h"
#include "core/nc/control.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace burin {

/// Walks over the lines of a program and knows its tape marks. A byte order mark before the first line is none of its
/// text. Views the text.
class LineWalker {
public:
    explicit LineWalker(std::string_view text) noexcept : rest_(text) {
        constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
        if (rest_.starts_with(byteOrderMark)) rest_.remove_prefix(byteOrderMark.size());
        newline_ = rest_.find('\n');
    }

    /// The next line without its end: LF, CR, CR LF, or the CR CR LF of a file that was converted twice. Nothing behind
    /// the last one.
    std::optional<std::string_view> next() noexcept {
        if (rest_.empty()) return std::nullopt;
        ++number_;
        std::string_view line = rest_.substr(0, newline_);
        const std::size_t end = line.find('\r');
        const bool endsByNewline =
            end == std::string_view::npos || line.size() - end == 1 || line.substr(end) == "\r\r";
        if (endsByNewline && newline_ != std::string_view::npos) {
            pass(newline_ + 1);
            newline_ = rest_.find('\n');
        } else {
            pass(std::min(end, rest_.size() - 1) + 1);
        }
        line = line.substr(0, end);
        seenText_ = seenText_ || hasText_;
        hasText_ = line.find_first_not_of(" \t") != std::string_view::npos;
        return line;
    }
    std::uint32_t number() const noexcept { return number_; } ///< of the line that `next` gave, from 1

    /// What the line that `next` gave, a block, is to the tape: the first line's % opens it, the next one ends the
    /// program and all that is read of it.
    enum class Mark : std::uint8_t { none, opens, closes, misplaced };
    Mark mark(const Block& block, TapeMarks marks) noexcept {
        const bool closes = seenMark_ || (marks == TapeMarks::around && seenWords_);
        const bool mayOpen = marks == TapeMarks::around || !seenText_;
        seenMark_ = seenMark_ || block.percent;
        seenWords_ = seenWords_ || !block.empty();
        if (!block.percent) return Mark::none;
        return closes ? Mark::closes : mayOpen ? Mark::opens : Mark::misplaced;
    }

private:
    void pass(std::size_t count) noexcept {
        rest_.remove_prefix(count);
        if (newline_ != std::string_view::npos) newline_ -= std::min(count, newline_);
    }

    std::string_view rest_;
    std::size_t newline_ = std::string_view::npos; ///< the first LF of the rest
    std::uint32_t number_ = 0;
    bool seenMark_ = false, seenWords_ = false;
    bool hasText_ = false, seenText_ = false; ///< the line that `next` gave has more than blanks; one before it had
};

/// Lines that a LineWalker gives.
inline std::uint32_t lineCount(std::string_view text) noexcept {
    LineWalker lines(text);
    while (lines.next()) {
    }
    return lines.number();
}

} // namespace burin
