// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Removes the first line from `rest` and returns it without its LF or CR LF.
std::string_view takeLine(std::string_view& rest);

/// The comma-separated fields of one line (RFC 4180): a field may be enclosed in double quotes, where two of them stand
/// for one. Spaces and tabs around a field are dropped. Empty for a quote that is not closed, or text behind it.
std::optional<std::vector<std::string>> csvFields(std::string_view line);

/// True for well-formed UTF-8 (RFC 3629).
bool isUtf8(std::string_view text) noexcept;

} // namespace burin
