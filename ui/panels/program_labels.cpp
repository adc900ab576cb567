// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/program_labels.h"

namespace burin {

namespace {

bool belongsToNumber(QChar c) {
    return c.isDigit() || c == QLatin1Char('.') || c == QLatin1Char('+') || c == QLatin1Char('-');
}

ProgramWord::Kind kindOf(QChar letter) {
    if (QStringLiteral("GM").contains(letter)) return ProgramWord::Kind::code;
    if (QStringLiteral("XYZABCUVWIJKR").contains(letter)) return ProgramWord::Kind::axis;
    if (QStringLiteral("FST").contains(letter)) return ProgramWord::Kind::speed;
    return ProgramWord::Kind::number;
}

/// The end of the comment that starts at `start`.
int commentEnd(const QString& line, int start) {
    if (line[start] == QLatin1Char(';')) return static_cast<int>(line.size());
    const auto end = line.indexOf(QLatin1Char(')'), start);
    return static_cast<int>(end < 0 ? line.size() : end + 1);
}

} // namespace

std::vector<ProgramWord> programWords(const QString& line) {
    std::vector<ProgramWord> words;
    const int size = static_cast<int>(line.size());
    for (int i = 0; i < size;) {
        const QChar c = line[i];
        if (c == QLatin1Char('(') || c == QLatin1Char(';')) {
            const int end = commentEnd(line, i);
            words.push_back({i, end - i, ProgramWord::Kind::comment});
            i = end;
            continue;
        }
        int end = i + 1;
        while (end < size && belongsToNumber(line[end])) ++end;
        if (c.isLetter() && end > i + 1) words.push_back({i, end - i, kindOf(c.toUpper())});
        i = end;
    }
    return words;
}

ColourRole roleOf(ProgramWord::Kind kind) {
    switch (kind) {
    case ProgramWord::Kind::code:
        return &Palette::accent;
    case ProgramWord::Kind::axis:
        return &Palette::text;
    case ProgramWord::Kind::speed:
        return &Palette::part;
    case ProgramWord::Kind::comment:
        return &Palette::inOrder;
    case ProgramWord::Kind::number:
        return &Palette::quietText;
    }
    return &Palette::text;
}

} // namespace burin
