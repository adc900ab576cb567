// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace burin {

/// A name or a sentence from outside as one line of valid UTF-8: bytes that are none, control characters (with those
/// that reverse or break the text around them) become U+FFFD, line ends and tabs spaces. For whoever reads a file.
std::string cleanLine(std::string_view text);

/// The same of a text of several lines, whose line ends and tabs stay. For whoever writes to a terminal.
std::string cleanText(std::string_view text);

} // namespace burin
