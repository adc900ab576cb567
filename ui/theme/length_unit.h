// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLocale>
#include <QString>

namespace burin {

/// The unit in which lengths are displayed. Internally and in files all lengths are in mm.
enum class LengthUnit { millimetre, inch };

/// Number of decimals: one micrometre, and a tenth of a thou, which is the closest inch resolution to it.
inline constexpr int millimetreDecimals = 3, inchDecimals = 4;

/// "12.500 mm", "0.4921 in": fixed decimals with the locale's decimal sign (for display only, never for files). Number
/// and unit are separated by a no-break space.
QString lengthText(double millimetres, LengthUnit unit, const QLocale& locale = QLocale());
/// The same as `lengthText`, but without the unit.
QString lengthNumber(double millimetres, LengthUnit unit, const QLocale& locale = QLocale());
QString unitText(LengthUnit unit); ///< "mm", "in"

/// A number with fixed decimals, the locale's decimal sign and no group separators, never "-0".
QString fixedNumber(double value, int decimals, const QLocale& locale = QLocale());

} // namespace burin
