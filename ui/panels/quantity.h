// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"

#include <optional>

namespace burin {

/// What a number on a panel measures. Inside: mm, mm/s, s, Hz, rad, N, mm³/s, 1; mm/min, mm/s², mm/s³, 1/min, W, N m,
/// 1/s.
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
    rate, ///< of blocks
    count
};

/// How a quantity is shown.
struct DisplayUnit {
    QString text;            ///< "mm", "in/s"
    double size = 1.0;       ///< of one such unit, in the inner unit
    int decimals = 3;        ///< at most
    bool allDecimals = true; ///< trailing zeros stand, so that lengths keep their places
};
DisplayUnit displayUnit(Quantity quantity, LengthUnit unit);

/// The number alone, as `displayUnit` says.
QString quantityNumber(double value, Quantity quantity, LengthUnit unit, const QLocale& locale = QLocale());
/// "60 mm/s"
QString quantityText(double value, Quantity quantity, LengthUnit unit, const QLocale& locale = QLocale());

/// What a hand typed: a number with a decimal point or comma, whatever the locale, and at will a unit of the quantity
/// ("0.5in", "12,5 mm", "80 µm"); without one, `unit` counts. Nothing when it is no such text. In the inner unit.
std::optional<double> readQuantity(const QString& text, Quantity quantity, LengthUnit unit);

} // namespace burin
