// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/file_kind.h"

#include "core/base/file.h"
#include "core/base/trimmed.h"
#include "core/nc/apt_reader.h"
#include "core/nc/line_walker.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace burin {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t headSize = 16384;
constexpr std::string_view databaseHead("SQLite format 3\0", 16);
constexpr std::string_view spaces = " \t\r\f\v";

bool isNamedProject(const fs::path& file) {
    std::string suffix = file.extension().string();
    std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return std::tolower(c); });
    return suffix == ".burin";
}

/// Whether a line of a text indicates that it is NC code.
enum class LineKind : std::uint8_t { nothing, block, command, other };

/// Pairs of a letter and a number, as in RS274 blocks; the check ends at a comment.
LineKind lineKind(std::string_view line) {
    constexpr std::string_view values = "+-.0123456789#[";
    line = trimmed(line, spaces);
    if (!line.empty() && line.front() == '/') line.remove_prefix(1);
    LineKind kind = LineKind::nothing;
    while (!(line = trimmed(line, spaces)).empty()) {
        const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(line.front())));
        if (letter == '(' || letter == ';' || letter == '%') return kind;
        if (letter < 'A' || letter > 'Z') return LineKind::other;
        line = trimmed(line.substr(1), spaces);
        if (line.empty() || values.find(line.front()) == std::string_view::npos) return LineKind::other;
        line.remove_prefix(std::min(line.find_first_not_of("+-.0123456789#[]* \t"), line.size()));
        if (letter == 'G' || letter == 'M') kind = LineKind::command;
        if (kind == LineKind::nothing) kind = LineKind::block;
    }
    return kind;
}

/// Whether nine in ten of the lines are blocks, and some of them contain commands. @param cut  `text` is only the
/// beginning of the file
bool isProgram(std::string_view text, bool cut) {
    if (text.find('\0') != std::string_view::npos) return false;
    if (text.find("BEGIN PGM") != std::string_view::npos) return true; // Heidenhain's plain language
    if (cut) text = text.substr(0, text.find_last_of("\r\n") + 1);     // without the incomplete last line
    std::size_t blocks = 0, commands = 0, others = 0;
    LineWalker lines(text);
    while (const std::optional<std::string_view> line = lines.next()) {
        const LineKind kind = lineKind(*line);
        commands += kind == LineKind::command ? 1 : 0;
        blocks += kind == LineKind::command || kind == LineKind::block ? 1 : 0;
        others += kind == LineKind::other ? 1 : 0;
    }
    return commands > 0 && blocks >= 9 * others;
}

Result<std::string> headOf(const fs::path& file) {
    Result<std::ifstream> stream = openFileStream(file);
    if (!stream) return std::move(stream).error();
    std::string head(headSize, '\0');
    stream->read(head.data(), static_cast<std::streamsize>(head.size()));
    if (stream->bad()) return readError(file, errno);
    head.resize(static_cast<std::size_t>(stream->gcount()));
    return head;
}

} // namespace

Result<FileKind> fileKind(const fs::path& file) {
    std::error_code failed;
    const fs::file_status status = fs::status(file, failed);
    if (status.type() == fs::file_type::not_found && isNamedProject(file)) return FileKind::project;
    if (failed) return readError(file, failed.value());
    if (!fs::is_directory(status) && !fs::is_regular_file(status))
        return Error{ErrorCode::fileNotReadable, file.string(), {}, "is no plain file"};
    const Result<std::string> head = headOf(file);
    if (!head) return head.error();
    if (head->empty()) return Error{ErrorCode::fileEmpty, file.string(), {}, {}};
    if (head->starts_with(databaseHead)) return FileKind::project;
    if (isNamedProject(file)) return Error{ErrorCode::projectNotBurin, file.string(), {}, {}};
    if (isProgram(*head, head->size() == headSize)) return FileKind::program;
    return isCutterLocations(*head) ? FileKind::locations : FileKind::model;
}

} // namespace burin
