// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/block.h"
#include "core/nc/control.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace burin {

/// Iterates over the lines of a program and recognises its tape marks. A byte order mark before the first line is not
/// part of the text. Keeps a view of the text.
class LineWalker {
public:
    explicit LineWalker(std::string_view text) noexcept : rest_(text) {
        constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
        if (rest_.starts_with(byteOrderMark)) rest_.remove_prefix(byteOrderMark.size());
        newline_ = rest_.find('\n');
    }

    /// Returns the next line without its end: LF, CR, CR LF, or the CR CR LF of a file that was converted twice. Empty
    /// after the last line.
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
    std::uint32_t number() const noexcept { return number_; } ///< of the line that `next` returned last, from 1

    /// The meaning of the line that `next` returned last, a block, as a tape mark: the % of the first line opens the
    /// tape, the next one ends the program and with it all that is read.
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
    std::size_t newline_ = std::string_view::npos; ///< the first LF of `rest_`
    std::uint32_t number_ = 0;
    bool seenMark_ = false, seenWords_ = false;
    /// whether the line that `next` returned last, and one before it, has more than blanks
    bool hasText_ = false, seenText_ = false;
};

/// Lines that a LineWalker gives.
inline std::uint32_t lineCount(std::string_view text) noexcept {
    LineWalker lines(text);
    while (lines.next()) {
    }
    return lines.number();
}

} // namespace burin
