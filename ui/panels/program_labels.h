// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/theme.h"

#include <QString>

#include <vector>

namespace burin {

/// A range of characters of a block that is shown in one colour.
struct ProgramWord {
    int start = 0, length = 0; ///< characters
    enum class Kind { code, axis, speed, comment, number } kind = Kind::code;
    bool operator==(const ProgramWord&) const = default;
};

/// The words of one line of a program: G and M codes, axes and arcs, F S T, comments in brackets or after a semicolon,
/// block numbers. Other text has no entry. For colouring only: accepts any text.
std::vector<ProgramWord> programWords(const QString& line);

ColourRole roleOf(ProgramWord::Kind kind);

} // namespace burin
