// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace CLI {
class ParseError;
}

namespace burin {

/// One sentence in the user's language for arguments that the parser rejected. Needs the installed translations.
QString sentenceFor(const CLI::ParseError& error);

} // namespace burin
