// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/cad_model.h"
#include "core/cad/reader/file_format.h"
#include "core/cad/reader/file_text.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::size_t igesRecord = 80;

std::string_view firstLine(std::string_view text) {
    return text.substr(0, text.find_first_of("\r\n"));
}

/// IGES 5.3, section 2.2.1: records of 80 columns, a section letter in column 73, followed by a sequence number.
bool isIgesStart(std::string_view line) {
    if (line.size() < igesRecord || line[72] != 'S') return false;
    const std::string_view number = line.substr(73, 7);
    return std::all_of(number.begin(), number.end(), [](char c) { return c == ' ' || (c >= '0' && c <= '9'); }) &&
           number.back() == '1';
}

/// Some programs write a few lines of their own before the first record.
bool isIges(std::string_view content) {
    constexpr int mostComments = 5;
    for (int i = 0; i <= mostComments && !content.empty(); ++i) {
        if (isIgesStart(content.substr(0, igesRecord))) return true;
        content.remove_prefix(firstLine(content).size());
        content = content.substr(std::min(content.find_first_not_of("\r\n"), content.size()));
    }
    return false;
}

bool hasIgesEnd(std::string_view content) {
    const std::string_view last = file_text::takeLastLine(content);
    return last.size() > 72 && last[72] == 'T';
}

} // namespace

FormatMatch matchFormat(IgesFormat, std::string_view content) {
    if (!isIges(content)) return {};
    return {true, std::string(hasIgesEnd(content) ? "" : file_text::endIsMissing)};
}

Result<Model> readFormat(IgesFormat, ModelSource& source) {
    return modelOf(readIgesFile(source.request.file, source.content.size(), source.report), source);
}

} // namespace burin
