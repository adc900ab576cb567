// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scale_bar.h"

#include "core/base/units.h"
#include "ui/scene/round_spacing.h"
#include "ui/theme/length_unit.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QLocale>
#include <QPainter>

#include <cmath>

namespace burin {
namespace {

constexpr double margin = 16.0, wanted = 1000.0; // device-independent pixels; the bar is about a tenth of `wanted`
constexpr double tick = 5.0, barWidth = 2.0, padding = 6.0;

} // namespace

void ScaleBar::setPalette(const Palette& palette) {
    colour_ = palette.text;
    plate_ = palette.panel;
    ratio_ = 0.0;
}

void ScaleBar::setUnit(LengthUnit unit) {
    unit_ = unit;
    ratio_ = 0.0;
}

void ScaleBar::place(const CameraView& view, const QSizeF& size, double ratio) {
    const double millimetres = unit_ == LengthUnit::inch ? millimetresPerInch : 1.0;
    const double pixel = pixelAt(view, size, view.focus) / millimetres, length = roundSpacing(wanted * pixel);
    const int pixels = static_cast<int>(std::lround(length / pixel));
    if (length != length_ || pixels != pixels_ || ratio != ratio_) {
        length_ = length;
        pixels_ = pixels;
        ratio_ = ratio;
        draw();
    }
    const double below = image_.size().height() / ratio + margin;
    image_.setPosition(QPointF(margin, size.height() - below) * ratio,
                       static_cast<int>(std::lround(size.height() * ratio)));
}

void ScaleBar::draw() {
    const QString number = QLocale().toString(length_);
    const QString text = unit_ == LengthUnit::inch
                             ? QCoreApplication::translate("burin::Viewport", "%1 in").arg(number)
                             : QCoreApplication::translate("burin::Viewport", "%1 mm").arg(number);
    const QFontMetricsF metrics(QGuiApplication::font());
    const QSizeF inner(std::max(pixels_ + 1.0, metrics.horizontalAdvance(text)), metrics.height() + tick + 2.0);
    const QSizeF size = inner + QSizeF(2.0 * padding, 2.0 * padding);
    QImage image = plateImage(size, ratio_, plate_);
    QPainter painter(&image);
    painter.setPen(QPen(colour_, barWidth));
    const double base = size.height() - padding - 0.5 * barWidth, left = padding, right = left + pixels_;
    painter.drawLine(QPointF(left, base), QPointF(right, base));
    painter.drawLine(QPointF(left, base), QPointF(left, base - tick));
    painter.drawLine(QPointF(right, base), QPointF(right, base - tick));
    painter.drawText(QPointF(padding, padding + metrics.ascent()), text);
    painter.end();
    image_.setImage(image);
}

} // namespace burin
