// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/messages/filled_text.h"

#include "core/base/filled.h"

#include <string>
#include <vector>

namespace burin {

QRegularExpression patternOf(TextId text) {
    QString pattern = QRegularExpression::escape(QString::fromUtf8(text.text));
    static const QRegularExpression place(QStringLiteral("\\\\%[1-9]"));
    return QRegularExpression(QRegularExpression::anchoredPattern(pattern.replace(place, QStringLiteral("(.+)"))),
                              QRegularExpression::DotMatchesEverythingOption);
}

QString filled(const QString& text, const QStringList& values) {
    std::vector<std::string> list;
    for (const QString& value : values) list.push_back(value.toStdString());
    return QString::fromStdString(filled(text.toStdString(), std::span<const std::string>(list)));
}

} // namespace burin
