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

std::string_view withoutLeadingSpace(std::string_view text) {
    if (text.substr(0, byteOrderMark.size()) == byteOrderMark) text.remove_prefix(byteOrderMark.size());
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
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

/// IGES 5.3, section 2.2.1: records of 80 columns, a section letter in column 73, a sequence number behind it.
bool isIges(std::string_view content) {
    if (content.size() < igesRecord || content[72] != 'S') return false;
    const std::string_view number = content.substr(73, 7);
    return std::all_of(number.begin(), number.end(), [](char c) { return c == ' ' || (c >= '0' && c <= '9'); }) &&
           number.back() == '1';
}

std::string_view lastLine(std::string_view content) {
    while (!content.empty() && std::isspace(static_cast<unsigned char>(content.back())) != 0) content.remove_suffix(1);
    const std::size_t line = content.find_last_of("\r\n");
    return content.substr(line == std::string_view::npos ? 0 : line + 1);
}

/// A text BREP ends with the number of its root shape and that of its location: "+1 0". OpenCASCADE waits for ever for
/// what is missing.
bool hasBrepEnd(std::string_view content) {
    const std::string_view last = lastLine(content);
    const std::size_t space = last.find(' ');
    const auto isNumber = [](std::string_view text) {
        return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    return space != std::string_view::npos && (last[0] == '+' || last[0] == '-') &&
           isNumber(last.substr(1, space - 1)) && isNumber(last.substr(space + 1));
}

bool hasIgesEnd(std::string_view content) {
    const std::string_view last = lastLine(content);
    return last.size() > 72 && last[72] == 'T';
}

} // namespace

Result<FileFormat> detectFormat(std::string_view content) {
    const std::string_view text = withoutLeadingSpace(content);
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
