// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/quantity.h"

#include "core/base/numbers.h"
#include "core/base/units.h"

#include <QRegularExpression>

#include <array>

namespace burin {

namespace {

constexpr double radiansPerDegree = pi / 180.0;
constexpr double cubicInch = millimetresPerInch * millimetresPerInch * millimetresPerInch; // mm³

struct NamedUnit {
    Quantity quantity;
    const char* text; ///< UTF-8, lower case
    double size;
};

constexpr std::array namedUnits{
    NamedUnit{Quantity::length, "mm", 1.0},
    NamedUnit{Quantity::length, "cm", 10.0},
    NamedUnit{Quantity::length, "m", 1000.0},
    NamedUnit{Quantity::length, "µm", 0.001},
    NamedUnit{Quantity::length, "μm", 0.001}, // the Greek letter, in addition to the micro sign
    NamedUnit{Quantity::length, "um", 0.001},
    NamedUnit{Quantity::length, "in", millimetresPerInch},
    NamedUnit{Quantity::length, "inch", millimetresPerInch},
    NamedUnit{Quantity::length, "\"", millimetresPerInch},
    NamedUnit{Quantity::length, "″", millimetresPerInch},
    NamedUnit{Quantity::speed, "mm/s", 1.0},
    NamedUnit{Quantity::speed, "in/s", millimetresPerInch},
    NamedUnit{Quantity::speed, "mm/min", 1.0 / 60.0},
    NamedUnit{Quantity::speed, "in/min", millimetresPerInch / 60.0},
    NamedUnit{Quantity::time, "s", 1.0},
    NamedUnit{Quantity::time, "ms", 0.001},
    NamedUnit{Quantity::frequency, "hz", 1.0},
    NamedUnit{Quantity::angle, "°", radiansPerDegree},
    NamedUnit{Quantity::angle, "rad", 1.0},
    NamedUnit{Quantity::force, "n", 1.0},
    NamedUnit{Quantity::removalRate, "mm³/s", 1.0},
    NamedUnit{Quantity::removalRate, "cm³/min", 1000.0 / 60.0},
    NamedUnit{Quantity::removalRate, "in³/min", cubicInch / 60.0},
    NamedUnit{Quantity::ratio, "×", 1.0},
    NamedUnit{Quantity::ratio, "x", 1.0},
    NamedUnit{Quantity::feed, "mm/min", 1.0},
    NamedUnit{Quantity::feed, "m/min", 1000.0},
    NamedUnit{Quantity::feed, "mm/s", 60.0},
    NamedUnit{Quantity::feed, "in/min", millimetresPerInch},
    NamedUnit{Quantity::acceleration, "mm/s²", 1.0},
    NamedUnit{Quantity::acceleration, "m/s²", 1000.0},
    NamedUnit{Quantity::acceleration, "in/s²", millimetresPerInch},
    NamedUnit{Quantity::jerk, "mm/s³", 1.0},
    NamedUnit{Quantity::jerk, "m/s³", 1000.0},
    NamedUnit{Quantity::jerk, "in/s³", millimetresPerInch},
    NamedUnit{Quantity::rotation, "1/min", 1.0},
    NamedUnit{Quantity::rotation, "rpm", 1.0},
    NamedUnit{Quantity::power, "w", 1.0},
    NamedUnit{Quantity::power, "kw", 1000.0},
    NamedUnit{Quantity::torque, "nm", 1.0},
    NamedUnit{Quantity::torque, "n·m", 1.0},
    NamedUnit{Quantity::torque, "ncm", 0.01},
    NamedUnit{Quantity::stress, "n/mm²", 1.0},
    NamedUnit{Quantity::stress, "mpa", 1.0},
    NamedUnit{Quantity::stress, "gpa", 1000.0},
    NamedUnit{Quantity::stiffness, "n/mm", millimetresPerMetre},
    NamedUnit{Quantity::stiffness, "n/m", 1.0},
    NamedUnit{Quantity::rate, "1/s", 1.0},
};

std::optional<double> unitSize(const QString& text, Quantity quantity, LengthUnit unit) {
    if (text.isEmpty()) return displayUnit(quantity, unit).size;
    for (const NamedUnit& named : namedUnits)
        if (named.quantity == quantity && text.toLower() == QString::fromUtf8(named.text)) return named.size;
    return std::nullopt;
}

} // namespace

DisplayUnit displayUnit(Quantity quantity, LengthUnit unit) {
    const bool inch = unit == LengthUnit::inch;
    const double size = inch ? millimetresPerInch : 1.0;
    switch (quantity) {
    case Quantity::length:
        return {unitText(unit), size, inch ? inchDecimals : millimetreDecimals, true};
    case Quantity::speed:
        return {unitText(unit) + QStringLiteral("/s"), size, inch ? 3 : 2, false};
    case Quantity::time:
        return {QStringLiteral("s"), 1.0, 3, false};
    case Quantity::frequency:
        return {QStringLiteral("Hz"), 1.0, 2, false};
    case Quantity::angle:
        return {QStringLiteral("°"), radiansPerDegree, 2, false};
    case Quantity::force:
        return {QStringLiteral("N"), 1.0, 2, false};
    case Quantity::removalRate:
        return inch ? DisplayUnit{QStringLiteral("in³/min"), cubicInch / 60.0, 3, false}
                    : DisplayUnit{QStringLiteral("mm³/s"), 1.0, 2, false};
    case Quantity::ratio:
        return {QStringLiteral("×"), 1.0, 3, false};
    case Quantity::feed:
        return {unitText(unit) + QStringLiteral("/min"), size, inch ? 2 : 1, false};
    case Quantity::acceleration:
        return {unitText(unit) + QStringLiteral("/s²"), size, inch ? 2 : 1, false};
    case Quantity::jerk:
        return {unitText(unit) + QStringLiteral("/s³"), size, inch ? 2 : 1, false};
    case Quantity::rotation:
        return {QStringLiteral("1/min"), 1.0, 1, false};
    case Quantity::power:
        return {QStringLiteral("W"), 1.0, 1, false};
    case Quantity::torque:
        return {QStringLiteral("N·m"), 1.0, 4, false};
    case Quantity::stress:
        return {QStringLiteral("N/mm²"), 1.0, 1, false};
    case Quantity::stiffness:
        return {QStringLiteral("N/mm"), millimetresPerMetre, 3, false};
    case Quantity::rate:
        return {QStringLiteral("1/s"), 1.0, 1, false};
    case Quantity::count:
        return {{}, 1.0, 0, false};
    }
    return {};
}

QString quantityNumber(double value, Quantity quantity, LengthUnit unit, const QLocale& locale) {
    const DisplayUnit shown = displayUnit(quantity, unit);
    QString number = fixedNumber(value / shown.size, shown.decimals, locale);
    if (shown.allDecimals || shown.decimals == 0) return number;
    while (number.endsWith(locale.zeroDigit())) number.chop(1);
    if (number.endsWith(locale.decimalPoint())) number.chop(1);
    return number;
}

QString quantityText(double value, Quantity quantity, LengthUnit unit, const QLocale& locale) {
    const QString number = quantityNumber(value, quantity, unit, locale), text = displayUnit(quantity, unit).text;
    return text.isEmpty() ? number : number + QChar(QChar::Nbsp) + text;
}

std::optional<double> readQuantity(const QString& text, Quantity quantity, LengthUnit unit) {
    static const QRegularExpression form(
        QStringLiteral("^\\s*([-+−]?)\\s*([0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)\\s*((?:1/)?[^\\s0-9.,+−-]*)\\s*$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch()) return std::nullopt;
    const std::optional<double> size = unitSize(match.captured(3), quantity, unit);
    QString digits = match.captured(2).replace(QLatin1Char(','), QLatin1Char('.'));
    if (digits.startsWith(QLatin1Char('.'))) digits.prepend(QLatin1Char('0'));
    if (digits.endsWith(QLatin1Char('.'))) digits.chop(1);
    const std::optional<double> number = parseNumber(digits.toStdString());
    if (!size || !number) return std::nullopt;
    const bool negative = !match.captured(1).isEmpty() && match.captured(1) != QLatin1String("+");
    return (negative ? -*number : *number) * *size;
}

} // namespace burin
