// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/colour_scale.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double scaleMargin = 16.0, scaleTop = 120.0; // device-independent pixels, like all of these
constexpr double scalePadding = 8.0, barWide = 16.0, barGap = 6.0, leastHigh = 160.0;
constexpr double lineSpacing = 1.05; // of the font's height, between marks

} // namespace

void ColourScale::setPalette(const Palette& palette) {
    text_ = palette.text;
    plate_ = palette.panel;
    ratio_ = 0.0;
}

void ColourScale::set(ColourScaleContent content) {
    content_ = std::move(content);
    ratio_ = 0.0;
}

void ColourScale::setVisible(bool visible) {
    visible_ = visible;
    image_.setVisible(visible);
}

double ColourScale::place(const QSizeF& size, double ratio, double right) {
    if (!visible_) return right;
    if (ratio != ratio_) {
        ratio_ = ratio;
        draw();
    }
    const double taken = right + image_.size().width() / ratio + scaleMargin;
    image_.setPosition(QPointF(size.width() - taken, scaleTop) * ratio,
                       static_cast<int>(std::lround(size.height() * ratio)));
    return taken;
}

void ColourScale::draw() {
    const QFontMetricsF metrics(QGuiApplication::font());
    const double barHigh = std::round(
        std::max(leastHigh, lineSpacing * metrics.height() * static_cast<double>(content_.marks.size() - 1)));
    double widest = 0.0;
    for (const QString& mark : content_.marks) widest = std::max(widest, metrics.horizontalAdvance(mark));
    const QSizeF size(std::max(metrics.horizontalAdvance(content_.heading), barWide + barGap + widest) +
                          2.0 * scalePadding,
                      2.5 * metrics.height() + barHigh + 2.0 * scalePadding);
    QImage image = plateImage(size, ratio_, plate_);
    QPainter painter(&image);
    painter.setPen(text_);
    painter.drawText(QPointF(scalePadding, scalePadding + metrics.ascent()), content_.heading);
    const double top = scalePadding + 2.0 * metrics.height(), bottom = top + barHigh;
    const bool single = content_.marks.size() == 1;
    for (int row = 0; row < static_cast<int>(barHigh); ++row)
        painter.fillRect(QRectF(scalePadding, bottom - row - 1.0, barWide, 1.0),
                         content_.colours(single ? 1.0 : (row + 0.5) / barHigh));
    for (qsizetype i = 0; i < content_.marks.size(); ++i) {
        const double along = single ? 0.5 : static_cast<double>(i) / static_cast<double>(content_.marks.size() - 1);
        painter.drawText(QPointF(scalePadding + barWide + barGap,
                                 std::lerp(bottom, top, along) + 0.5 * (metrics.ascent() - metrics.descent())),
                         content_.marks[i]);
    }
    painter.end();
    image_.setImage(image);
}

} // namespace burin
