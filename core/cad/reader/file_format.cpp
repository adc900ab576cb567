// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/file_format.h"

#include "core/cad/reader/stl_file.h"

#include <algorithm>
#include <cctype>

namespace burin {

namespace {

constexpr std::size_t igesRecord = 80;
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// What programs leave behind the end: blank lines, the Ctrl-Z of CP/M, the zeros of a record that was filled up.
bool isPadding(char c) {
    return isSpace(c) || c == '\x1A' || c == '\0';
}

std::string_view withoutLeadingSpace(std::string_view text) {
    if (text.substr(0, byteOrderMark.size()) == byteOrderMark) text.remove_prefix(byteOrderMark.size());
    while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
    return text;
}

/// ISO 10303-21: comments may stand wherever blanks may.
std::string_view withoutLeadingComments(std::string_view text) {
    while (text.substr(0, 2) == "/*") {
        const std::size_t end = text.find("*/", 2);
        if (end == std::string_view::npos) return text;
        text = withoutLeadingSpace(text.substr(end + 2));
    }
    return text;
}

bool startsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

Error damaged(std::string place) {
    return {ErrorCode::fileDamaged, {}, std::move(place), {}};
}

std::string_view firstLine(std::string_view text) {
    return text.substr(0, text.find_first_of("\r\n"));
}

/// IGES 5.3, section 2.2.1: records of 80 columns, a section letter in column 73, a sequence number behind it.
bool isIgesStart(std::string_view line) {
    if (line.size() < igesRecord || line[72] != 'S') return false;
    const std::string_view number = line.substr(73, 7);
    return std::all_of(number.begin(), number.end(), [](char c) { return c == ' ' || (c >= '0' && c <= '9'); }) &&
           number.back() == '1';
}

/// Some programs write a line or two of their own before the first record.
bool isIges(std::string_view content) {
    constexpr int mostComments = 5;
    for (int i = 0; i <= mostComments && !content.empty(); ++i) {
        if (isIgesStart(content.substr(0, igesRecord))) return true;
        content.remove_prefix(firstLine(content).size());
        content = content.substr(std::min(content.find_first_not_of("\r\n"), content.size()));
    }
    return false;
}

/// Taken off the content.
std::string_view takeLastLine(std::string_view& content) {
    while (!content.empty() && isPadding(content.back())) content.remove_suffix(1);
    const std::size_t line = content.find_last_of("\r\n");
    const std::string_view last = content.substr(line == std::string_view::npos ? 0 : line + 1);
    content.remove_suffix(last.size());
    return last;
}

bool isNumber(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// A text BREP ends with the number of its root shape and that of its location: "+1 0"; DRAW writes a flag on a line of
/// its own behind it. OpenCASCADE waits for ever for what is missing.
bool hasBrepEnd(std::string_view content) {
    std::string_view last = takeLastLine(content);
    if (isNumber(last)) last = takeLastLine(content);
    while (!last.empty() && last.back() == ' ') last.remove_suffix(1);
    const std::size_t space = last.find(' ');
    return space != std::string_view::npos && (last[0] == '+' || last[0] == '-') &&
           isNumber(last.substr(1, space - 1)) && isNumber(last.substr(space + 1));
}

bool hasIgesEnd(std::string_view content) {
    const std::string_view last = takeLastLine(content);
    return last.size() > 72 && last[72] == 'T';
}

} // namespace

Result<FileFormat> detectFormat(std::string_view content) {
    const std::string_view text = withoutLeadingComments(withoutLeadingSpace(content));
    if (text.empty()) return Error{ErrorCode::fileEmpty, {}, {}, {}};
    if (startsWith(text, "ISO-10303-21")) {
        if (!contains(content, "END-ISO-10303-21")) return damaged("the end of the file is missing");
        return FileFormat::step;
    }
    constexpr std::size_t brepHead = 200;
    const std::string_view head = text.substr(0, brepHead);
    if (startsWith(text, "Open CASCADE Topology V")) return FileFormat::brepBinary;
    if (contains(head, "CASCADE Topology V")) {
        if (!hasBrepEnd(content)) return damaged("the end of the file is missing");
        return FileFormat::brepText;
    }
    if (isIges(content)) {
        if (!hasIgesEnd(content)) return damaged("the end of the file is missing");
        return FileFormat::iges;
    }
    // Many binary files begin with "solid" too: their length tells.
    if (hasLengthOfBinaryStl(content)) return FileFormat::stlBinary;
    if (isTextStl(content)) return FileFormat::stlText;
    if (isLongerBinaryStl(content)) return FileFormat::stlBinary;
    if (const std::string place = whereBinaryStlEnds(content); !place.empty()) return damaged(place);
    return Error{ErrorCode::fileFormatUnknown, {}, {}, {}};
}

std::string stepProtocol(std::string_view content) {
    const std::size_t schema = content.find("FILE_SCHEMA");
    if (schema == std::string_view::npos) return "STEP";
    const std::size_t end = content.find(';', schema);
    std::string names(content.substr(schema, end == std::string_view::npos ? 400 : end - schema));
    std::transform(names.begin(), names.end(), names.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    if (contains(names, "AP242")) return "STEP AP242";
    if (contains(names, "AUTOMOTIVE_DESIGN")) return "STEP AP214";
    if (contains(names, "CONFIG_CONTROL_DESIGN") || contains(names, "AP203")) return "STEP AP203";
    return "STEP";
}

} // namespace burin
