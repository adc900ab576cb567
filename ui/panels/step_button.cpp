// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/step_button.h"

#include "ui/theme/colour.h"
#include "ui/theme/theme.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

namespace burin {

namespace {

constexpr int circleSize = 22, stepGap = 8, padding = 8;
constexpr double titleSize = 1.0, lineSize = 0.82, frameCorner = 8.0;

ColourRole roleOf(StepProgress progress) {
    switch (progress) {
    case StepProgress::missing:
        return &Palette::quietText;
    case StepProgress::ready:
        return &Palette::text;
    case StepProgress::current:
        return &Palette::accent;
    case StepProgress::objected:
        return &Palette::force;
    case StepProgress::done:
        return &Palette::inOrder;
    }
    return &Palette::text;
}

/// The state as text for screen readers.
QString wordOf(StepProgress progress) {
    switch (progress) {
    case StepProgress::missing:
        return StepButton::tr("not yet");
    case StepProgress::ready:
        return StepButton::tr("can be done");
    case StepProgress::current:
        return StepButton::tr("under way");
    case StepProgress::objected:
        return StepButton::tr("has a problem");
    case StepProgress::done:
        return StepButton::tr("done");
    }
    return {};
}

} // namespace

StepButton::StepButton(JobStep step, const QString& title, QWidget* parent) : QAbstractButton(parent), step_(step) {
    setText(title);
    setAccessibleName(title);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void StepButton::setState(const JobStepState& state, bool shown) {
    if (state.progress == state_.progress && state.line == state_.line && shown == shown_) return;
    state_ = state;
    shown_ = shown;
    const QString progress = wordOf(state.progress);
    setAccessibleDescription(state.line.isEmpty() ? progress : progress + QStringLiteral(": ") + state.line);
    update();
}

QFont StepButton::titleFont() const {
    QFont result = font();
    result.setPointSizeF(titleSize * font().pointSizeF());
    result.setWeight(QFont::DemiBold);
    return result;
}

QFont StepButton::lineFont() const {
    QFont result = font();
    result.setPointSizeF(lineSize * font().pointSizeF());
    return result;
}

QRect StepButton::textRect() const {
    return rect().adjusted(padding + circleSize + stepGap, 0, -padding, 0);
}

QSize StepButton::sizeHint() const {
    const int height = QFontMetrics(titleFont()).height() + QFontMetrics(lineFont()).height() + 2 * padding;
    return {160, height};
}

QSize StepButton::minimumSizeHint() const {
    const int title = QFontMetrics(titleFont()).horizontalAdvance(text());
    return {2 * padding + circleSize + stepGap + title, sizeHint().height()};
}

void StepButton::paintCircle(QPainter& painter, const QRectF& circle) const {
    const QColor colour = activePalette().*roleOf(state_.progress);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(circle);
    if (state_.progress == StepProgress::done) {
        const QPointF centre = circle.center();
        painter.setPen(QPen(colour, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(
            QPolygonF{centre + QPointF(-4.0, 0.5), centre + QPointF(-1.0, 3.5), centre + QPointF(4.5, -3.5)});
        return;
    }
    painter.setFont(lineFont());
    const bool objected = state_.progress == StepProgress::objected;
    painter.drawText(circle, Qt::AlignCenter,
                     objected ? QStringLiteral("!") : QString::number(static_cast<int>(step_) + 1));
}

void StepButton::paintEvent(QPaintEvent*) {
    const Palette& colours = activePalette();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    if (shown_ || underMouse() || isDown()) {
        painter.setPen(shown_ ? QPen(colours.accent, 1.0) : QPen(Qt::NoPen));
        painter.setBrush(shown_ ? mixed(colours.window, colours.accent, 0.1)
                                : mixed(colours.window, colours.text, 0.06));
        painter.drawRoundedRect(frame, frameCorner, frameCorner);
    }
    if (hasFocus()) {
        painter.setPen(QPen(colours.part, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(frame, frameCorner, frameCorner);
    }
    paintCircle(painter, QRectF(padding, 0.5 * (height() - circleSize), circleSize, circleSize));

    const QRect room = textRect();
    const QFontMetrics title(titleFont()), line(lineFont());
    const int top = (height() - title.height() - line.height()) / 2;
    painter.setFont(titleFont());
    painter.setPen(state_.progress == StepProgress::missing && !shown_ ? colours.quietText : colours.text);
    painter.drawText(QRect(room.left(), top, room.width(), title.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     title.elidedText(text(), Qt::ElideRight, room.width()));
    painter.setFont(lineFont());
    painter.setPen(colours.quietText);
    painter.drawText(QRect(room.left(), top + title.height(), room.width(), line.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, line.elidedText(state_.line, Qt::ElideRight, room.width()));
}

bool StepButton::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                           state_.line.isEmpty() ? text() : text() + QStringLiteral(": ") + state_.line, this);
        return true;
    }
    return QAbstractButton::event(event);
}

} // namespace burin
