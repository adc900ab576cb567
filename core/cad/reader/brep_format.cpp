// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/cad_model.h"
#include "core/cad/reader/file_format.h"
#include "core/cad/reader/file_text.h"

#include <algorithm>

namespace burin {

namespace {

bool isBinary(std::string_view content) {
    return file_text::withoutLead(content).starts_with("Open CASCADE Topology V");
}

bool isNumber(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// A text BREP ends with the numbers of its root shape and of its location: "+1 0"; DRAW writes a flag on a separate
/// line after it. OpenCASCADE waits forever for missing data.
bool hasBrepEnd(std::string_view content) {
    std::string_view last = file_text::takeLastLine(content);
    if (isNumber(last)) last = file_text::takeLastLine(content);
    while (!last.empty() && last.back() == ' ') last.remove_suffix(1);
    const std::size_t space = last.find(' ');
    return space != std::string_view::npos && (last[0] == '+' || last[0] == '-') &&
           isNumber(last.substr(1, space - 1)) && isNumber(last.substr(space + 1));
}

} // namespace

FormatMatch matchFormat(BrepFormat, std::string_view content) {
    if (isBinary(content)) return {true, {}};
    constexpr std::size_t headSize = 200;
    if (!file_text::contains(file_text::withoutLead(content).substr(0, headSize), "CASCADE Topology V")) return {};
    return {true, std::string(hasBrepEnd(content) ? "" : file_text::endIsMissing)};
}

Result<Model> readFormat(BrepFormat, ModelSource& source) {
    return modelOf(readBrepFile(source.content, isBinary(source.content), source.report), source);
}

} // namespace burin
