// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/model_labels.h"

#include "core/cad/import_notes.h"
#include "ui/messages/filled_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace burin {

namespace {

// Unit names as used in CAD files; short names such as "mm" need no translation.
[[maybe_unused]] constexpr std::array longUnitNames{BURIN_TEXT("ImportUnit", "inch"), BURIN_TEXT("ImportUnit", "foot"),
                                                    BURIN_TEXT("ImportUnit", "yard")};

QString translated(TextId text) {
    return QCoreApplication::translate(text.context, text.text);
}

std::optional<QString> nameOf(TextId unnamed, const QString& name) {
    const QRegularExpressionMatch match = patternOf(unnamed).match(name);
    if (!match.hasMatch()) return std::nullopt;
    bool number = false;
    static_cast<void>(match.captured(1).toUInt(&number));
    if (!number) return std::nullopt;
    return filled(translated(unnamed), {match.captured(1)});
}

/// Numbers get the locale's decimal point, names given by Burin their translation.
QString valueText(const QString& value) {
    static const QRegularExpression decimal(QStringLiteral("^-?[0-9]+\\.[0-9]+$"));
    if (decimal.match(value).hasMatch()) return QString(value).replace(QLatin1Char('.'), QLocale().decimalPoint());
    if (value.startsWith(QLatin1Char('"')) && value.endsWith(QLatin1Char('"')) && value.size() > 1)
        return QLatin1Char('"') + bodyName(value.sliced(1, value.size() - 2).toStdString()) + QLatin1Char('"');
    if (const std::optional<QString> solid = nameOf(import_notes::unnamedSolid, value)) return *solid;
    return QCoreApplication::translate("ImportUnit", value.toUtf8().constData());
}

} // namespace

QString importNoteText(const std::string& note) {
    static const std::vector<std::pair<QRegularExpression, TextId>> known = [] {
        std::vector<std::pair<QRegularExpression, TextId>> patterns;
        for (const TextId& text : import_notes::all) patterns.emplace_back(patternOf(text), text);
        return patterns;
    }();
    const QString english = QString::fromStdString(note);
    for (const auto& [pattern, text] : known) {
        const QRegularExpressionMatch match = pattern.match(english);
        if (!match.hasMatch()) continue;
        QStringList values = match.capturedTexts().sliced(1);
        for (QString& value : values) value = valueText(value);
        return filled(translated(text), values);
    }
    return english;
}

QString bodyName(const std::string& name) {
    QStringList elements = QString::fromStdString(name).split(QLatin1Char('/'));
    for (QString& element : elements) {
        if (const std::optional<QString> body = nameOf(import_notes::unnamedBody, element)) element = *body;
        if (const std::optional<QString> within = nameOf(import_notes::unnamedAssembly, element)) element = *within;
    }
    return elements.join(QLatin1Char('/'));
}

} // namespace burin
