// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/meter_bar.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr int barHeight = 4;

} // namespace

MeterBar::MeterBar(ColourRole role, QWidget* parent) : QWidget(parent), role_(role) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFixedHeight(barHeight);
}

void MeterBar::setShare(double share) {
    const double next = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
    if (next == share_) return;
    share_ = next;
    const QString percent = QLocale().toString(100.0 * share_, 'f', 0) + QStringLiteral(" %");
    if (percent != accessibleDescription()) setAccessibleDescription(percent);
    update();
}

void MeterBar::setRole(ColourRole role) {
    if (role == role_) return;
    role_ = role;
    update();
}

QSize MeterBar::sizeHint() const {
    return {64, barHeight};
}

void MeterBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const double corner = 0.5 * barHeight;
    painter.setBrush(activePalette().field);
    painter.drawRoundedRect(QRectF(rect()), corner, corner);
    if (share_ <= 0.0) return;
    painter.setBrush(activePalette().*role_);
    painter.drawRoundedRect(QRectF(0.0, 0.0, std::max(share_ * width(), 1.0 * barHeight), barHeight), corner, corner);
}

} // namespace burin
