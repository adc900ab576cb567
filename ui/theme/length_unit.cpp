// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/length_unit.h"

#include "core/base/units.h"

#include <cmath>

namespace burin {

QString lengthNumber(double millimetres, LengthUnit unit, const QLocale& locale) {
    const int decimals = unit == LengthUnit::inch ? inchDecimals : millimetreDecimals;
    const double shown = unit == LengthUnit::inch ? millimetres / millimetresPerInch : millimetres;
    return fixedNumber(shown, decimals, locale);
}

QString lengthText(double millimetres, LengthUnit unit, const QLocale& locale) {
    return lengthNumber(millimetres, unit, locale) + QChar(QChar::Nbsp) + unitText(unit);
}

QString unitText(LengthUnit unit) {
    return unit == LengthUnit::inch ? QStringLiteral("in") : QStringLiteral("mm");
}

QString fixedNumber(double value, int decimals, const QLocale& locale) {
    QLocale plain = locale;
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    // "-0.000" would suggest a direction that doesn't exist.
    if (std::abs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0.0;
    return plain.toString(value, 'f', decimals);
}

} // namespace burin
