// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/coach/target_outline.h"

#include "ui/theme/theme.h"

#include <QPainter>

namespace burin {

namespace {

constexpr int outlineRoom = 6; // pixels around the target
constexpr double outlineWidth = 2.5, haloWidth = 6.0, outlineCorner = 9.0;
constexpr int haloStrength = 200; // of 255

} // namespace

TargetOutline::TargetOutline(QWidget* window) : QWidget(window) {
    setObjectName(QStringLiteral("coachOutline"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void TargetOutline::surround(const Pointed& pointed, QWidget& panel) {
    if (!pointed.widget || pointed.rect.isEmpty()) {
        hide();
        return;
    }
    QWidget* over = pointed.widget->window();
    if (parentWidget() != over) setParent(over);
    const QRect around = pointed.rectIn(*over).adjusted(-outlineRoom, -outlineRoom, outlineRoom, outlineRoom);
    setGeometry(around & over->rect());
    show();
    // An order that is right must stay as it is: each change repaints the target, which calls this again.
    if (over == panel.parentWidget())
        stackUnder(&panel);
    else
        raise();
}

/// Draws a line in the accent colour on a wider one in the window colour, so that one of the two contrasts with any
/// background.
void TargetOutline::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor halo = activePalette().window;
    halo.setAlpha(haloStrength);
    const double inset = haloWidth / 2.0;
    const QRectF line = QRectF(rect()).adjusted(inset, inset, -inset, -inset);
    for (const auto& [colour, width] : {std::pair{halo, haloWidth}, {activePalette().accent, outlineWidth}}) {
        painter.setPen(QPen(colour, width));
        painter.drawRoundedRect(line, outlineCorner, outlineCorner);
    }
}

} // namespace burin
