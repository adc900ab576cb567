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

constexpr double margin = 16.0, wanted = 1000.0; // device-independent pixels; a tenth of `wanted`, about
constexpr double tick = 5.0;

} // namespace

void ScaleBar::setPalette(const Palette& palette) {
    colour_ = palette.quietText;
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
    const QSizeF size(std::max(pixels_ + 2.0, metrics.horizontalAdvance(text) + 2.0), metrics.height() + tick + 3.0);
    QImage image((size * ratio_).toSize(), QImage::Format_RGBA8888);
    image.setDevicePixelRatio(ratio_);
    QColor empty = colour_;
    empty.setAlpha(0);
    image.fill(empty);
    QPainter painter(&image);
    painter.setPen(QPen(colour_, 1.0));
    const double base = size.height() - 1.5, left = 0.5, right = left + pixels_;
    painter.drawLine(QPointF(left, base), QPointF(right, base));
    painter.drawLine(QPointF(left, base), QPointF(left, base - tick));
    painter.drawLine(QPointF(right, base), QPointF(right, base - tick));
    painter.drawText(QPointF(1.0, metrics.ascent()), text);
    painter.end();
    image_.setImage(image);
}

} // namespace burin
