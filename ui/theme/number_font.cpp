// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/number_font.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <QStringList>

#include <cmath>

namespace burin {

namespace {

bool hasTabularDigits(const QFont& font) {
    const QFontMetricsF metrics(font);
    const double zero = metrics.horizontalAdvance(QLatin1Char('0'));
    for (char digit = '1'; digit <= '9'; ++digit)
        if (std::abs(metrics.horizontalAdvance(QLatin1Char(digit)) - zero) > 0.01) return false;
    return true;
}

} // namespace

QFont numberFont(const QFont& base) {
    if (hasTabularDigits(base)) return base;
    for (const char* family : {"Roboto", "Noto Sans", "Open Sans", "DejaVu Sans"}) {
        if (!QFontDatabase::hasFamily(QLatin1String(family))) continue;
        QFont font = base;
        font.setFamilies(QStringList{QString::fromLatin1(family)});
        if (hasTabularDigits(font)) return font;
    }
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPointSizeF(base.pointSizeF());
    fixed.setWeight(base.weight());
    return fixed;
}

} // namespace burin
