// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/block_writer.h"

#include <algorithm>

namespace burin {
namespace {

bool isLetter(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isPlain(char c) noexcept {
    return isLetter(c) || (c >= '0' && c <= '9') || c == ' ';
}

/// Replaces the comma after a first word, as in (MSG, …) or (DEBUG, …), which would be a command to a control.
void disarm(std::string& text, char instead) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) return;
    const std::size_t first = text.find_first_not_of(' ');
    for (std::size_t i = first; i < comma; ++i)
        if (!isLetter(text[i])) return;
    text[comma] = instead;
}

/// The beginning of a text that fits, up to a space: a number that is split would become another number.
std::string_view upToWidth(std::string_view text, std::size_t width) {
    if (text.size() <= width) return text;
    const std::size_t space = text.rfind(' ', width);
    return text.substr(0, space == std::string_view::npos || space == 0 ? width : space);
}

} // namespace

/// Printable ASCII without brackets, or what the dialect allows; every other character becomes a question mark.
std::string BlockWriter::commentText(std::string_view text) const {
    std::string clean;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 && byte < 0xC0) continue; // a continuation byte of a UTF-8 character
        if (dialect_.commentCharacters) {
            clean += isPlain(c) || dialect_.commentCharacters->find(c) != std::string::npos ? c : ' ';
        } else {
            clean += c == '(' ? '[' : c == ')' ? ']' : byte < 0x20 || byte > 0x7E ? '?' : c;
        }
        if (dialect_.commentUpperCase && clean.back() >= 'a' && clean.back() <= 'z')
            clean.back() = static_cast<char>(clean.back() - 'a' + 'A');
    }
    disarm(clean, insteadOfComma());
    return clean;
}

char BlockWriter::insteadOfComma() const {
    const bool colon = !dialect_.commentCharacters || dialect_.commentCharacters->find(':') != std::string::npos;
    return colon ? ':' : '.';
}

Result<void> BlockWriter::comment(std::string_view text) {
    std::string clean = commentText(text);
    const std::size_t frame = dialect_.commentOpen.size() + dialect_.commentClose.size();
    const auto width = std::max<std::size_t>(static_cast<std::size_t>(lineLength_), frame + 1) - frame;
    do {
        const std::string_view line = upToWidth(clean, width);
        if (Result<void> done = sink_.line(dialect_.commentOpen + std::string(line) + dialect_.commentClose); !done)
            return done;
        clean.erase(0, line.size());
        clean.erase(0, clean.find_first_not_of(' '));
        disarm(clean, insteadOfComma()); // the next line has a first word as well
    } while (!clean.empty());
    return {};
}

Result<void> BlockWriter::block(std::string_view words) {
    if (words.empty()) return {};
    const bool frame = words.front() == '%' || words.front() == 'O' || words.front() == ':';
    if (dialect_.lineNumberStep == 0 || frame) return sink_.line(words);
    number_ += dialect_.lineNumberStep;
    if (number_ > 99999) number_ = dialect_.lineNumberStep; // the limit of the shortest counters
    return sink_.line("N" + std::to_string(number_) + " " + std::string(words));
}

Result<std::string> BlockWriter::filled(std::string_view text,
                                        const std::function<Result<std::string>(std::string_view)>& valueOf) {
    std::string result;
    while (!text.empty()) {
        const std::size_t open = text.find('{');
        result += text.substr(0, open);
        if (open == std::string_view::npos) break;
        const std::size_t close = text.find('}', open);
        Result<std::string> value = valueOf(text.substr(open + 1, close - open - 1));
        if (!value) return value;
        result += *value;
        text.remove_prefix(close == std::string_view::npos ? text.size() : close + 1);
    }
    // Blanks that surrounded an empty value are removed at the ends.
    const std::size_t first = result.find_first_not_of(' ');
    if (first == std::string::npos) return std::string();
    return result.substr(first, result.find_last_not_of(' ') - first + 1);
}

} // namespace burin
