// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/file_format.h"

#include "core/cad/reader/file_text.h"

#include <array>
#include <utility>

namespace burin {

namespace {

template <class... Formats>
constexpr auto rowsOf(const std::tuple<Formats...>*) {
    return std::array{ReaderFormat{Formats::name,
                                   [](std::string_view content) { return matchFormat(Formats(), content); },
                                   [](ModelSource& source) { return readFormat(Formats(), source); }}...};
}

constexpr auto rows = rowsOf(static_cast<const ImportFormats*>(nullptr));

} // namespace

Result<ReaderFormat> detectFormat(std::string_view content) {
    if (file_text::withoutLead(content).empty()) return Error{ErrorCode::fileEmpty, {}, {}, {}};
    for (const ReaderFormat& format : rows) {
        FormatMatch match = format.match(content);
        if (!match.known) continue;
        if (!match.missing.empty()) return Error{ErrorCode::fileDamaged, {}, std::move(match.missing), {}};
        return format;
    }
    return Error{ErrorCode::fileFormatUnknown, {}, {}, {}};
}

} // namespace burin
