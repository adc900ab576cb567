// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/deviation_legend.h"

#include "ui/panels/texts.h"
#include "ui/theme/number_font.h"
#include "ui/theme/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace burin {

namespace {

constexpr int bandHeight = 18, edgeGap = 9, pointerWidth = 9, barWidth = 26, markLength = 5, textGap = 4;
constexpr int barLeft = pointerWidth, textLeft = barLeft + barWidth + markLength + textGap;
constexpr int hatchStep = 6;

QColor legendColour(const DeviationColour& colour) {
    return {colour[0], colour[1], colour[2]};
}

QString signedLength(double millimetres, LengthUnit unit) {
    const QString text = shortLength(std::abs(millimetres), unit);
    return millimetres == 0.0 ? text : (millimetres > 0.0 ? QStringLiteral("+") : QStringLiteral("−")) + text;
}

} // namespace

DeviationLegend::DeviationLegend(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFont(numberFont(font()));
    setAccessibleName(tr("Scale of the deviation"));
    describe();
}

void DeviationLegend::setTolerance(const DeviationTolerance& tolerance) {
    scale_ = DeviationScale(tolerance);
    updateGeometry();
    describe();
}

void DeviationLegend::setUnit(LengthUnit unit) {
    unit_ = unit;
    describe();
}

void DeviationLegend::setPointer(std::optional<double> deviation) {
    if (deviation == pointer_) return;
    pointer_ = deviation;
    update();
}

QSize DeviationLegend::sizeHint() const {
    const int bands = static_cast<int>(scale_.marks().size()) - 1;
    return {220, bands * bandHeight + 2 * edgeGap + bandHeight + textGap};
}

double DeviationLegend::heightAt(double position) const {
    return edgeGap + (1.0 - position) * bandHeight * static_cast<double>(scale_.marks().size() - 1);
}

double DeviationLegend::heightOf(double deviation) const {
    return heightAt(scale_.positionOf(deviation));
}

void DeviationLegend::describe() {
    QStringList values;
    for (const DeviationScale::Mark& mark : scale_.marks()) values.append(signedLength(mark.deviation, unit_));
    setAccessibleDescription(values.join(QStringLiteral(", ")));
    update();
}

void DeviationLegend::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintBar(painter);
    paintMarks(painter);
    paintSides(painter);
    paintUnmeasured(painter);
    paintPointer(painter);
}

void DeviationLegend::paintBar(QPainter& painter) const {
    const double top = heightAt(1.0), bottom = heightAt(0.0);
    for (int y = static_cast<int>(top); y < static_cast<int>(bottom); ++y) {
        const double position = (bottom - y - 0.5) / (bottom - top);
        painter.fillRect(barLeft, y, barWidth, 1, legendColour(scale_.colourAt(position)));
    }
    painter.setPen(activePalette().quietText);
    painter.drawRect(barLeft, static_cast<int>(top), barWidth, static_cast<int>(bottom - top));
}

void DeviationLegend::paintMarks(QPainter& painter) const {
    const auto& marks = scale_.marks();
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const int y =
            static_cast<int>(std::lround(heightAt(static_cast<double>(i) / static_cast<double>(marks.size() - 1))));
        // The tolerance limits are drawn across the bar; other band limits are marked next to it.
        painter.setPen(
            QPen(marks[i].ofTolerance ? QColor(Qt::black) : activePalette().quietText, marks[i].ofTolerance ? 2 : 1));
        painter.drawLine(marks[i].ofTolerance ? barLeft : barLeft + barWidth, y, barLeft + barWidth, y);
        painter.setPen(QPen(activePalette().quietText, 1));
        painter.drawLine(barLeft + barWidth, y, barLeft + barWidth + markLength, y);
        painter.setPen(marks[i].ofTolerance ? activePalette().text : activePalette().quietText);
        QString text = signedLength(marks[i].deviation, unit_);
        if (i == 0) text.prepend(QStringLiteral("≤ "));
        if (i + 1 == marks.size()) text.prepend(QStringLiteral("≥ "));
        painter.drawText(QRect(textLeft, y - bandHeight / 2, width() - textLeft, bandHeight),
                         Qt::AlignLeft | Qt::AlignVCenter, text);
    }
}

void DeviationLegend::paintSides(QPainter& painter) const {
    const auto& marks = scale_.marks();
    int widest = 0;
    for (const DeviationScale::Mark& mark : marks)
        widest = std::max(widest,
                          fontMetrics().horizontalAdvance(QStringLiteral("≥ ") + signedLength(mark.deviation, unit_)));
    const int left = textLeft + widest + 2 * textGap;
    std::vector<double> borders{heightAt(0.0)};
    for (const DeviationScale::Mark& mark : marks)
        if (mark.ofTolerance) borders.push_back(heightOf(mark.deviation));
    borders.push_back(heightAt(1.0));
    const std::array<QString, 3> names{tr("too deep"), tr("within tolerance"), tr("too much left")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int bottom = static_cast<int>(borders[i]) - 3, top = static_cast<int>(borders[i + 1]) + 3;
        painter.setPen(QPen(activePalette().quietText, 1));
        painter.drawPolyline(QPolygon{{QPoint(left, top), QPoint(left + markLength, top),
                                       QPoint(left + markLength, bottom), QPoint(left, bottom)}});
        painter.setPen(activePalette().text);
        const QRect place(left + 3 * textGap, top, width() - left - 3 * textGap, bottom - top);
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, names[i]);
    }
}

void DeviationLegend::paintUnmeasured(QPainter& painter) const {
    const QRect box(barLeft, static_cast<int>(heightAt(0.0)) + edgeGap + textGap, barWidth, bandHeight - 4);
    const QColor grey = legendColour(unmeasuredColour);
    painter.fillRect(box, grey);
    painter.save();
    painter.setClipRect(box);
    painter.setPen(QPen(grey.darker(180), 2));
    for (int x = box.left() - box.height(); x < box.right(); x += hatchStep)
        painter.drawLine(x, box.bottom() + 1, x + box.height(), box.top());
    painter.restore();
    painter.setPen(activePalette().quietText);
    painter.drawText(QRect(textLeft, box.top() - 2, width() - textLeft, bandHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("not measured, or out of the tool's reach"));
}

void DeviationLegend::paintPointer(QPainter& painter) const {
    if (!pointer_) return;
    const double y = heightOf(*pointer_);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath arrow(QPointF(barLeft, y));
    arrow.lineTo(0.0, y - 5.0);
    arrow.lineTo(0.0, y + 5.0);
    arrow.closeSubpath();
    painter.fillPath(arrow, activePalette().text);
}

} // namespace burin
