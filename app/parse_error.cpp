// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/parse_error.h"

#include "core/base/numbers.h"
#include "ui/messages/messages.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace burin {

namespace {

/// The parts of the parser's English text captured by `pattern`; empty if it does not match.
QStringList partsByText(const QString& text, const char* pattern) {
    const QRegularExpressionMatch match =
        QRegularExpression("^" + QString(pattern) + "$", QRegularExpression::DotMatchesEverythingOption).match(text);
    return match.hasMatch() ? match.capturedTexts().sliced(1) : QStringList();
}

QString notAllowed(const QString& argument, const QString& value, const QString& allowed) {
    return Messages::sentence(
        {ErrorCode::argumentInvalid, argument.toStdString(), value.toStdString(), allowed.toStdString()});
}

/// "0.500000" in its shortest form: "0.5".
QString shortest(const QString& number) {
    const std::optional<double> value = parseNumber(number.toStdString());
    return value ? QString::fromStdString(formatShortest(*value)) : number;
}

} // namespace

QString sentenceFor(const char* fault) {
    const QString text = QString::fromLocal8Bit(fault);
    if (const QStringList parts = partsByText(text, "(.*?): Value (.*) not in range (\\S+) to (\\S+)");
        !parts.isEmpty())
        return notAllowed(
            parts[0], parts[1],
            QCoreApplication::translate("Command", "%1 to %2").arg(shortest(parts[2]), shortest(parts[3])));
    if (const QStringList parts = partsByText(text, "(.*?): (.*) not in \\{(.*)\\}"); !parts.isEmpty()) {
        QStringList names; // from "name->value" where the parser maps them
        for (const QString& entry : parts[2].split(',')) names << entry.section("->", 0, 0);
        return notAllowed(parts[0], parts[1], names.join(", "));
    }
    if (const QStringList parts = partsByText(text, "Could not convert: (.*?) = (.*)"); !parts.isEmpty())
        return notAllowed(parts[0], parts[1], QCoreApplication::translate("Command", "a number"));
    if (const QStringList parts = partsByText(text, "(.*?): (?:\\d+ required .* missing|At .*)"); !parts.isEmpty())
        return QCoreApplication::translate("Command", "\"%1\" needs a value.").arg(parts[0]);
    if (text == "A subcommand is required")
        return QCoreApplication::translate("Command", "A command is missing; \"burin --help\" lists the commands.");
    if (const QStringList parts = partsByText(text, "(.*) is required"); !parts.isEmpty())
        return QCoreApplication::translate("Command",
                                           "\"%1\" is missing; \"burin COMMAND --help\" shows what a command needs.")
            .arg(parts[0]);
    if (const QStringList parts = partsByText(text, "The following arguments? (?:was|were) not expected: (.*)");
        !parts.isEmpty())
        return QCoreApplication::translate(
                   "Command", "\"%1\" is no argument of this command; \"burin COMMAND --help\" lists them.")
            .arg(parts[0]);
    if (const QStringList parts = partsByText(text, "(.*?) excludes (.*)"); !parts.isEmpty())
        return QCoreApplication::translate("Command", "\"%1\" and \"%2\" can't be used together.")
            .arg(parts[0], parts[1]);
    if (const QStringList parts = partsByText(text, "(.*?) requires (.*)"); !parts.isEmpty())
        return QCoreApplication::translate("Command", "\"%1\" can only be used with \"%2\".").arg(parts[0], parts[1]);
    if (const QStringList parts = partsByText(text, "(.*?): (.*)"); !parts.isEmpty())
        return notAllowed(parts[0], {}, parts[1]);
    return QCoreApplication::translate("Command", "The arguments can't be understood (%1).").arg(text);
}

} // namespace burin
