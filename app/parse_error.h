// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace burin {

/// One sentence in the user's language for arguments that the parser rejected. Needs the installed translations.
/// @param fault the English message of CLI11's ParseError
QString sentenceFor(const char* fault);

} // namespace burin
