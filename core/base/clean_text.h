// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace burin {

/// A name or a sentence from an external source as one line of valid UTF-8: invalid bytes and control characters (also
/// those that reverse or break the surrounding text) become U+FFFD, line ends and tabs become spaces. For text read
/// from files.
std::string cleanLine(std::string_view text);

/// The same for a text of several lines, which keeps line ends and tabs. For text written to a terminal.
std::string cleanText(std::string_view text);

} // namespace burin
