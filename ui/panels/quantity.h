// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"

#include <optional>

namespace burin {

/// The quantity that a number on a panel measures. Internal units: mm, mm/s, s, Hz, rad, N, mm³/s, 1; mm/min, mm/s²,
/// mm/s³, 1/min, W, N m, 1/s.
enum class Quantity {
    length,
    speed,
    time,
    frequency,
    angle,
    force,
    removalRate,
    ratio,
    feed,
    acceleration,
    jerk,
    rotation,
    power,
    torque,
    stress,
    stiffness, ///< N/m, shown as N/mm
    rate,      ///< of blocks
    count
};

/// The display unit of a quantity.
struct DisplayUnit {
    QString text;            ///< "mm", "in/s"
    double size = 1.0;       ///< of one such unit, in the internal unit
    int decimals = 3;        ///< maximum number of decimals
    bool allDecimals = true; ///< whether trailing zeros are shown, so that decimals stay aligned
};
DisplayUnit displayUnit(Quantity quantity, LengthUnit unit);

/// The number without its unit, in the form given by `displayUnit`.
QString quantityNumber(double value, Quantity quantity, LengthUnit unit, const QLocale& locale = QLocale());
/// "60 mm/s"
QString quantityText(double value, Quantity quantity, LengthUnit unit, const QLocale& locale = QLocale());

/// Parses typed text: a number with a decimal point or comma, regardless of the locale, optionally followed by a unit
/// of the quantity ("0.5in", "12,5 mm", "80 µm"); without one, `unit` applies. Returns the value in the internal unit,
/// or std::nullopt if the text is not of this form.
std::optional<double> readQuantity(const QString& text, Quantity quantity, LengthUnit unit);

} // namespace burin
