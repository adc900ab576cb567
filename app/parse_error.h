// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace burin {

/// One sentence in the user's language for arguments that the parser rejected. Needs the installed translations.
/// @param fault  what CLI11's ParseError says, in its English
QString sentenceFor(const char* fault);

} // namespace burin
