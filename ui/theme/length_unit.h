// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLocale>
#include <QString>

namespace burin {

/// What lengths are shown in. Inside and in files everything stays mm.
enum class LengthUnit { millimetre, inch };

/// Digits behind the decimal sign: a micrometre, and the tenth of a thou that is nearest to it.
inline constexpr int millimetreDecimals = 3, inchDecimals = 4;

/// "12.500 mm", "0.4921 in": fixed decimals, the locale's decimal sign (display alone, never files). Between number and
/// unit stands a no-break space.
QString lengthText(double millimetres, LengthUnit unit, const QLocale& locale = QLocale());
/// The same without its unit.
QString lengthNumber(double millimetres, LengthUnit unit, const QLocale& locale = QLocale());
QString unitText(LengthUnit unit); ///< "mm", "in"

/// A number with fixed decimals, the locale's decimal sign and no group separators, never "-0".
QString fixedNumber(double value, int decimals, const QLocale& locale = QLocale());

} // namespace burin
