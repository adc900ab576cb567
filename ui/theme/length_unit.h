// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLocale>
#include <QString>

namespace burin {

/// What lengths are shown in. Inside and in files everything stays mm.
enum class LengthUnit { millimetre, inch };

inline constexpr double millimetresPerInch = 25.4;

/// "12.500 mm", "0.4921 in": fixed decimals, the locale's decimal sign (display alone, never files).
QString lengthText(double millimetres, LengthUnit unit, const QLocale& locale = QLocale());
/// The same without its unit.
QString lengthNumber(double millimetres, LengthUnit unit, const QLocale& locale = QLocale());
QString unitText(LengthUnit unit); ///< "mm", "in"

} // namespace burin
